#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nacre/base/where.h"

namespace nacre {

class Table;

/// One value of a scene, with its place.
struct Value {
    using Array = std::vector<Value>;
    std::variant<bool, std::int64_t, double, std::string, Array, std::shared_ptr<Table>> data;
    Where where;

    /// "a number", "a string", ...: for messages.
    std::string_view kind() const;
    /// As the user might have written it, shortened where it is long.
    std::string text() const;
};

/// What the user wrote between two table headings, in any syntax, with places.
///
/// Every read names its key; a key that nobody read is the user's misspelling (expect_all_read). Reads of a missing
/// required key, a wrong type or a number out of range throw Error:
/// `scene.toml:12:5 [material.beetle]: width_nm = -20 is out of range; allowed [0, 1000] nm`.
class Table {
public:
    /// @param path  the heading, e.g. "material.beetle"; empty for the top of a scene
    Table(std::string path, Where where) : path_(std::move(path)), where_(std::move(where)) {}

    struct Entry {
        std::string key;
        Where key_where;
        Value value;
        mutable bool read = false;
    };

    /// Throws Error if the key is there already.
    void add(std::string key, Where key_where, Value value);

    const std::string& path() const { return path_; }
    const Where& where() const { return where_; }
    const std::vector<Entry>& entries() const { return entries_; }

    /// The value, which then counts as read; null if there is none.
    const Value* find(std::string_view key) const;

    /// Makes a key one of those that a misspelling is answered with, without reading it.
    void know(std::string_view key) const;

    double number(std::string_view key, const Allowed& allowed) const;
    double number_or(std::string_view key, const Allowed& allowed, double otherwise) const;
    int integer_or(std::string_view key, const Allowed& allowed, int otherwise) const;
    std::string text(std::string_view key) const;
    std::string text_or(std::string_view key, std::string_view otherwise) const;
    /// An array of strings, or one string alone; empty if the key is missing.
    std::vector<std::string> texts(std::string_view key) const;
    /// A sub-table; null if the key is missing.
    const Table* table(std::string_view key) const;

    /// One value of this table, checked like number().
    double checked_number(std::string_view key, const Value& value, const Allowed& allowed) const;
    int checked_integer(std::string_view key, const Value& value, const Allowed& allowed) const;
    const std::string& checked_text(std::string_view key, const Value& value) const;
    const Value::Array& checked_array(std::string_view key, const Value& value) const;
    const Table& checked_table(std::string_view key, const Value& value) const;

    /// @throws Error for the first key that nobody read, with the known ones
    void expect_all_read() const;

    [[noreturn]] void fail(const Where& where, std::string_view message) const;
    /// For a required key: names the misspelling, if one of the keys that nobody read looks like it.
    [[noreturn]] void fail_missing(std::string_view key, std::string_view what_is_allowed) const;
    [[noreturn]] void fail_at(std::string_view key, std::string_view message) const;

private:
    [[noreturn]] void fail_type(std::string_view key, const Value& value, std::string_view wanted) const;

    std::string path_;
    Where where_;
    std::vector<Entry> entries_;
    std::map<std::string, std::size_t, std::less<>> index_;
    mutable std::vector<std::string> asked_;  // the keys that somebody knows: what a misspelling is compared with
};

}  // namespace nacre
