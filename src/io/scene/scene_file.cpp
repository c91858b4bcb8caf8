#include "io/scene/scene_file.h"

#include <cstddef>
#include <memory>
#include <system_error>
#include <variant>

#include <toml++/toml.h>
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "io/scene/curve_csv.h"
#include "io/scene/shipped_materials.h"
#include "io/scene/spectra_csv.h"
#include "io/scene/text_file.h"
#include "io/scene/toml_hints.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/base/where.h"
#include "nacre/scene/key_names.h"

namespace nacre {
namespace {

constexpr std::size_t largest_scene_bytes = 64u << 20;
constexpr std::size_t deepest_include = 16;
constexpr std::size_t most_files = 1000;
constexpr int deepest_nesting = 64;

Where where_of(const toml::source_region& source, const std::string& file) {
    return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

// Converts toml++'s tree once, so that no other code needs the library.
class Converter {
public:
    explicit Converter(const std::string& file) : file_(file) {}

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
            table.add(name, where_of(key->source(), file_), convert(*node, path, depth + 1));
        }
    }

private:
    Value convert(const toml::node& node, const std::string& path, int depth) const {
        const Where where = where_of(node.source(), file_);
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

    const std::string& file_;
};

// Top tables of several files become one: [material.a] here and [material.b] there is one [material].
void merge(Table& into, const Table& from) {
    for (const Table::Entry& entry : from.entries()) {
        const Value* present = nullptr;
        for (const Table::Entry& candidate : into.entries()) {
            const bool is_top = into.path().empty();  // below it there are names that the user chose
            if (is_top ? is_same_key(candidate.key, entry.key) : candidate.key == entry.key) present = &candidate.value;
        }
        const bool both_tables = present != nullptr && std::holds_alternative<std::shared_ptr<Table>>(present->data) &&
                                 std::holds_alternative<std::shared_ptr<Table>>(entry.value.data);
        if (entry.key == "include" && into.path().empty()) continue;  // its files are in here already
        if (both_tables) {
            merge(*std::get<std::shared_ptr<Table>>(present->data),
                  *std::get<std::shared_ptr<Table>>(entry.value.data));
        } else if (present == nullptr || entry.key != "nacre") {
            into.add(entry.key, entry.key_where, entry.value);
        }
    }
}

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

Table parse(const std::string& text, const std::string& name) {
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

Table read(const std::string& path, std::vector<std::filesystem::path>& open_files, std::size_t& file_count) {
    const std::string text = read_text_file(path, largest_scene_bytes);
    Table table = parse(text, path);
    const Value* includes = table.find("include");
    if (includes == nullptr) return table;
    Table result("", table.where());
    const auto folder = std::filesystem::path(path).parent_path();
    for (const std::string& included : table.texts("include")) {
        const auto file = folder / included;
        std::error_code ignored;
        const auto canonical = std::filesystem::weakly_canonical(file, ignored);
        for (const auto& open_file : open_files) {
            if (open_file == canonical)
                table.fail(includes->where, "include of " + in_quotes(included) + " includes itself");
        }
        if (open_files.size() >= deepest_include) {
            table.fail(includes->where, "include is nested deeper than " + std::to_string(deepest_include) + " files");
        }
        if (++file_count > most_files) {
            table.fail(includes->where, "more than " + std::to_string(most_files) + " files are included");
        }
        open_files.push_back(canonical);
        try {
            merge(result, read(file.string(), open_files, file_count));
        } catch (const IoError& error) {
            table.fail(includes->where, error.what());  // the mistake is in the scene, not on the disk
        }
        open_files.pop_back();
    }
    merge(result, table);
    result.find("include");
    return result;
}

}  // namespace

Table read_scene_file(const std::string& path) {
    std::error_code ignored;
    std::vector<std::filesystem::path> open_files{std::filesystem::weakly_canonical(path, ignored)};
    std::size_t file_count = 0;
    return read(path, open_files, file_count);
}

Table parse_scene(const std::string& text, const std::string& name) {
    return parse(text, name);
}

SceneFiles scene_files() {
    const auto read_curve = [](const std::string& file, const Where& where) {
        const auto path = std::filesystem::path(where.file).parent_path() / file;
        try {
            return read_curve_csv(path.string());
        } catch (const IoError& error) {
            throw Error(where.text() + ": " + error.what());
        }
    };
    const auto find = [](const std::string& name, const Where& where) {
        return find_material(name, std::filesystem::path(where.file).parent_path().string(), where.text());
    };
    const auto read_spectra = [](const std::string& file, const Where& where) {
        const auto path = std::filesystem::path(where.file).parent_path() / file;
        try {
            return read_spectra_csv(path.string());
        } catch (const IoError& error) {
            throw Error(where.text() + ": " + error.what());
        }
    };
    return {read_curve, find, read_spectra};
}

}  // namespace nacre
