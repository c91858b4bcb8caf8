#include "io/scene/material_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "io/scene/csv_file.h"
#include "io/scene/index_table.h"
#include "io/scene/text_file.h"
#include "io/scene/yaml_tree.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/sampled_curve.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

constexpr std::size_t largest_yaml_bytes = 16u << 20;
constexpr std::size_t most_data_rows = 1000000;
constexpr int um_to_nm_shift = 3;  // 1 um = 10^3 nm
constexpr std::string_view yaml_blanks = " \n";
constexpr std::string_view what_a_material_is = "a material is YAML with DATA, as refractiveindex.info has it";
constexpr std::string_view allowed_types = "allowed: formula 1 to formula 9, tabulated n, tabulated k, tabulated nk";

[[noreturn]] void fail(const std::string& file, int line, const std::string& message) {
    throw Error(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + message);
}

// What one block of DATA gives.
struct Block {
    int line = 0;
    bool gives_n = false;
    bool gives_k = false;
    std::variant<double, IndexFormula, SampledCurve> n = 1.0;
    SampledCurve k;
    double first_nm = 0.0;
    double last_nm = 0.0;

    bool is_formula() const { return std::holds_alternative<IndexFormula>(n); }
};

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> result;
    for (std::size_t begin = text.find_first_not_of(yaml_blanks); begin != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(yaml_blanks, begin), text.size());
        result.push_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(yaml_blanks, end);
    }
    return result;
}

double number(std::string_view word, int shift, const std::string& file, int line) {
    const std::optional<double> value = decimal_number(word, shift);
    if (!value) fail(file, line, in_quotes(printable(word)) + " is not a finite number");
    return *value;
}

const YamlNode& text_of(const YamlNode& block, std::string_view key, const std::string& file) {
    const YamlNode* node = block.find(key);
    if (!node) fail(file, block.line, "a block of DATA has no " + std::string(key) + "; it needs one");
    if (node->kind != YamlNode::Kind::text)
        fail(file, node->line, std::string(key) + " must be a text of words or numbers");
    return *node;
}

void expect_known_keys(const YamlNode& block, std::span<const std::string> known, const std::string& file) {
    for (std::size_t i = 0; i < block.keys.size(); ++i) {
        if (std::find(known.begin(), known.end(), block.keys[i]) != known.end()) continue;
        fail(file, block.items[i].line,
             "unknown key " + in_quotes(printable(block.keys[i])) + "; known: " + comma_separated(known));
    }
}

// Tries the formula all over its range.
void expect_index(const Block& block, const std::string& file) {
    const auto& formula = std::get<IndexFormula>(block.n);
    const double steps = std::clamp(std::ceil(block.last_nm - block.first_nm), 100.0, 100000.0);
    for (int i = 0; i <= static_cast<int>(steps); ++i) {
        const double nm = std::lerp(block.first_nm, block.last_nm, i / steps);
        const double n = formula.at(nm);
        if (std::isfinite(n) && n > 0.0) continue;
        const std::string value = std::isnan(n) ? "the root of a negative number" : number_text(n);
        fail(file, block.line,
             "formula " + std::to_string(formula.number) + " gives n = " + value + " at " + number_text(nm) +
                 " nm; allowed: above 0 and finite in all of wavelength_range");
    }
}

Block read_formula(const YamlNode& node, int formula_number, const std::string& file) {
    const bool is_older = !node.find("wavelength_range") && node.find("range");
    const std::array<std::string, 3> known{"type", is_older ? "range" : "wavelength_range", "coefficients"};
    expect_known_keys(node, known, file);
    const YamlNode& range = text_of(node, is_older ? "range" : "wavelength_range", file);
    const auto ends = words(range.text);
    if (ends.size() != 2) fail(file, range.line, "wavelength_range must be two wavelengths in micrometres");
    Block block{node.line, true, false, {}, {}, 0.0, 0.0};
    block.first_nm = number(ends[0], um_to_nm_shift, file, range.line);
    block.last_nm = number(ends[1], um_to_nm_shift, file, range.line);
    if (!(block.first_nm > 0.0 && block.first_nm < block.last_nm)) {
        fail(file, range.line,
             "wavelength_range " + in_quotes(printable(range.text)) + "; allowed: two ascending wavelengths above 0");
    }
    const YamlNode& list = text_of(node, "coefficients", file);
    IndexFormula formula{formula_number, {}};
    for (const std::string_view word : words(list.text))
        formula.coefficients.push_back(number(word, 0, file, list.line));
    const std::size_t count = formula.coefficients.size();
    const std::size_t most = most_coefficients(formula_number);
    if (count < 1 || count > most) {
        fail(file, list.line,
             "formula " + std::to_string(formula_number) + " has " + std::to_string(count) +
                 " coefficients; allowed: 1 to " + std::to_string(most));
    }
    block.n = std::move(formula);
    expect_index(block, file);
    return block;
}

IndexRow read_row(std::string_view content, int line, const IndexTable& table, const std::string& file) {
    const auto fields = words(content);
    const std::size_t columns = table.gives_n && table.gives_k ? 3 : 2;
    if (fields.size() != columns) {
        fail(file, line,
             "has " + std::to_string(fields.size()) + " columns; this table has " + std::to_string(columns) +
                 ", a wavelength in micrometres and " +
                 (columns == 3    ? "n and k"
                  : table.gives_n ? "n"
                                  : "k"));
    }
    IndexRow row{line, number(fields[0], um_to_nm_shift, file, line), 0.0, 0.0};
    if (table.gives_n) row.n = number(fields[1], 0, file, line);
    if (table.gives_k) row.k = number(fields[columns - 1], 0, file, line);
    return row;
}

