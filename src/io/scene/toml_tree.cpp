// One of the two files that know toml++; the other is toml_places.cpp.
#include "io/scene/toml_tree.h"

#include <toml++/toml.h>
#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "io/scene/toml_hints.h"
#include "nacre/base/error.h"

namespace nacre {
namespace {

constexpr int deepest_nesting = 64;

Where where_of(const toml::source_region& source, const std::string& file) {
    return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

// Converts toml++'s tree once, so that no other code needs the library.
class Converter {
public:
    /// @param place  of all values, if lines and columns of the text mean nothing to the user
    explicit Converter(const std::string& file, const Where* place = nullptr) : file_(file), place_(place) {}

    void fill(Table& table, const toml::table& source, int depth) const {
        // toml++ sorts keys by name; files, summaries and messages follow the order in which the user wrote them.
        std::vector<std::pair<const toml::key*, const toml::node*>> entries;
        for (auto&& [key, node] : source) entries.emplace_back(&key, &node);
        std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
            const auto& left = a.first->source().begin;
            const auto& right = b.first->source().begin;
            return std::pair(left.line, left.column) < std::pair(right.line, right.column);
        });
        for (const auto& [key, node] : entries) {
            const std::string name(key->str());
            // Messages name the nearest heading; line and column do the rest for inline tables and arrays.
            const bool has_heading = node->is_table() && !node->as_table()->is_inline();
            const std::string path = !has_heading           ? table.path()
                                     : table.path().empty() ? name
                                                            : table.path() + "." + name;
            table.add(name, place_of(key->source()), convert(*node, path, depth + 1));
        }
    }

    Value convert(const toml::node& node, const std::string& path, int depth) const {
        const Where where = place_of(node.source());
        if (depth > deepest_nesting) {
            throw Error(where.text() + ": nested deeper than " + std::to_string(deepest_nesting) +
                        " levels, the most that nacre reads");
        }
        if (const auto* value = node.as_boolean()) return {value->get(), where};
        if (const auto* value = node.as_integer()) return {value->get(), where};
        if (const auto* value = node.as_floating_point()) return {value->get(), where};
        if (const auto* value = node.as_string()) return {value->get(), where};
        if (const auto* array = node.as_array()) {
            Value::Array elements;
            elements.reserve(array->size());
            for (std::size_t i = 0; i < array->size(); ++i) {
                elements.push_back(convert((*array)[i], path, depth + 1));
            }
            return {std::move(elements), where};
        }
        if (const auto* table = node.as_table()) {
            auto result = std::make_shared<Table>(path, where);
            fill(*result, *table, depth);
            return {std::move(result), where};
        }
        throw Error(where.text() + " [" + path +
                    "]: a date or a time; a scene has numbers, strings, arrays and tables");
    }

private:
    Where place_of(const toml::source_region& source) const {
        return place_ != nullptr ? *place_ : where_of(source, file_);
    }

    const std::string& file_;
    const Where* place_;
};

// toml++ follows a dotted key by recursion and has no limit of its own: a.a.a. ... would end the process.
void check_dotted_keys(const std::string& text, const std::string& name) {
    constexpr int most_dots = 200;
    int dots = 0;
    int line = 1;
    for (const char c : text) {
        if (c == '\n') ++line;
        if (c == '\n' || c == '=' || c == ',' || c == '{') dots = 0;
        if (c == '.' && ++dots > most_dots) {
            throw Error(Where{name, line, 0}.text() + ": more than " + std::to_string(most_dots) +
                        " dots in one name, the most that nacre reads");
        }
    }
}

std::string_view line_of(std::string_view text, int line) {
    for (int i = 1; i < line; ++i) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find('\n'));
}

// Where the parser stopped, and what to write instead, as far as that can be guessed.
[[noreturn]] void fail_parse(const toml::parse_error& error, const std::string& text, const std::string& name) {
    const Where where = where_of(error.source(), name);
    const std::string_view line = line_of(text, where.line);
    const std::string description(error.description());
    const std::string hint = toml_hint(line, description);
    throw Error(where.text() + ": " + (hint.empty() ? "not TOML: " + description : hint));
}

}  // namespace

Table parse_toml(const std::string& text, const std::string& name) {
    if (is_utf16(text)) throw Error(name + ":1: the file is UTF-16; save it as UTF-8");
    check_dotted_keys(text, name);
    try {
        const toml::table source = toml::parse(text, name);
        Table table("", {name, 0, 0});
        Converter(name).fill(table, source, 0);
        return table;
    } catch (const toml::parse_error& error) {
        fail_parse(error, text, name);
    }
}

Value parse_value(const std::string& text, const std::string& heading, const Where& where) {
    // Nobody begins a plain word with one of these.
    const bool is_toml = !text.empty() && std::string_view("[{\"'").find(text.front()) != std::string_view::npos;
    check_dotted_keys(text, where.file);
    try {
        const toml::table source = toml::parse("value = " + text, where.file);
        if (source.size() == 1) return Converter(where.file, &where).convert(source.begin()->second, heading, 1);
    } catch (const toml::parse_error& error) {
        if (is_toml) throw Error(where.text() + ": not TOML: " + std::string(error.description()));
    }
    return {text, where};
}

}  // namespace nacre
