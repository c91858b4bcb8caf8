#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

#include "nacre/base/text.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_wavelength{1.0, 1e6, "nm"};
constexpr Allowed allowed_angle{0.0, 90.0, "degrees"};
// Beside a matt white standard a glossy one may have several times as much; a hundred times is a percentage.
constexpr Allowed allowed_reflectance{0.0, 10.0};
constexpr std::size_t most_values = 1000000;

constexpr std::array<std::string_view, 3> number_keys{"wavelength_nm", "angle_deg", "reflectance"};

const Value& required(const Table& table, std::string_view key, std::string_view what) {
    const Value* value = table.find(key);
    if (value == nullptr) table.fail_missing(key, what);
    return *value;
}

std::vector<double> read_numbers(const Table& table, std::string_view key, const Value& value, const Allowed& allowed) {
    std::vector<double> numbers;
    for (const Value& element : table.checked_array(key, value))
        numbers.push_back(table.checked_number(key, element, allowed));
    return numbers;
}

std::vector<double> read_ascending(const Table& table, std::string_view key, const Allowed& allowed,
                                   std::size_t least) {
    const Value& value = required(table, key, "give an array of numbers");
    std::vector<double> numbers = read_numbers(table, key, value, allowed);
    if (numbers.size() < least || numbers.size() > most_values) {
        table.fail(value.where, std::string(key) + " has " + std::to_string(numbers.size()) + " numbers; allowed " +
                                    std::to_string(least) + " to " + std::to_string(most_values));
    }
    if (std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) != numbers.end())
        table.fail(value.where, std::string(key) + " does not ascend; give every one once, smallest first");
    return numbers;
}

// What measured_toml() writes.
MeasuredSpectra read_inline(const Table& table) {
    MeasuredSpectra spectra;
    spectra.file = table.text_or("name", "");
    const auto is_given = [&](std::string_view key) { return table.find(key) != nullptr; };
    // No short-circuit: each of them becomes known.
    if (std::count_if(number_keys.begin(), number_keys.end(), is_given) == 0)
        table.fail_missing("file", "name a .csv, or give wavelength_nm, angle_deg and reflectance");
    spectra.wavelength_nm = read_ascending(table, "wavelength_nm", allowed_wavelength, 2);
    spectra.angle_deg = read_ascending(table, "angle_deg", allowed_angle, 1);
    const Value& rows = required(table, "reflectance", "give an array of one row per angle");
    const Value::Array& list = table.checked_array("reflectance", rows);
    if (list.size() != spectra.angle_deg.size()) {
        table.fail(rows.where, "reflectance has " + std::to_string(list.size()) + " rows; give " +
                                   std::to_string(spectra.angle_deg.size()) + ", one per angle_deg");
    }
    if (spectra.wavelength_nm.size() * list.size() > most_values) {
        table.fail(rows.where, "reflectance has " + std::to_string(spectra.wavelength_nm.size() * list.size()) +
                                   " values; allowed " + std::to_string(most_values));
    }
    for (const Value& element : list) {
        const std::vector<double> row = read_numbers(table, "reflectance", element, allowed_reflectance);
        if (row.size() != spectra.wavelength_nm.size()) {
            table.fail(element.where, "reflectance has " + std::to_string(row.size()) + " numbers in this row; give " +
                                          std::to_string(spectra.wavelength_nm.size()) + ", one per wavelength_nm");
        }
        spectra.reflectance.insert(spectra.reflectance.end(), row.begin(), row.end());
    }
    return spectra;
}

std::string list_text(const double* numbers, std::size_t count) {
    std::string text = "[";
    for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + number_text(numbers[i]);
    return text + "]";
}

}  // namespace

MeasuredSpectra read_measured(const Table& table, const SpectraReader& read_spectra) {
    const Value* file = table.find("file");
    if (file == nullptr) return read_inline(table);
    const std::string& name = table.checked_text("file", *file);
    for (const std::string_view other : {"wavelength_nm", "angle_deg", "reflectance", "name"}) {
        if (const Value* given = table.find(other))
            table.fail(given->where, "file and " + std::string(other) + " are both given; give one of them");
    }
    if (!read_spectra) table.fail(file->where, "files cannot be read here: " + toml_string(name));
    MeasuredSpectra spectra = read_spectra(name, file->where);
    spectra.file = name;
    return spectra;
}

std::string measured_toml(const MeasuredSpectra& spectra) {
    const std::size_t count = spectra.wavelength_nm.size();
    std::string text = "mechanism = \"measured\"\n";
    if (!spectra.file.empty()) text += "name = " + toml_string(spectra.file) + "\n";
    text += "wavelength_nm = " + list_text(spectra.wavelength_nm.data(), count) +
            "\nangle_deg = " + list_text(spectra.angle_deg.data(), spectra.angle_deg.size()) + "\nreflectance = [\n";
    for (std::size_t i = 0; i < spectra.angle_deg.size(); ++i)
        text += "    " + list_text(spectra.reflectance.data() + i * count, count) + ",\n";
    return text + "]\n";
}

}  // namespace nacre
