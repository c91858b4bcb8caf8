// The keys of a mechanism that picks are to lead to: what is given is fixed, all else is searched.
#include "nacre/scene/readers/free_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "nacre/base/text.h"
#include "nacre/scene/readers/index_keys.h"

namespace nacre {
const Table* range_of(const Table& table, std::string_view key, const Value& value) {
    if (!std::holds_alternative<std::shared_ptr<Table>>(value.data)) return nullptr;
    const Table& sub = table.checked_table(key, value);
    return sub.find("from") != nullptr || sub.find("to") != nullptr ? &sub : nullptr;
}

bool refuse_range(const Table& table, std::string_view key, const Value& value) {
    const Table* range = range_of(table, key, value);
    if (range == nullptr) return false;
    for (const Table::Entry& entry : range->entries()) entry.read = true;
    table.note(value.where, "from and to are the bounds of a search, and nothing searches for " + std::string(key) +
                                " here; give one value, or picks that the search is to meet");
    return true;
}

FreeNumber& FreeReader::leave_free(std::string name, const FreeRange& range,
                                   const std::function<void(Mechanism&, double)>& set) {
    search_.free.push_back({std::move(name), range.low, range.high, range.scale, set});
    return search_.free.back();
}

void FreeReader::add(std::string_view key, const FreeRange& range, const std::function<void(Mechanism&, double)>& set) {
    // Until it is found: whatever looks at the mechanism meanwhile sees something allowed.
    set(search_.start, leave_free(std::string(key), range, set).at(0.5));
}

FreeRange FreeReader::bounds(std::string_view key, const Table& range, const Allowed& allowed, FreeScale scale) const {
    FreeRange bounds{range.number("from", allowed), range.number("to", allowed), scale};
    range.expect_all_read();
    if (!range.is_good()) return {bounds.low, bounds.low, scale};
    if (bounds.low > bounds.high) {
        table_.note(range.where(), std::string(key) + " runs from " + number_text(bounds.low) + " down to " +
                                       number_text(bounds.high) + "; give the smaller number first");
    }
    if (scale == FreeScale::whole && (bounds.low != std::round(bounds.low) || bounds.high != std::round(bounds.high)))
        table_.note(range.where(), std::string(key) + " is a whole number; give whole numbers for from and to");
    if (scale == FreeScale::ratio && !(bounds.low > 0.0)) bounds.scale = FreeScale::even;
    return bounds;
}

void FreeReader::number(std::string_view key, const Allowed& allowed, const FreeRange& usual,
                        const std::function<void(Mechanism&, double)>& set) {
    const Value* value = table_.find(key);
    const bool is_thickness = allowed == allowed_thickness;
    if (value == nullptr) {
        add(key, usual, set);
    } else if (const Table* range = range_of(table_, key, *value)) {
        add(key, bounds(key, *range, allowed, usual.scale), set);
    } else {
        const double given = table_.checked_number(key, *value, allowed);
        if (is_thickness) warn_of_thin_layer(table_, key, *value, given);
        set(search_.start, given);
        return;
    }
    search_.free.back().is_thickness = is_thickness;
}

void FreeReader::whole_number(std::string_view key, const Allowed& allowed, const FreeRange& usual,
                              const std::function<void(Mechanism&, int)>& set) {
    const auto set_rounded = [set](Mechanism& mechanism, double value) {
        set(mechanism, static_cast<int>(std::lround(value)));
    };
    const Value* value = table_.find(key);
    if (value == nullptr) {
        add(key, usual, set_rounded);
    } else if (const Table* range = range_of(table_, key, *value)) {
        add(key, bounds(key, *range, allowed, FreeScale::whole), set_rounded);
    } else {
        set(search_.start, table_.checked_integer(key, *value, allowed));
    }
}

void FreeReader::index(std::string_view key, const FreeRange& usual,
                       const std::function<void(Mechanism&, const Index&)>& set) {
    const auto set_number = [set](Mechanism& mechanism, double n) { set(mechanism, Index(n)); };
    const Value* value = table_.find(key);
    if (value == nullptr) {
        add(key, usual, set_number);
    } else if (const Table* range = range_of(table_, key, *value)) {
        add(key, bounds(key, *range, allowed_n, usual.scale), set_number);
    } else {
        set(search_.start, index_.read(table_, key, *value));
        return;
    }
    search_.free.back().set_index = set;
}

void FreeReader::exchange(std::initializer_list<std::pair<std::string_view, std::string_view>> keys) {
    const std::vector<FreeNumber>& free = search_.free;
    const auto place_of = [&](std::string_view key) {
        const auto is_it = [&](const FreeNumber& number) { return number.name == key; };
        return static_cast<std::size_t>(std::find_if(free.begin(), free.end(), is_it) - free.begin());
    };
    FreeExchange exchange;
    for (const auto& [one, other] : keys) {
        const std::size_t a = place_of(one), b = place_of(other);
        if (a < free.size() && b < free.size()) exchange.emplace_back(a, b);
    }
    if (!exchange.empty()) search_.exchanges.push_back(std::move(exchange));
}

}  // namespace nacre