Block read_table(const YamlNode& node, bool gives_n, bool gives_k, const std::string& file) {
    // A range beside a table adds nothing to its rows.
    static const std::array<std::string, 3> known{"type", "data", "wavelength_range"};
    expect_known_keys(node, known, file);
    const YamlNode& data = text_of(node, "data", file);
    IndexTable table{gives_n, gives_k, {}};
    int line = data.text_line;
    for (std::string_view rest = data.text; !rest.empty(); ++line) {
        const std::size_t end = rest.find('\n');
        const std::string_view content = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (content.find_first_not_of(yaml_blanks) == std::string_view::npos) continue;
        if (table.rows.size() >= most_data_rows)
            fail(file, line, "more than " + std::to_string(most_data_rows) + " rows");
        table.rows.push_back(read_row(content, line, table, file));
    }
    IndexCurves curves = index_curves(std::move(table), file, data.line);
    const std::vector<double>& nm = gives_n ? curves.n.wavelength_nm : curves.k.wavelength_nm;
    const double first_nm = nm.front();
    const double last_nm = nm.back();
    return {node.line, gives_n, gives_k, std::move(curves.n), std::move(curves.k), first_nm, last_nm};
}

Block read_block(const YamlNode& node, const std::string& file) {
    if (node.kind != YamlNode::Kind::map) fail(file, node.line, "a block of DATA must have keys, type among them");
    const YamlNode& type = text_of(node, "type", file);
    const auto parts = words(type.text);
    if (parts.size() == 2 && parts[0] == "formula" && parts[1].size() == 1 && parts[1][0] >= '1' && parts[1][0] <= '9')
        return read_formula(node, parts[1][0] - '0', file);
    if (parts.size() == 2 && parts[0] == "tabulated") {
        if (parts[1] == "n") return read_table(node, true, false, file);
        if (parts[1] == "k") return read_table(node, false, true, file);
        if (parts[1] == "nk") return read_table(node, true, true, file);
    }
    fail(file, type.line, "unknown type " + in_quotes(printable(type.text)) + "; " + std::string(allowed_types));
}

// Which of two blocks that both give n counts: the formula beside a table of n and k, which is there for its k.
bool is_superseded(const Block& block, const Block& other) {
    return other.is_formula() && !block.is_formula() && block.gives_k;
}

// The block that gives n, or k.
const Block* only_one(std::span<const Block> blocks, bool Block::*gives, char what, const std::string& file) {
    const Block* found = nullptr;
    for (const Block& block : blocks) {
        if (!(block.*gives)) continue;
        if (!found || (what == 'n' && is_superseded(*found, block))) {
            found = &block;
        } else if (what != 'n' || !is_superseded(block, *found)) {
            fail(file, block.line, std::string("gives ") + what + " twice; give it once");
        }
    }
    return found;
}

std::string range_text(double first_nm, double last_nm) {
    return number_text(first_nm) + " to " + number_text(last_nm) + " nm";
}

IndexCurve combined(std::span<const Block> blocks, int line, const std::string& file) {
    const Block* n = only_one(blocks, &Block::gives_n, 'n', file);
    const Block* k = only_one(blocks, &Block::gives_k, 'k', file);
    if (!n) fail(file, line, "gives k only; n is needed too");
    IndexCurve curve;
    curve.name = std::filesystem::path(file).filename().string();
    curve.n = n->n;
    curve.first_nm = n->first_nm;
    curve.last_nm = n->last_nm;
    if (!k) return curve;
    curve.k = k->k;
    curve.first_nm = std::max(n->first_nm, k->first_nm);
    curve.last_nm = std::min(n->last_nm, k->last_nm);
    const bool is_one_row = n->first_nm == n->last_nm || k->first_nm == k->last_nm;
    if (!(curve.first_nm < curve.last_nm) && !(is_one_row && curve.first_nm == curve.last_nm)) {
        fail(file, line,
             "n is known from " + range_text(n->first_nm, n->last_nm) + " and k from " +
                 range_text(k->first_nm, k->last_nm) + "; they must overlap");
    }
    return curve;
}

IndexCurve read_csv_material(const std::string& path) {
    std::vector<Block> blocks;
    int line = 0;
    for (const IndexTable& table : read_index_csv(path)) {
        line = table.rows.front().line;
        IndexCurves curves = index_curves(table, path, line);
        const std::vector<double>& nm = table.gives_n ? curves.n.wavelength_nm : curves.k.wavelength_nm;
        Block block{line, table.gives_n, table.gives_k, {}, {}, nm.front(), nm.back()};
        if (table.gives_n) block.n = std::move(curves.n);
        if (table.gives_k) block.k = std::move(curves.k);
        blocks.push_back(std::move(block));
    }
    return combined(blocks, line, path);
}

}  // namespace

IndexCurve parse_material_yaml(std::string_view text, const std::string& name) {
    const YamlNode root = parse_yaml(text, name);
    const YamlNode* data = root.find("DATA");
    if (!data) fail(name, 0, "has no DATA; " + std::string(what_a_material_is));
    if (data->kind != YamlNode::Kind::list || data->items.empty())
        fail(name, data->line, "DATA must be a list of one block or more; " + std::string(what_a_material_is));
    std::vector<Block> blocks;
    for (const YamlNode& node : data->items) blocks.push_back(read_block(node, name));
    return combined(blocks, data->line, name);
}

IndexCurve read_material_file(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension == ".csv") return read_csv_material(path);
    if (extension == ".yml" || extension == ".yaml")
        return parse_material_yaml(read_text_file(path, largest_yaml_bytes), path);
    throw Error(path + ": is not a .yml, .yaml or .csv file; give one of these");
}

}  // namespace nacre
