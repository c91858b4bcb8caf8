#include "nacre/scene/table.h"

#include <algorithm>
#include <cmath>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/key_names.h"

namespace nacre {
namespace {

constexpr std::size_t longest_text = 4096;  // the longest path of Linux

std::string interval_text(const Allowed& allowed) {
    std::string text = "[" + limit_text(allowed.low) + ", " + limit_text(allowed.high) + "]";
    if (!allowed.unit.empty()) text += " " + std::string(allowed.unit);
    return text;
}

// NaN if it is not a number.
double number_in(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole);
    if (const auto* real = std::get_if<double>(&value.data)) return *real;
    return std::nan("");
}

// In place of a mistake.
double allowed_near(double number, const Allowed& allowed) {
    return std::isnan(number) ? allowed.low : std::clamp(number, allowed.low, allowed.high);
}

}  // namespace

std::string_view Value::kind() const {
    constexpr std::string_view kinds[] = {"a boolean", "a whole number", "a number", "a string", "an array", "a table"};
    return kinds[data.index()];
}

std::string Value::text() const {
    struct Text {
        std::string operator()(bool value) const { return value ? "true" : "false"; }
        std::string operator()(std::int64_t value) const { return std::to_string(value); }
        std::string operator()(double value) const { return number_text(value); }
        std::string operator()(const std::string& value) const { return in_quotes(value); }
        std::string operator()(const Array&) const { return "[...]"; }
        std::string operator()(const std::shared_ptr<Table>&) const { return "{...}"; }
    };
    return std::visit(Text{}, data);
}

void Table::add(std::string key, Where key_where, Value value) {
    const auto [known, is_new] = index_.try_emplace(key, entries_.size());
    if (!is_new) {
        fail(key_where, key + " is already given at " + entries_[known->second].key_where.text() + "; give it once");
    }
    entries_.push_back({std::move(key), std::move(key_where), std::move(value), false});
}

void Table::set(std::string key, Where key_where, Value value) {
    Value* const present = to_change(key);
    if (present == nullptr) {
        add(std::move(key), std::move(key_where), std::move(value));
    } else {
        *present = std::move(value);
    }
}

Value* Table::to_change(std::string_view key) {
    if (const auto exact = index_.find(key); exact != index_.end()) return &entries_[exact->second].value;
    const auto like =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return is_same_key(entry.key, key); });
    return like == entries_.end() ? nullptr : &like->value;
}

const Table::Entry* Table::entry_of(std::string_view key) const {
    auto found = index_.find(key);
    const std::string american = american_spelling(key);
    if (found == index_.end() && !american.empty()) found = index_.find(american);
    return found == index_.end() ? nullptr : &entries_[found->second];
}

void Table::know(std::string_view key) const {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
}

const Value* Table::find(std::string_view key) const {
    know(key);
    const Entry* entry = entry_of(key);
    if (entry == nullptr) return nullptr;
    entry->read = true;
    return &entry->value;
}

double Table::number(std::string_view key, const Allowed& allowed) const {
    if (const Value* value = find(key)) return checked_number(key, *value, allowed);
    note_missing(key);
    return allowed.low;
}

double Table::number_or(std::string_view key, const Allowed& allowed, double otherwise) const {
    const Value* value = find(key);
    return value == nullptr ? otherwise : checked_number(key, *value, allowed);
}

int Table::integer_or(std::string_view key, const Allowed& allowed, int otherwise) const {
    const Value* value = find(key);
    return value == nullptr ? otherwise : checked_integer(key, *value, allowed);
}

std::string Table::text(std::string_view key) const {
    const Value* value = find(key);
    if (value == nullptr) fail_missing(key);
    return checked_text(key, *value);
}

std::string Table::text_or(std::string_view key, std::string_view otherwise) const {
    const Value* value = find(key);
    return value == nullptr ? std::string(otherwise) : checked_text(key, *value);
}

std::vector<std::string> Table::texts(std::string_view key) const {
    const Value* value = find(key);
    if (value == nullptr) return {};
    if (std::holds_alternative<std::string>(value->data)) return {checked_text(key, *value)};
    std::vector<std::string> result;
    for (const Value& element : checked_array(key, *value)) result.push_back(checked_text(key, element));
    return result;
}

const Table* Table::table(std::string_view key) const {
    const Value* value = find(key);
    return value == nullptr ? nullptr : &checked_table(key, *value);
}

std::string Table::number_mistake(std::string_view key, const Value& value, const Allowed& allowed,
                                  bool is_whole) const {
    const bool is_integer = std::holds_alternative<std::int64_t>(value.data);
    if (is_whole && !is_integer) return type_message(key, value, "a whole number");
    if (!is_integer && !std::holds_alternative<double>(value.data)) return type_message(key, value, "a number");
    const double number = number_in(value);
    // Written so that NaN fails too.
    if (number >= allowed.low && number <= allowed.high) return {};
    const std::string_view complaint = std::isfinite(number) ? "is out of range" : "is not a finite number";
    return std::string(key) + " = " + value.text() + " " + std::string(complaint) + "; allowed " +
           interval_text(allowed);
}

double Table::checked_number(std::string_view key, const Value& value, const Allowed& allowed) const {
    const std::string mistake = number_mistake(key, value, allowed, false);
    if (!mistake.empty()) note(value.where, mistake);
    return allowed_near(number_in(value), allowed);
}

int Table::checked_integer(std::string_view key, const Value& value, const Allowed& allowed) const {
    const std::string mistake = number_mistake(key, value, allowed, true);
    if (!mistake.empty()) note(value.where, mistake);
    return static_cast<int>(allowed_near(number_in(value), allowed));
}

std::vector<double> Table::checked_numbers(std::string_view key, const Value& value, const Allowed& allowed) const {
    std::vector<double> numbers;
    for (const Value& element : checked_array(key, value)) {
        const std::string mistake = number_mistake(key, element, allowed, false);
        if (!mistake.empty()) fail(element.where, mistake);
        numbers.push_back(number_in(element));
    }
    return numbers;
}

const std::string& Table::checked_text(std::string_view key, const Value& value) const {
    const auto* text = std::get_if<std::string>(&value.data);
    if (text == nullptr) fail(value.where, type_message(key, value, "a string"));
    // Paths end at a zero, terminals obey escape codes, and a message is one line.
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    if (text->size() > longest_text || std::any_of(text->begin(), text->end(), is_control)) {
        fail(value.where, std::string(key) + " is " + std::to_string(text->size()) + " bytes" +
                              (text->size() > longest_text ? "" : " with control characters among them") +
                              "; give plain text of up to " + std::to_string(longest_text) + " bytes");
    }
    return *text;
}

const Value::Array& Table::checked_array(std::string_view key, const Value& value) const {
    const auto* array = std::get_if<Value::Array>(&value.data);
    if (array == nullptr) fail(value.where, type_message(key, value, "an array"));
    return *array;
}

const Table& Table::checked_table(std::string_view key, const Value& value) const {
    const auto* table = std::get_if<std::shared_ptr<Table>>(&value.data);
    if (table == nullptr) fail(value.where, type_message(key, value, "a table"));
    return **table;
}

}  // namespace nacre
