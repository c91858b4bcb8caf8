#include "nacre/scene/readers/free_reader.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/readers/mechanism_readers.h"
#include "nacre/scene/readers/pick_reader.h"

namespace nacre {
namespace {

constexpr Allowed allowed_angle{0.0, 90.0, "degrees"};
constexpr Allowed allowed_u{0.0, 2.0};
constexpr Allowed allowed_weight{1e-6, 1e6};
constexpr std::size_t most_wanted = 100;

PickedColour read_band(const Table& pick, const PickReaders& readers) {
    if (pick.find("peak_nm") == nullptr)
        pick.fail_missing("colour", "give \"#rrggbb\", [r, g, b], or a band: peak_nm, width_nm, height");
    const Lobe lobe = read_lobe(pick);
    PickedColour picked;
    picked.text = "a band of " + number_text(lobe.peak_nm) + " nm, " + number_text(lobe.width_nm) + " nm wide, " +
                  number_text(lobe.height) + " high";
    picked.where = pick.where();
    picked.colour = readers.lobe_colour(lobe);
    return picked;
}

Geometry read_place(const Table& pick, Quantity quantity, double& angle_deg) {
    if (quantity != Quantity::grating_u) {
        angle_deg = pick.number("angle_deg", allowed_angle);
        return Incidence::from_degrees(angle_deg);
    }
    const Value* u = pick.find("grating_u");
    const Value* angle = pick.find("angle_deg");
    if (u != nullptr && angle != nullptr)
        pick.fail(u->where, "angle_deg and grating_u both say where the colour is seen; leave one of them out");
    if (u == nullptr) {
        // Light along the normal.
        angle_deg = pick.number("angle_deg", allowed_angle);
        return Geometry::from_grating_u(std::sin(angle_deg * std::numbers::pi / 180.0));
    }
    const double value = pick.checked_number("grating_u", *u, allowed_u);
    angle_deg = std::asin(std::min(value, 1.0)) * 180.0 / std::numbers::pi;
    return Geometry::from_grating_u(value);
}

// { measured = FILE }: the colours of spectra at their angles. Of many, as many as a search can take.
void read_measured_colours(const Table& table, const SceneContext& context, MechanismSearch& search,
                           std::vector<PickedColour>& picked) {
    constexpr std::size_t most_measured = 16;
    const std::string file = table.text("measured");
    table.expect_all_read();
    const Where where = table.find("measured")->where;
    if (quantity_of(search.start) != Quantity::incidence)
        table.fail(where, "measured spectra are of light that is reflected as by a mirror, and a grating's is not");
    const MeasuredSpectra spectra = context.read_spectra(file, where);
    const std::size_t angles = spectra.angle_deg.size();
    const std::size_t taken = std::min(angles, most_measured);
    for (std::size_t i = 0; i < taken; ++i) {
        const std::size_t angle = taken == 1 ? 0 : (i * (angles - 1) + (taken - 1) / 2) / (taken - 1);
        PickedColour one;
        one.pick = i;
        one.angle_deg = spectra.angle_deg[angle];
        one.text = "measured";
        one.mechanism = mechanism_name(search.start);
        one.where = where;
        one.colour = context.picks.measured_colour(spectra, one.angle_deg);
        search.wanted.push_back({Incidence::from_degrees(one.angle_deg), one.colour, 1.0});
        picked.push_back(std::move(one));
    }
}

}  // namespace

const Table* range_of(const Table& table, std::string_view key, const Value& value) {
    if (!std::holds_alternative<std::shared_ptr<Table>>(value.data)) return nullptr;
    const Table& sub = table.checked_table(key, value);
    return sub.find("from") != nullptr || sub.find("to") != nullptr ? &sub : nullptr;
}

void FreeReader::add(std::string_view key, const FreeRange& range, const std::function<void(Mechanism&, double)>& set) {
    search_.free.push_back({std::string(key), range.low, range.high, range.scale, set});
    // Until it is found: whatever looks at the mechanism meanwhile sees something allowed.
    set(search_.start, search_.free.back().at(0.5));
}

FreeRange FreeReader::bounds(std::string_view key, const Table& range, const Allowed& allowed, FreeScale scale) const {
    FreeRange bounds{range.number("from", allowed), range.number("to", allowed), scale};
    range.expect_all_read();
    if (bounds.low > bounds.high) {
        table_.fail(range.where(), std::string(key) + " runs from " + number_text(bounds.low) + " down to " +
                                       number_text(bounds.high) + "; give the smaller number first");
    }
    if (scale == FreeScale::whole && (bounds.low != std::round(bounds.low) || bounds.high != std::round(bounds.high)))
        table_.fail(range.where(), std::string(key) + " is a whole number; so have to be from and to");
    if (scale == FreeScale::ratio && !(bounds.low > 0.0)) bounds.scale = FreeScale::even;
    return bounds;
}

void FreeReader::number(std::string_view key, const Allowed& allowed, const FreeRange& usual,
                        const std::function<void(Mechanism&, double)>& set) {
    const Value* value = table_.find(key);
    if (value == nullptr) {
        add(key, usual, set);
    } else if (const Table* range = range_of(table_, key, *value)) {
        add(key, bounds(key, *range, allowed, usual.scale), set);
    } else {
        set(search_.start, table_.checked_number(key, *value, allowed));
    }
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

void read_wanted_colours(const Table& table, const SceneContext& context, MechanismSearch& search,
                         std::vector<PickedColour>& picked) {
    const Value* picks = table.find("picks");
    if (std::holds_alternative<std::shared_ptr<Table>>(picks->data)) {
        read_measured_colours(table.checked_table("picks", *picks), context, search, picked);
        return;
    }
    const Value::Array& list = table.checked_array("picks", *picks);
    if (list.empty() || list.size() > most_wanted) {
        table.fail(picks->where, "picks has " + std::to_string(list.size()) + " entries; allowed 1 to " +
                                     std::to_string(most_wanted));
    }
    const Quantity quantity = quantity_of(search.start);
    for (const Value& element : list) {
        const Table& pick = table.checked_table("picks", element);
        double angle_deg = 0.0;
        const Geometry place = read_place(pick, quantity, angle_deg);
        const auto colour = read_picked_colour(pick, context.picks.colour);
        PickedColour one = colour ? *colour : read_band(pick, context.picks);
        one.pick = picked.size();
        one.angle_deg = angle_deg;
        one.mechanism = mechanism_name(search.start);
        one.weight = pick.number_or("weight", allowed_weight, 1.0);
        pick.expect_all_read();
        search.wanted.push_back({place, one.colour, one.weight});
        picked.push_back(std::move(one));
    }
}

Mechanism find_mechanism(const Table& table, const SceneContext& context, MechanismSearch search) {
    const auto refuse = [&](std::string_view key, const std::string& why) {
        table.fail_at(key, std::string(key) + " and picks: " + why + "; leave one of them out");
    };
    if (search.start.effects.tilt_deg > 0.0)
        refuse("tilt_deg", "picks are met by even surfaces, and facets blur what was met");
    if (search.start.effects.both_polarisations)
        refuse("polarisation", "picks are of one colour, and both polarisations have one each");
    std::vector<PickedColour> picked;
    read_wanted_colours(table, context, search, picked);
    if (!context.find_mechanisms)
        throw Error(table.where().text() + ": picks of a " + std::string(mechanism_name(search.start)) +
                    " need a search, and there is none here");
    const std::vector<FoundMechanism> found = context.find_mechanisms(search);
    const FoundMechanism& best = found.front();
    for (PickedColour& one : picked) {
        one.reached = best.reached[one.pick];
        one.de00 = best.de00[one.pick];
        one.is_searched = !search.free.empty();
        context.note_picked(one);
    }
    context.note_found(search, found);
    return best.mechanism;
}

}  // namespace nacre
