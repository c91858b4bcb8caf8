#include "io/scene/scene_file.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "io/scene/csv_table.h"
#include "io/scene/include_pattern.h"
#include "io/scene/shipped_materials.h"
#include "io/scene/spectra_csv.h"
#include "io/scene/text_file.h"
#include "io/scene/toml_tree.h"
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

const Table::Entry* entry_like(const Table& table, const std::string& key) {
    const bool is_top = table.path().empty();  // below it there are names that the user chose
    const auto& entries = table.entries();
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Table::Entry& entry) {
        return is_top ? is_same_key(entry.key, key) : entry.key == key;
    });
    return found == entries.end() ? nullptr : &*found;
}

Table* table_in(const Value& value) {
    const auto* table = std::get_if<std::shared_ptr<Table>>(&value.data);
    return table == nullptr ? nullptr : table->get();
}

// Top tables of several files become one: [material.a] here and [material.b] there is one [material].
void merge(Table& into, const Table& from) {
    for (const Table::Entry& entry : from.entries()) {
        const Table::Entry* const present = entry_like(into, entry.key);
        if (entry.key == "include" && into.path().empty()) continue;  // its files are in here already
        if (present != nullptr && table_in(present->value) != nullptr && table_in(entry.value) != nullptr) {
            merge(*table_in(present->value), *table_in(entry.value));
        } else if (present == nullptr || entry.key != "nacre") {
            into.add(entry.key, entry.key_where, entry.value);
        }
    }
}

// A table with a heading of its own, rather than one in braces.
bool has_heading(const Value& value, const Table& parent) {
    const Table* const table = table_in(value);
    return table != nullptr && table->path() != parent.path();
}

// What `winner` says replaces what the table says. Tables with headings are compared key by key.
void override_with(Table& table, const Table& winner) {
    for (const Table::Entry& entry : winner.entries()) {
        const Table::Entry* const present = entry_like(table, entry.key);
        if (present == nullptr) {
            table.add(entry.key, entry.key_where, entry.value);
        } else if (has_heading(present->value, table) && has_heading(entry.value, winner)) {
            override_with(*table_in(present->value), *table_in(entry.value));
        } else {
            *table.to_change(present->key) = entry.value;
        }
    }
}

// One element of `include`.
struct Include {
    std::string pattern;
    bool may_be_overridden = false;
};

Include read_include(const Table& scene, const Value& value) {
    if (std::holds_alternative<std::string>(value.data)) return {scene.checked_text("include", value)};
    const Table* const table = table_in(value);
    if (table == nullptr) {
        scene.fail(value.where, "include = " + value.text() + " is " + std::string(value.kind()) +
                                    "; give the name of a file, or { file = \"NAME\", override = true }");
    }
    Include include{table->text("file")};
    if (const Value* may = table->find("override")) {
        const bool* const word = std::get_if<bool>(&may->data);
        if (word == nullptr) {
            table->fail(may->where,
                        "override = " + may->text() + " is " + std::string(may->kind()) + "; give true or false");
        }
        include.may_be_overridden = *word;
    }
    table->expect_all_read();
    throw_mistakes(*table);
    return include;
}

// Files that are being read, each included by the one before it.
struct Reading {
    std::vector<std::filesystem::path> open_files;  // canonical
    std::size_t file_count = 0;
};

std::filesystem::path canonical_path(const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(file, ignored);
}

Table read(const std::string& path, Reading& reading);

Table read_included(const std::filesystem::path& file, const Table& scene, const Value& include, Reading& reading) {
    const std::filesystem::path canonical = canonical_path(file);
    auto& open = reading.open_files;
    if (std::find(open.begin(), open.end(), canonical) != open.end()) {
        const auto folder = folder_of(include.where);
        const auto name = folder.empty() ? file : file.lexically_relative(folder);
        scene.fail(include.where, "include of " + in_quotes(name.string()) + " includes itself");
    }
    if (open.size() >= deepest_include)
        scene.fail(include.where, "include is nested deeper than " + std::to_string(deepest_include) + " files");
    if (++reading.file_count > most_files)
        scene.fail(include.where, "more than " + std::to_string(most_files) + " files are included");
    open.push_back(canonical);
    try {
        Table table = read(file.string(), reading);
        open.pop_back();
        return table;
    } catch (const IoError& error) {
        scene.fail(include.where, error.what());  // the mistake is in the scene, not on the disk
    }
}

Table read(const std::string& path, Reading& reading) {
    Table table = parse_toml(read_text_file(path, largest_scene_bytes), path);
    const Value* const include = table.find("include");
    if (include == nullptr) return table;
    Table fixed("", table.where());
    Table overridable("", table.where());
    const auto* const list = std::get_if<Value::Array>(&include->data);
    for (const Value& element : list != nullptr ? *list : Value::Array{*include}) {
        const Include one = read_include(table, element);
        const auto files = included_files(path, one.pattern);
        if (files.empty()) table.fail(element.where, "include of " + in_quotes(one.pattern) + " matches no file");
        for (const auto& file : files)
            merge(one.may_be_overridden ? overridable : fixed, read_included(file, table, *include, reading));
    }
    merge(fixed, table);
    override_with(overridable, fixed);
    overridable.find("include");
    return overridable;
}

}  // namespace

Table read_scene_file(const std::string& path) {
    Reading reading{{canonical_path(path)}};
    return read(path, reading);
}

Table parse_scene(const std::string& text, const std::string& name) {
    return parse_toml(text, name);
}

std::filesystem::path folder_of(const Where& where) {
    return where.line > 0 ? std::filesystem::path(where.file).parent_path() : std::filesystem::path();
}

SceneFiles scene_files() {
    const auto read_curve = [](const std::string& file, const Where& where, const CsvKeys& keys) {
        const auto path = folder_of(where) / file;
        try {
            return read_curve_csv(path.string(), keys);
        } catch (const IoError& error) {
            throw Error(where.text() + ": " + error.what());
        }
    };
    const auto find = [](const std::string& name, const Where& where) {
        return find_material(name, folder_of(where).string(), where.text());
    };
    const auto read_spectra = [](const std::string& file, const Where& where, const CsvKeys& keys) {
        const auto path = folder_of(where) / file;
        try {
            return read_spectra_csv(path.string(), keys);
        } catch (const IoError& error) {
            throw Error(where.text() + ": " + error.what());
        }
    };
    return {read_curve, find, read_spectra};
}

}  // namespace nacre
