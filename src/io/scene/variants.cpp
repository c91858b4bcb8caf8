#include "io/scene/variants.h"

#include <cstddef>
#include <memory>
#include <variant>

#include "io/scene/csv_file.h"
#include "io/scene/scene_file.h"
#include "io/scene/toml_tree.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/scene/mistakes.h"
#include "nacre/scene/plan_tables.h"

namespace nacre {
namespace {

constexpr const char* name_column = "name";

// The edits of a table. What stands under a heading of its own, or behind dots, is part of the key.
void add_edits(const Table& table, const std::string& prefix, std::vector<SceneEdit>& edits) {
    for (const Table::Entry& entry : table.entries()) {
        const std::string key = prefix.empty() ? entry.key : prefix + "." + entry.key;
        const auto* const inner = std::get_if<std::shared_ptr<Table>>(&entry.value.data);
        if (inner != nullptr && (*inner)->path() != table.path()) {
            add_edits(**inner, key, edits);
        } else {
            edits.push_back({key, entry.value, entry.value.where});
        }
    }
}

std::vector<Variant> variants_of_table(const Table& table) {
    std::vector<Variant> variants;
    for (const Table::Entry& entry : table.entries()) {
        Variant variant{entry.key, entry.key_where, {}};
        add_edits(table.checked_table(entry.key, entry.value), "", variant.edits);
        variants.push_back(std::move(variant));
    }
    if (variants.empty()) table.fail(table.where(), "there are no variants; write NAME = { \"KEY\" = VALUE }");
    return variants;
}

[[noreturn]] void fail_row(const std::string& path, const CsvRow& row, const std::string& message) {
    throw Error(Where{path, row.line, 0}.text() + ": " + message);
}

Variant variant_of_row(const std::string& path, const CsvRow& heading, const CsvRow& row) {
    if (row.fields.size() > heading.fields.size()) {
        fail_row(path, row,
                 "has " + std::to_string(row.fields.size()) + " columns; the heading has " +
                     std::to_string(heading.fields.size()));
    }
    Variant variant{row.fields.front(), {path, row.line, row.columns.front()}, {}};
    for (std::size_t i = 1; i < row.fields.size(); ++i) {
        if (row.fields[i].empty()) continue;  // as in the scene
        const Where where{path, row.line, row.columns[i]};
        variant.edits.push_back({heading.fields[i], parse_value(row.fields[i], "variants", where), where});
    }
    return variant;
}

std::vector<Variant> variants_of_csv(const std::string& path) {
    const std::vector<CsvRow> rows = read_csv(path);
    if (rows.size() < 2) throw Error(path + ": has no variants; give a heading and a row for each");
    const CsvRow& heading = rows.front();
    if (heading.fields.front() != name_column) {
        fail_row(path, heading,
                 "the first column is " + in_quotes(heading.fields.front()) +
                     "; it has to be name, and the others keys such as material.hero.picks[0].colour");
    }
    std::vector<Variant> variants;
    for (std::size_t i = 1; i < rows.size(); ++i) variants.push_back(variant_of_row(path, heading, rows[i]));
    return variants;
}

}  // namespace

std::vector<Variant> read_variants(const Table& scene) {
    const Value* const value = scene.find("variants");
    if (value == nullptr) return {};
    std::vector<Variant> variants;
    if (std::holds_alternative<std::string>(value->data)) {
        const std::string& file = scene.checked_text("variants", *value);
        try {
            variants = variants_of_csv((folder_of(value->where) / file).string());
        } catch (const IoError& error) {
            scene.fail(value->where, error.what());  // the mistake is in the scene, not on the disk
        }
    } else if (const auto* table = std::get_if<std::shared_ptr<Table>>(&value->data)) {
        variants = variants_of_table(**table);
    } else {
        scene.fail(value->where, "variants = " + value->text() + " is " + std::string(value->kind()) +
                                     "; give the name of a CSV file, or a table");
    }
    for (const Variant& variant : variants) check_name(variant.name, scene, variant.where);
    throw_mistakes(scene);
    return variants;
}

}  // namespace nacre
