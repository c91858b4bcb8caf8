#include "nacre/scene/table.h"

#include <algorithm>
#include <cmath>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

constexpr std::size_t longest_text = 4096;

std::string interval_text(const Allowed& allowed) {
    std::string text = "[" + limit_text(allowed.low) + ", " + limit_text(allowed.high) + "]";
    if (!allowed.unit.empty()) text += " " + std::string(allowed.unit);
    return text;
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

void Table::know(std::string_view key) const {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
}

const Value* Table::find(std::string_view key) const {
    know(key);
    const auto found = index_.find(key);
    if (found == index_.end()) return nullptr;
    const Entry& entry = entries_[found->second];
    entry.read = true;
    return &entry.value;
}

double Table::number(std::string_view key, const Allowed& allowed) const {
    const Value* value = find(key);
    if (value == nullptr) fail_missing(key, "it has no default");
    return checked_number(key, *value, allowed);
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
    if (value == nullptr) fail_missing(key, "it has no default");
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

double Table::checked_number(std::string_view key, const Value& value, const Allowed& allowed) const {
    double number = 0.0;
    if (const auto* whole = std::get_if<std::int64_t>(&value.data)) {
        number = static_cast<double>(*whole);
    } else if (const auto* real = std::get_if<double>(&value.data)) {
        number = *real;
    } else {
        fail_type(key, value, "a number");
    }
    // Written so that NaN fails too.
    if (!(number >= allowed.low && number <= allowed.high)) {
        const std::string_view complaint = std::isfinite(number) ? "is out of range" : "is not a finite number";
        fail(value.where, std::string(key) + " = " + value.text() + " " + std::string(complaint) + "; allowed " +
                              interval_text(allowed));
    }
    return number;
}

int Table::checked_integer(std::string_view key, const Value& value, const Allowed& allowed) const {
    if (!std::holds_alternative<std::int64_t>(value.data)) fail_type(key, value, "a whole number");
    return static_cast<int>(checked_number(key, value, allowed));
}

const std::string& Table::checked_text(std::string_view key, const Value& value) const {
    const auto* text = std::get_if<std::string>(&value.data);
    if (text == nullptr) fail_type(key, value, "a string");
    // Paths end at a zero, terminals obey escape codes, and a message is one line.
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    if (text->size() > longest_text || std::any_of(text->begin(), text->end(), is_control)) {
        fail(value.where, std::string(key) + " is " + std::to_string(text->size()) + " bytes" +
                              (text->size() > longest_text ? "" : " with control characters among them") +
                              "; allowed is plain text of up to " + std::to_string(longest_text) + " bytes");
    }
    return *text;
}

const Value::Array& Table::checked_array(std::string_view key, const Value& value) const {
    const auto* array = std::get_if<Value::Array>(&value.data);
    if (array == nullptr) fail_type(key, value, "an array");
    return *array;
}

const Table& Table::checked_table(std::string_view key, const Value& value) const {
    const auto* table = std::get_if<std::shared_ptr<Table>>(&value.data);
    if (table == nullptr) fail_type(key, value, "a table");
    return **table;
}

void Table::expect_all_read() const {
    for (const Entry& entry : entries_) {
        if (entry.read) continue;
        std::string message = "unknown key " + in_quotes(entry.key);
        if (!asked_.empty()) message += "; known: " + comma_separated(asked_);
        fail(entry.key_where, message);
    }
}

void Table::fail(const Where& where, std::string_view message) const {
    const std::string heading = path_.empty() ? "" : " [" + path_ + "]";
    throw Error(where.text() + heading + ": " + std::string(message));
}

void Table::fail_at(std::string_view key, std::string_view message) const {
    const auto found = index_.find(key);
    fail(found == index_.end() ? where_ : entries_[found->second].value.where, message);
}

void Table::fail_type(std::string_view key, const Value& value, std::string_view wanted) const {
    fail(value.where, std::string(key) + " = " + value.text() + " is " + std::string(value.kind()) + "; give " +
                          std::string(wanted));
}

void Table::fail_missing(std::string_view key, std::string_view what_is_allowed) const {
    // A misspelt key is the likelier mistake, and has a place.
    std::vector<std::string> unread;
    for (const Entry& entry : entries_) {
        if (!entry.read) unread.push_back(entry.key);
    }
    for (const std::string& candidate : nearest_names(key, unread, 1)) {
        fail(entries_[index_.at(candidate)].key_where,
             "unknown key " + in_quotes(candidate) + "; did you mean " + std::string(key) + "?");
    }
    fail(where_, std::string(key) + " is missing; " + std::string(what_is_allowed));
}

}  // namespace nacre
