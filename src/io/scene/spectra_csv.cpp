#include "io/scene/spectra_csv.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <system_error>
#include <vector>

#include "io/scene/curve_csv.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

constexpr std::string_view wavelength_heading = "wavelength_nm";
constexpr double shortest_nm = 1.0;
constexpr double longest_nm = 1e6;
// Beside a matt white standard a glossy one may have several times as much; a hundred times is a percentage.
constexpr double most_reflectance = 10.0;
constexpr std::size_t most_values = 1000000;

// A table while it is read; column 0 has the wavelengths.
struct Source {
    const std::string& path;
    const CsvRow& row;

    [[noreturn]] void fail(std::size_t column, const std::string& message) const {
        std::string where = path + ":" + std::to_string(row.line);
        if (column < row.columns.size()) where += ":" + std::to_string(row.columns[column]);
        throw Error(where + ": " + message);
    }
};

// "15", "15 deg", "15°", "R_15".
std::string_view number_part(std::string_view heading) {
    if (heading.starts_with("R_")) heading.remove_prefix(2);
    for (const std::string_view unit : {"deg", "\xC2\xB0"}) {
        if (heading.ends_with(unit)) {
            heading.remove_suffix(unit.size());
            break;
        }
    }
    while (heading.ends_with(' ')) heading.remove_suffix(1);
    if (heading.starts_with('+')) heading.remove_prefix(1);
    return heading;
}

double read_angle(const Source& source, std::size_t column) {
    const std::string& heading = source.row.fields[column];
    const std::string_view text = number_part(heading);
    double angle_deg = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), angle_deg);
    if (text.empty() || error != std::errc() || end != text.data() + text.size())
        source.fail(column, "heading " + in_quotes(heading) + " is not an angle; give degrees, such as 15");
    // Written so that NaN fails too.
    if (!(angle_deg >= 0.0 && angle_deg <= 90.0))
        source.fail(column, "angle " + std::string(text) + " is out of range; allowed [0, 90] degrees");
    return angle_deg + 0.0;  // no -0
}

std::vector<double> read_angles(const Source& source) {
    if (source.row.fields.front() != wavelength_heading) {
        source.fail(0, in_quotes(source.row.fields.front()) +
                           " heads the first column; a table of spectra begins with " +
                           std::string(wavelength_heading) + ", then an angle in degrees per column");
    }
    std::vector<double> angles_deg;
    for (std::size_t column = 1; column < source.row.fields.size(); ++column) {
        const double angle_deg = read_angle(source, column);
        if (std::find(angles_deg.begin(), angles_deg.end(), angle_deg) != angles_deg.end())
            source.fail(column, "angle " + number_text(angle_deg) + " has two columns; give every angle once");
        angles_deg.push_back(angle_deg);
    }
    if (angles_deg.empty())
        source.fail(0,
                    "the heading has no angle; give one or more, such as " + std::string(wavelength_heading) + ",0,45");
    return angles_deg;
}

double read_wavelength(const Source& source, const std::vector<double>& before) {
    const double nm = csv_number(source.path, source.row, 0);
    if (nm < shortest_nm || nm > longest_nm) {
        source.fail(0, "wavelength " + number_text(nm) + " is out of range; allowed [" + limit_text(shortest_nm) +
                           ", " + limit_text(longest_nm) + "] nm");
    }
    if (!before.empty() && !(nm > before.back())) {
        source.fail(0,
                    "wavelength " + number_text(nm) + " does not ascend; give every wavelength once, smallest first");
    }
    return nm;
}

double read_value(const Source& source, std::size_t column) {
    if (source.row.fields[column].empty())
        source.fail(column, "reflectance is missing; give one for every wavelength and angle");
    const double value = csv_number(source.path, source.row, column);
    if (value < 0.0) source.fail(column, "reflectance " + number_text(value) + " is negative; allowed [0, 10]");
    if (value > most_reflectance) {
        source.fail(column, "reflectance " + number_text(value) +
                                " is out of range; allowed [0, 10] (percent? give fractions)");
    }
    return value;
}

// Which column each angle is in, smallest first.
std::vector<std::size_t> ascending_order(const std::vector<double>& angles_deg) {
    std::vector<std::size_t> order(angles_deg.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angles_deg[a] < angles_deg[b]; });
    return order;
}

}  // namespace

MeasuredSpectra read_spectra_csv(const std::string& path) {
    const std::vector<CsvRow> rows = read_csv(path);
    if (rows.empty()) throw Error(path + ": is empty; give a heading, wavelength_nm and angles, and rows of numbers");
    const std::vector<double> angles_deg = read_angles({path, rows.front()});
    const std::size_t wavelengths = rows.size() - 1;
    if (wavelengths < 2)
        throw Error(path + ": has " + std::to_string(wavelengths) + " wavelengths; spectra need two or more");
    if (wavelengths * angles_deg.size() > most_values) {
        throw Error(path + ": has " + std::to_string(wavelengths * angles_deg.size()) + " values; allowed " +
                    std::to_string(most_values));
    }
    MeasuredSpectra spectra;
    spectra.file = path;
    std::vector<double> columns(wavelengths * angles_deg.size());
    for (std::size_t i = 0; i < wavelengths; ++i) {
        const Source source{path, rows[i + 1]};
        if (source.row.fields.size() != angles_deg.size() + 1) {
            source.fail(angles_deg.size() + 1, "has " + std::to_string(source.row.fields.size()) +
                                                   " fields; the heading has " + std::to_string(angles_deg.size() + 1));
        }
        spectra.wavelength_nm.push_back(read_wavelength(source, spectra.wavelength_nm));
        for (std::size_t j = 0; j < angles_deg.size(); ++j) columns[j * wavelengths + i] = read_value(source, j + 1);
    }
    for (const std::size_t j : ascending_order(angles_deg)) {
        spectra.angle_deg.push_back(angles_deg[j]);
        const double* column = columns.data() + j * wavelengths;
        spectra.reflectance.insert(spectra.reflectance.end(), column, column + wavelengths);
    }
    return spectra;
}

}  // namespace nacre
