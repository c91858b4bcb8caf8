#include "io/scene/spectra_csv.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "io/scene/csv_table.h"
#include "nacre/base/decimal.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

// Beside a matt white standard a glossy one may have several times as much; a hundred times is a percentage.
constexpr double most_reflectance = 10.0;
constexpr std::size_t most_values = 1000000;

// "15", "15 deg", "15°" (in UTF-8 or Latin-1), "R_15".
std::string_view number_part(std::string_view heading) {
    if (heading.starts_with("R_")) heading.remove_prefix(2);
    for (const std::string_view unit : {"deg", "\xC2\xB0", "\xB0"}) {
        if (heading.ends_with(unit)) {
            heading.remove_suffix(unit.size());
            break;
        }
    }
    while (heading.ends_with(' ')) heading.remove_suffix(1);
    if (heading.starts_with('+')) heading.remove_prefix(1);
    return heading;
}

double read_angle(const CsvTable& table, std::size_t column) {
    const std::string& heading = table.heading.fields[column];
    std::string text(number_part(heading));
    if (table.heading.separator != ',') std::replace(text.begin(), text.end(), ',', '.');
    const std::optional<double> angle_deg = read_decimal(text);
    if (!angle_deg) {
        fail_csv(table.path, table.heading, column,
                 "heading " + in_quotes(heading) + " is not an angle; give degrees, such as 15" +
                     (heading.empty() ? "" : ", or choose this specimen with column = " + in_quotes(heading)));
    }
    // Written so that NaN fails too.
    if (!(*angle_deg >= 0.0 && *angle_deg <= 90.0)) {
        fail_csv(table.path, table.heading, column, "angle " + text + " is out of range; allowed [0, 90] degrees");
    }
    return *angle_deg + 0.0;  // no -0
}

std::vector<double> read_angles(const CsvTable& table) {
    std::vector<double> angles_deg;
    for (std::size_t column = 1; column < table.heading.fields.size(); ++column) {
        const double angle_deg = read_angle(table, column);
        if (std::find(angles_deg.begin(), angles_deg.end(), angle_deg) != angles_deg.end()) {
            fail_csv(table.path, table.heading, column,
                     "angle " + number_text(angle_deg) + " has two columns; give every angle once");
        }
        angles_deg.push_back(angle_deg);
    }
    if (angles_deg.empty())
        fail_csv(table.path, table.heading, 0,
                 "the heading has no angle; give one or more, such as wavelength_nm,0,45");
    return angles_deg;
}

void check_heading(const CsvTable& table) {
    if (!table.has_heading() && table.rows.empty())
        throw Error(table.path + ": is empty; give a heading, wavelength_nm and angles, and rows of numbers");
    const CsvRow& heading = table.has_heading() ? table.heading : table.rows.front();
    if (table.has_heading() && is_wavelength_heading(heading.fields.front())) return;
    fail_csv(table.path, heading, 0,
             in_quotes(heading.fields.front()) +
                 " heads the first column; a table of spectra begins with wavelength_nm, then an angle in degrees per "
                 "column");
}

void check_size(const CsvTable& table, std::size_t columns) {
    if (table.rows.size() < 2) {
        throw Error(table.path + ": has " + std::to_string(table.rows.size()) +
                    " wavelengths; spectra need two or more");
    }
    if (table.rows.size() * columns > most_values) {
        throw Error(table.path + ": has " + std::to_string(table.rows.size() * columns) + " values; allowed " +
                    std::to_string(most_values));
    }
    const std::size_t fields = table.heading.fields.size();
    for (const CsvRow& row : table.rows) {
        if (row.fields.size() == fields) continue;
        const bool may_be_commas = row.separator == ',' && row.fields.size() > fields;
        fail_csv(table.path, row, fields,
                 "has " + std::to_string(row.fields.size()) + " fields; the heading has " + std::to_string(fields) +
                     (may_be_commas ? " (decimal commas need a semicolon or a tab between the columns)" : ""));
    }
}

std::vector<double> read_reflectance(const CsvTable& table, std::size_t column, const CsvKeys& keys) {
    std::vector<double> values = csv_values(table, column, keys);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string what = "reflectance " + table.rows[i].fields[column];
        if (values[i] < 0.0) {
            fail_csv(
                table.path, table.rows[i], column,
                what + " is negative; " +
                    (keys.clips_negative ? "noise is -" + number_text(most_noise) + " of white or more"
                                         : "allowed [0, 10]; write negative = \"clip\" in the scene if it is noise"));
        }
        if (values[i] > most_reflectance) {
            fail_csv(table.path, table.rows[i], column,
                     what + (keys.is_percent.value_or(false)
                                 ? " is out of range; allowed [0, 1000] percent"
                                 : " is out of range; allowed [0, 10]; write unit = \"percent\" in the scene if it is "
                                   "percent"));
        }
    }
    return values;
}

// Which column each angle is in, smallest first.
std::vector<std::size_t> ascending_order(const std::vector<double>& angles_deg) {
    std::vector<std::size_t> order(angles_deg.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angles_deg[a] < angles_deg[b]; });
    return order;
}

}  // namespace

MeasuredSpectra read_spectra_csv(const std::string& path, const CsvKeys& keys) {
    const CsvTable table = read_csv_table(path);
    MeasuredSpectra spectra;
    spectra.file = path;
    if (!keys.column.empty()) {
        const std::size_t column = column_named(table, keys.column);
        check_size(table, 1);
        spectra.wavelength_nm = csv_wavelengths(table);
        spectra.angle_deg = {0.0};
        spectra.reflectance = read_reflectance(table, column, keys);
        return spectra;
    }
    check_heading(table);
    const std::vector<double> angles_deg = read_angles(table);
    check_size(table, angles_deg.size());
    spectra.wavelength_nm = csv_wavelengths(table);
    for (const std::size_t j : ascending_order(angles_deg)) {
        spectra.angle_deg.push_back(angles_deg[j]);
        const std::vector<double> values = read_reflectance(table, j + 1, keys);
        spectra.reflectance.insert(spectra.reflectance.end(), values.begin(), values.end());
    }
    return spectra;
}

}  // namespace nacre
