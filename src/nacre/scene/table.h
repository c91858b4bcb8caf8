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
#include "nacre/scene/mistakes.h"

namespace nacre {

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
/// Every read names its key; a key that nobody read is the user's misspelling (expect_all_read). "colour" in a key may
/// be spelt "color". A message: `scene.toml:12:5 [material.beetle]: width_nm = -20 is out of range; allowed [0, 1000]
/// nm`. What is said to note a mistake keeps it until throw_mistakes(), and reading goes on; everything else throws
/// SceneError for it (see mistakes.cpp).
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

    /// Throws if the key is there already.
    void add(std::string key, Where key_where, Value value);

    /// Adds a key, or gives it another value; in either spelling.
    void set(std::string key, Where key_where, Value value);
    /// The value of a key in either spelling, to be changed before the scene is read; null if there is none.
    Value* to_change(std::string_view key);

    const std::string& path() const { return path_; }
    const Where& where() const { return where_; }
    const std::vector<Entry>& entries() const { return entries_; }

    /// The value, which then counts as read; null if there is none.
    const Value* find(std::string_view key) const;

    /// Makes a key one of those that a misspelling is answered with, without reading it.
    void know(std::string_view key) const;
    /// Makes a key count as read where what it says cannot be checked.
    void skip(std::string_view key) const { find(key); }

    /// Notes a missing key, a wrong type and a number out of range, and then gives an allowed number instead.
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
    /// An array of numbers; throws for the first that is wrong.
    std::vector<double> checked_numbers(std::string_view key, const Value& value, const Allowed& allowed) const;
    const std::string& checked_text(std::string_view key, const Value& value) const;
    const Value::Array& checked_array(std::string_view key, const Value& value) const;
    const Table& checked_table(std::string_view key, const Value& value) const;

    /// Notes every key that nobody read, with the key that may be meant or the known ones.
    void expect_all_read() const;

    void note(const Where& where, std::string_view message) const;
    void note(const Error& error, const Where& where) const;
    void note_at(std::string_view key, std::string_view message) const;
    /// Of a required key. A key that nobody read and that may be meant is noted instead (by expect_all_read).
    void note_missing(std::string_view key, std::string_view what_is_allowed = "it is required") const;
    /// Notes what is allowed and hardly meant. It does not make the table bad.
    void warn(const Where& where, std::string_view message) const;
    /// Whether nothing was noted in this table and the tables in it.
    bool is_good() const;
    /// What was, in this table and the tables in it.
    void collect_mistakes(std::vector<Mistake>& mistakes) const;
    void collect_warnings(std::vector<Mistake>& warnings) const;

    [[noreturn]] void fail(const Where& where, std::string_view message) const;
    [[noreturn]] void fail_at(std::string_view key, std::string_view message) const;
    /// Of a required key without which reading cannot go on.
    [[noreturn]] void fail_missing(std::string_view key, std::string_view what_is_allowed = "it is required") const;

private:
    struct Missing {
        std::string key;
        std::string message;
    };

    const Entry* entry_of(std::string_view key) const;
    std::string message(const Where& where, std::string_view text) const;
    std::string type_message(std::string_view key, const Value& value, std::string_view wanted) const;
    std::string number_mistake(std::string_view key, const Value& value, const Allowed& allowed, bool is_whole) const;
    const Entry* misspelling_of(std::string_view key) const;
    void note_unknown(const Entry& entry) const;

    std::string path_;
    Where where_;
    std::vector<Entry> entries_;
    std::map<std::string, std::size_t, std::less<>> index_;
    mutable std::vector<std::string> asked_;  // the keys that somebody knows: what a misspelling is compared with
    mutable std::vector<Mistake> mistakes_;
    mutable std::vector<Mistake> warnings_;
    mutable std::vector<Missing> missing_;  // keys that may yet turn out to be misspelt
};

/// Reads a part of a table that ends at its first mistake, which is noted.
/// @param where  the part's place, for mistakes that do not know their own
/// @return whether there was none
template <typename Read>
bool attempt(const Table& table, const Where& where, const Read& read) {
    try {
        read();
        return true;
    } catch (const IoError&) {
        throw;  // the disk's, not the user's
    } catch (const Error& error) {
        table.note(error, where);
        return false;
    }
}

}  // namespace nacre
