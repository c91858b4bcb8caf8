// Spectra that were measured at some angles: from a file, or written out.
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "nacre/base/text.h"
#include "nacre/scene/readers/csv_keys.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_measured_wavelength{1.0, 1e6, "nm"};
constexpr Allowed allowed_angle{0.0, 90.0, "degrees"};
// Beside a matt white standard a glossy one may have several times as much; a hundred times is a percentage.
constexpr Allowed allowed_measured_reflectance{0.0, 10.0};
constexpr Allowed allowed_measured_percent{0.0, 1000.0};
constexpr std::size_t most_values = 1000000;  // chosen: 8 MB, far more than any instrument gives

constexpr std::array<std::string_view, 3> number_keys{"wavelength_nm", "angle_deg", "reflectance"};

const Value& required(const Table& table, std::string_view key, std::string_view what) {
    const Value* value = table.find(key);
    if (value == nullptr) table.fail_missing(key, what);
    return *value;
}

std::vector<double> read_ascending(const Table& table, std::string_view key, const Allowed& allowed,
                                   std::size_t least) {
    const Value& value = required(table, key, "give an array of numbers");
    std::vector<double> numbers = table.checked_numbers(key, value, allowed);
    if (numbers.size() < least || numbers.size() > most_values) {
        table.fail(value.where, std::string(key) + " has " + std::to_string(numbers.size()) + " numbers; allowed " +
                                    std::to_string(least) + " to " + std::to_string(most_values));
    }
    if (std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) != numbers.end())
        table.fail(value.where, std::string(key) + " does not ascend; give every one once, smallest first");
    return numbers;
}

// One row per angle, one number per wavelength.
std::vector<double> read_rows(const Table& table, const MeasuredSpectra& spectra, bool is_percent) {
    const Allowed& allowed = is_percent ? allowed_measured_percent : allowed_measured_reflectance;
    const std::size_t wavelengths = spectra.wavelength_nm.size();
    const Value& rows = required(table, "reflectance", "give an array of one row per angle");
    const Value::Array& list = table.checked_array("reflectance", rows);
    if (list.size() != spectra.angle_deg.size()) {
        table.fail(rows.where, "reflectance has " + std::to_string(list.size()) + " rows; give " +
                                   std::to_string(spectra.angle_deg.size()) + ", one per angle_deg");
    }
    if (wavelengths * list.size() > most_values) {
        table.fail(rows.where, "reflectance has " + std::to_string(wavelengths * list.size()) + " values; allowed " +
                                   std::to_string(most_values));
    }
    std::vector<double> reflectance;
    for (const Value& element : list) {
        std::vector<double> row = table.checked_numbers("reflectance", element, allowed);
        if (is_percent) {
            for (double& value : row) value /= 100.0;
        }
        if (row.size() != wavelengths) {
            table.fail(element.where, "reflectance has " + std::to_string(row.size()) + " numbers in this row; give " +
                                          std::to_string(wavelengths) + ", one per wavelength_nm");
        }
        reflectance.insert(reflectance.end(), row.begin(), row.end());
    }
    return reflectance;
}

// What measured_toml() writes.
MeasuredSpectra read_inline(const Table& table) {
    MeasuredSpectra spectra;
    spectra.file = table.text_or("name", "");
    const auto is_given = [&](std::string_view key) { return table.find(key) != nullptr; };
    // No short-circuit: each of them becomes known.
    if (std::count_if(number_keys.begin(), number_keys.end(), is_given) == 0)
        table.fail_missing("file", "name a .csv, or give wavelength_nm, angle_deg and reflectance");
    spectra.wavelength_nm = read_ascending(table, "wavelength_nm", allowed_measured_wavelength, 2);
    spectra.angle_deg = read_ascending(table, "angle_deg", allowed_angle, 1);
    const std::optional<bool> is_percent = read_is_percent(table);
    spectra.reflectance = read_rows(table, spectra, is_percent.value_or(false));
    warn_of_bright_spectra(table, table.find("reflectance")->where, spectra, is_percent);
    return spectra;
}

std::string list_text(const double* numbers, std::size_t count) {
    std::string text = "[";
    for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + number_text(numbers[i]);
    return text + "]";
}

ReadMechanism read_measured(const Table& table, const SceneContext& context) {
    const Value* file = table.find("file");
    if (file == nullptr) return {read_inline(table)};
    const std::string& name = table.checked_text("file", *file);
    for (const std::string_view other : {"wavelength_nm", "angle_deg", "reflectance", "name"}) {
        if (const Value* given = table.find(other))
            table.fail(given->where, "file and " + std::string(other) + " are both given; give one of them");
    }
    if (!context.read_spectra) table.fail(file->where, "files cannot be read here: " + toml_string(name));
    const CsvKeys keys = read_csv_keys(table, true);
    MeasuredSpectra spectra = context.read_spectra(name, file->where, keys);
    warn_of_bright_spectra(table, file->where, spectra, keys.is_percent);
    spectra.file = name;
    return {std::move(spectra)};
}

std::string measured_toml(const Mechanism& mechanism) {
    const auto& spectra = std::get<MeasuredSpectra>(mechanism);
    const std::size_t count = spectra.wavelength_nm.size();
    std::string text = "mechanism = \"measured\"\n";
    // Said, so that it is no cause for a warning.
    const auto is_above_1 = [](double reflectance) { return reflectance > 1.0; };
    if (std::any_of(spectra.reflectance.begin(), spectra.reflectance.end(), is_above_1))
        text += "unit = \"fraction\"\n";
    if (!spectra.file.empty()) text += "name = " + toml_string(spectra.file) + "\n";
    text += "wavelength_nm = " + list_text(spectra.wavelength_nm.data(), count) +
            "\nangle_deg = " + list_text(spectra.angle_deg.data(), spectra.angle_deg.size()) + "\nreflectance = [\n";
    for (std::size_t i = 0; i < spectra.angle_deg.size(); ++i)
        text += "    " + list_text(spectra.reflectance.data() + i * count, count) + ",\n";
    return text + "]\n";
}

}  // namespace

const MechanismReader measured_reader{
    .read = read_measured,
    .search = nullptr,
    .parameters = nullptr,
    .toml = measured_toml,
    .substrate = nullptr,
    .warning = nullptr,
    .check_axis = nullptr,
    .refusals = {.base = no_transmission,
                 .facets = not_refused,
                 .polarisation = "whose light is that of the measurement",
                 .thickness_spread_nm = "whose measurement contains the spread",
                 .orders = no_orders},
};

}  // namespace nacre
