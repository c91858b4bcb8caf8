// How a table says what is wrong in it.
#include <algorithm>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "nacre/base/names.h"
#include "nacre/scene/key_names.h"
#include "nacre/scene/table.h"

namespace nacre {
namespace {

// Calls visit(table) for every table in a value.
template <typename Visit>
void for_each_table(const Value& value, const Visit& visit) {
    if (const auto* table = std::get_if<std::shared_ptr<Table>>(&value.data)) {
        visit(**table);
    } else if (const auto* array = std::get_if<Value::Array>(&value.data)) {
        for (const Value& element : *array) for_each_table(element, visit);
    }
}

}  // namespace

std::string Table::message(const Where& where, std::string_view text) const {
    const std::string heading = path_.empty() ? "" : " [" + path_ + "]";
    return where.text() + heading + ": " + std::string(text);
}

std::string Table::type_message(std::string_view key, const Value& value, std::string_view wanted) const {
    return std::string(key) + " = " + value.text() + " is " + std::string(value.kind()) + "; give " +
           std::string(wanted);
}

void Table::note(const Where& where, std::string_view text) const {
    mistakes_.push_back({where, message(where, text)});
}

void Table::note(const Error& error, const Where& where) const {
    const auto* placed = dynamic_cast<const SceneError*>(&error);
    mistakes_.push_back({placed != nullptr ? placed->where() : where, error.what()});
}

void Table::warn(const Where& where, std::string_view text) const {
    warnings_.push_back({where, message(where, text)});
}

void Table::note_at(std::string_view key, std::string_view text) const {
    const Entry* entry = entry_of(key);
    note(entry == nullptr ? where_ : entry->value.where, text);
}

void Table::note_missing(std::string_view key, std::string_view what_is_allowed) const {
    know(key);
    missing_.push_back({std::string(key), std::string(key) + " is missing; " + std::string(what_is_allowed)});
}

void Table::fail(const Where& where, std::string_view text) const {
    throw SceneError(where, message(where, text));
}

void Table::fail_at(std::string_view key, std::string_view text) const {
    const Entry* entry = entry_of(key);
    fail(entry == nullptr ? where_ : entry->value.where, text);
}

const Table::Entry* Table::misspelling_of(std::string_view key) const {
    const std::vector<std::string> known{std::string(key)};
    for (const Entry& entry : entries_) {
        if (!entry.read && !meant_key(entry.key, known).empty()) return &entry;
    }
    return nullptr;
}

void Table::fail_missing(std::string_view key, std::string_view what_is_allowed) const {
    know(key);
    // A misspelt key is the likelier mistake, and has a place.
    if (const Entry* entry = misspelling_of(key)) {
        entry->read = true;
        fail(entry->key_where, "unknown key " + in_quotes(entry->key) + "; did you mean " + std::string(key) + "?");
    }
    fail(where_, std::string(key) + " is missing; " + std::string(what_is_allowed));
}

void Table::note_unknown(const Entry& entry) const {
    for (const std::string& key : asked_) {
        if (!is_same_key(key, entry.key)) continue;
        note(entry.key_where, entry.key + " and " + key + " are the same key, and both are given; remove one of them");
        return;
    }
    // A key that is missing is meant rather than one that is given as well.
    std::vector<std::string> missing;
    for (const Missing& one : missing_) missing.push_back(one.key);
    std::string meant = meant_key(entry.key, missing);
    if (meant.empty()) meant = meant_key(entry.key, asked_);
    std::erase_if(missing_, [&](const Missing& one) { return one.key == meant; });
    std::string text = "unknown key " + in_quotes(entry.key);
    if (!meant.empty()) {
        text += "; did you mean " + meant + "?";
    } else if (!asked_.empty()) {
        text += "; known: " + comma_separated(asked_);
    }
    note(entry.key_where, text);
}

void Table::expect_all_read() const {
    Where last = where_;
    for (const Entry& entry : entries_) {
        if (entry.read) continue;
        note_unknown(entry);
        last = entry.key_where;
    }
    // Behind the unknown keys, which may be the reason.
    for (const Missing& missing : missing_) mistakes_.push_back({last, message(where_, missing.message)});
    missing_.clear();
}

bool Table::is_good() const {
    bool good = mistakes_.empty() && missing_.empty();
    for (const Entry& entry : entries_) {
        for_each_table(entry.value, [&](const Table& table) { good = good && table.is_good(); });
    }
    return good;
}

void Table::collect_mistakes(std::vector<Mistake>& mistakes) const {
    mistakes.insert(mistakes.end(), mistakes_.begin(), mistakes_.end());
    for (const Missing& missing : missing_) mistakes.push_back({where_, message(where_, missing.message)});
    for (const Entry& entry : entries_)
        for_each_table(entry.value, [&](const Table& table) { table.collect_mistakes(mistakes); });
}

void Table::collect_warnings(std::vector<Mistake>& warnings) const {
    warnings.insert(warnings.end(), warnings_.begin(), warnings_.end());
    for (const Entry& entry : entries_)
        for_each_table(entry.value, [&](const Table& table) { table.collect_warnings(warnings); });
}

}  // namespace nacre
