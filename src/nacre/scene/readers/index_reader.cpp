// A refractive index, in all the forms in which a scene may give it.
#include "nacre/scene/readers/index_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

#include "nacre/base/crop_curve.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/pick/coloured_metal.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/metal_reader.h"

namespace nacre {
namespace {

constexpr Allowed allowed_coefficient{-1e30, 1e30};
constexpr Allowed allowed_index_wavelength{1.0, 1e9, "nm"};
constexpr Allowed allowed_formula{1, 9};
constexpr std::size_t most_rows = 100000;  // chosen: far more than published tables have

enum class Outside { error, hold };
struct OutsideWord {
    std::string_view name;
    Outside meaning;
};
constexpr std::array outside_words{OutsideWord{"error", Outside::error}, OutsideWord{"hold", Outside::hold}};

std::vector<double> read_numbers(const Table& table, std::string_view key, const Value& value, const Allowed& allowed) {
    std::vector<double> numbers = table.checked_numbers(key, value, allowed);
    if (numbers.empty() || numbers.size() > most_rows) {
        table.fail(value.where, std::string(key) + " has " + std::to_string(numbers.size()) +
                                    " numbers; allowed 1 to " + std::to_string(most_rows));
    }
    return numbers;
}

// Values over wavelengths of the same table; ascending, as many of each.
SampledCurve read_curve(const Table& table, std::string_view wavelengths_key, std::string_view key,
                        const Allowed& allowed) {
    const Value* wavelengths = table.find(wavelengths_key);
    const Value* values = table.find(key);
    if (wavelengths == nullptr || values == nullptr) {
        table.fail(table.where(), std::string(wavelengths == nullptr ? wavelengths_key : key) +
                                      " is missing; give an array of numbers");
    }
    SampledCurve curve{read_numbers(table, wavelengths_key, *wavelengths, allowed_index_wavelength),
                       read_numbers(table, key, *values, allowed)};
    if (curve.value.size() != curve.wavelength_nm.size() || curve.value.empty()) {
        table.fail(values->where, std::string(wavelengths_key) + " has " + std::to_string(curve.wavelength_nm.size()) +
                                      " numbers and " + std::string(key) + " " + std::to_string(curve.value.size()) +
                                      "; give as many of each");
    }
    if (std::adjacent_find(curve.wavelength_nm.begin(), curve.wavelength_nm.end(), std::greater_equal<>()) !=
        curve.wavelength_nm.end()) {
        table.fail(wavelengths->where,
                   std::string(wavelengths_key) + " does not ascend; give every wavelength once, smallest first");
    }
    return curve;
}

bool is_array(const Value* value) {
    return value != nullptr && std::holds_alternative<Value::Array>(value->data);
}

void narrow_to(IndexCurve& curve, const SampledCurve& table) {
    curve.first_nm = std::max(curve.first_nm, table.wavelength_nm.front());
    curve.last_nm = std::min(curve.last_nm, table.wavelength_nm.back());
}

void read_k(const Table& table, IndexCurve& curve) {
    const Value* k = table.find("k");
    if (k == nullptr) return;
    if (!is_array(k)) {
        curve.k = table.checked_number("k", *k, allowed_k);
        return;
    }
    const bool has_own_grid = table.find("k_wavelength_nm") != nullptr;
    SampledCurve samples = read_curve(table, has_own_grid ? "k_wavelength_nm" : "wavelength_nm", "k", allowed_k);
    narrow_to(curve, samples);
    curve.k = std::move(samples);
}

// One of the formulas. Cauchy and Sellmeier have the coefficients that textbooks print.
IndexFormula read_formula(const Table& table) {
    if (const Value* cauchy = table.find("cauchy")) {
        const std::vector<double> terms = read_numbers(table, "cauchy", *cauchy, allowed_coefficient);
        IndexFormula formula{5, {terms.front()}};
        for (std::size_t i = 1; i < terms.size(); ++i) {
            formula.coefficients.push_back(terms[i]);
            formula.coefficients.push_back(-2.0 * static_cast<double>(i));
        }
        if (formula.coefficients.size() <= most_coefficients(5)) return formula;
        table.fail(cauchy->where, "cauchy has " + std::to_string(terms.size()) + " terms; give at most " +
                                      std::to_string(most_coefficients(5) / 2 + 1));
    }
    if (const Value* sellmeier = table.find("sellmeier")) {
        IndexFormula formula{2, {0.0}};
        const std::vector<double> terms = read_numbers(table, "sellmeier", *sellmeier, allowed_coefficient);
        formula.coefficients.insert(formula.coefficients.end(), terms.begin(), terms.end());
        if (terms.size() % 2 == 0 && formula.coefficients.size() <= most_coefficients(2)) return formula;
        table.fail(sellmeier->where,
                   "sellmeier has " + std::to_string(terms.size()) + " numbers; give pairs B1, C1, B2, C2 ..., " +
                       std::to_string(most_coefficients(2) / 2) + " at most (C in square micrometres)");
    }
    IndexFormula formula{table.integer_or("formula", allowed_formula, 5), {}};
    const Value* coefficients = table.find("coefficients");
    if (coefficients == nullptr) table.fail_missing("coefficients", "a formula needs them");
    formula.coefficients = read_numbers(table, "coefficients", *coefficients, allowed_coefficient);
    if (formula.coefficients.size() > most_coefficients(formula.number)) {
        table.fail(coefficients->where, "formula " + std::to_string(formula.number) + " has at most " +
                                            std::to_string(most_coefficients(formula.number)) +
                                            " coefficients; these are " + std::to_string(formula.coefficients.size()));
    }
    return formula;
}

void read_range(const Table& table, IndexCurve& curve) {
    const Value* range = table.find("range_nm");
    if (range == nullptr) return;
    const std::vector<double> ends = read_numbers(table, "range_nm", *range, allowed_index_wavelength);
    if (ends.size() != 2 || !(ends[0] < ends[1]))
        table.fail(range->where, "range_nm is not an interval; give [first, last], the first smaller");
    curve.first_nm = std::max(curve.first_nm, ends[0]);
    curve.last_nm = std::min(curve.last_nm, ends[1]);
}

bool read_outside(const Table& table) {
    const Value* value = table.find("outside");
    if (value == nullptr) return false;
    const std::string& name = table.checked_text("outside", *value);
    for (const OutsideWord& word : outside_words) {
        if (word.name == name) return word.meaning == Outside::hold;
    }
    table.fail(value->where, "unknown outside " + in_quotes(name) + "; known: error, hold");
}

// Where a Sellmeier formula has no value at all; a resonance may be narrower than any step.
std::vector<double> resonances_nm(const IndexCurve& curve) {
    std::vector<double> resonances;
    const auto* formula = std::get_if<IndexFormula>(&curve.n);
    if (formula == nullptr || formula->number > 2) return resonances;
    for (std::size_t i = 2; i < formula->coefficients.size(); i += 2) {
        const double c = formula->coefficients[i];
        if (formula->coefficients[i - 1] == 0.0) continue;
        if (formula->number == 1) resonances.push_back(1000.0 * std::abs(c));
        if (formula->number == 2 && c > 0.0) resonances.push_back(1000.0 * std::sqrt(c));
    }
    return resonances;
}

// A formula may have poles, and no n below its root.
void check_formula(const Table& table, const IndexCurve& curve, double first_nm, double last_nm) {
    for (const double nm : resonances_nm(curve)) {
        if (nm < first_nm || nm > last_nm) continue;
        table.fail(table.where(),
                   "the formula has a resonance at " + number_text(nm) +
                       " nm, where it gives no index; give a formula whose resonances lie outside range_nm");
    }
    constexpr int places = 2000;
    for (int i = 0; i <= places; ++i) {
        const double nm = std::lerp(std::max(first_nm, curve.first_nm), std::min(last_nm, curve.last_nm),
                                    static_cast<double>(i) / places);
        const double n = curve.at(nm).real();
        if (n >= allowed_n.low && n <= allowed_n.high) continue;
        const std::string what = std::isfinite(n) ? "n = " + number_text(n) : "no real n";
        table.fail(table.where(), "the formula gives " + what + " at " + number_text(nm) + " nm; n must be from " +
                                      number_text(allowed_n.low) + " to " + number_text(allowed_n.high));
    }
}

}  // namespace

void IndexReader::check_range(const Table& table, const Where& where, const IndexCurve& curve) const {
    if (curve.holds_outside || (curve.first_nm <= first_nm && curve.last_nm >= last_nm)) return;
    const std::string name = curve.name.empty() ? "this index" : in_quotes(curve.name);
    const std::string needed =
        ", and the light needs " + number_text(first_nm) + " to " + number_text(last_nm) + " nm; ";
    if (curve.first_nm == curve.last_nm) {
        table.fail(where, name + " is known at " + number_text(curve.first_nm) + " nm only" + needed +
                              "write outside = \"hold\" to use its value at all wavelengths");
    }
    table.fail(where, name + " is known from " + number_text(curve.first_nm) + " to " + number_text(curve.last_nm) +
                          " nm" + needed +
                          "narrow [light] range_nm, or write outside = \"hold\" to go on with its end values");
}

Index IndexReader::read_material(const Table& table, std::string_view key, const Value& name,
                                 bool holds_outside) const {
    const std::string& text = table.checked_text(key, name);
    if (text.empty()) table.fail(name.where, std::string(key) + " is empty; give a number or the name of a material");
    if (!find_material) table.fail(name.where, "materials cannot be looked up here: " + in_quotes(text));
    std::shared_ptr<const IndexCurve> curve = find_material(text, name.where);
    // Before it is cropped: the message names the range of the file.
    if (!holds_outside) check_range(table, name.where, *curve);
    if (!curve->is_shipped || holds_outside) {
        IndexCurve own = *curve;
        own.holds_outside = holds_outside;
        if (!own.is_shipped) {
            if (auto* n = std::get_if<SampledCurve>(&own.n)) {
                crop_curve(*n, first_nm, last_nm);
                narrow_to(own, *n);
            }
            if (auto* k = std::get_if<SampledCurve>(&own.k)) {
                crop_curve(*k, first_nm, last_nm);
                narrow_to(own, *k);
            }
        }
        curve = std::make_shared<const IndexCurve>(std::move(own));
    }
    return Index(std::move(curve));
}

IndexCurve IndexReader::read_written_curve(const Table& table, std::string_view key, const Value* n) const {
    IndexCurve curve;
    curve.name = table.text_or("name", "");
    if (is_array(n)) {
        SampledCurve samples = read_curve(table, "wavelength_nm", "n", allowed_n);
        narrow_to(curve, samples);
        curve.n = std::move(samples);
    } else if (n != nullptr) {
        curve.n = table.checked_number("n", *n, allowed_n);
    } else if (table.find("cauchy") || table.find("sellmeier") || table.find("formula")) {
        curve.n = read_formula(table);
    } else {
        table.note_missing("n", std::string(key) +
                                    " needs a number, a material, { n, k }, { cauchy = [...] }, { sellmeier = [...] } "
                                    "or { wavelength_nm = [...], n = [...] }");
    }
    read_k(table, curve);
    read_range(table, curve);
    return curve;
}

Index IndexReader::read_table(const Table& table, std::string_view key) const {
    if (const std::optional<MetalColour> metal = read_metal(table, key)) {
        table.expect_all_read();
        return Index(coloured_metal(*metal));
    }
    // So that a misspelling is answered with all of them.
    for (const std::string_view known : {"n", "k", "material", "cauchy", "sellmeier", "formula", "coefficients",
                                         "wavelength_nm", "k_wavelength_nm", "range_nm", "outside", "name"}) {
        table.know(known);
    }
    const bool holds_outside = read_outside(table);
    if (const Value* material = table.find("material")) {
        Index index = read_material(table, "material", *material, holds_outside);
        table.expect_all_read();
        return index;
    }
    const Value* n = table.find("n");
    if (n != nullptr && !is_array(n) && !is_array(table.find("k"))) {
        const double real = table.checked_number("n", *n, allowed_n);
        const double imaginary = table.number_or("k", allowed_k, 0.0);
        table.expect_all_read();
        return Index(RefractiveIndex(real, imaginary));
    }
    IndexCurve curve = read_written_curve(table, key, n);
    curve.holds_outside = holds_outside;
    table.expect_all_read();
    if (table.is_good()) {
        check_range(table, table.where(), curve);
        check_formula(table, curve, first_nm, last_nm);
    }
    return Index(std::make_shared<const IndexCurve>(std::move(curve)));
}

Index IndexReader::read(const Table& table, std::string_view key, const Value& value) const {
    Index index(1.0);
    if (refuse_range(table, key, value)) return index;
    attempt(table, value.where, [&] {
        if (std::holds_alternative<std::string>(value.data)) {
            index = read_material(table, key, value, false);
        } else if (std::holds_alternative<std::shared_ptr<Table>>(value.data)) {
            index = read_table(table.checked_table(key, value), key);
        } else {
            index = Index(table.checked_number(key, value, allowed_n));
        }
    });
    return index;
}

Index IndexReader::read_or(const Table& table, std::string_view key, const Index& otherwise) const {
    const Value* value = table.find(key);
    return value == nullptr ? otherwise : read(table, key, *value);
}

}  // namespace nacre
