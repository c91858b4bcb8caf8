#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/scene/csv_file.h"
#include "nacre/base/sampled_curve.h"
#include "nacre/scene/readers/csv_keys.h"

namespace nacre {

/// No table for light ends below this, but one in micrometres does.
inline constexpr double least_last_nm = 100.0;

/// Chosen: what lies further below 0, as a share of white or of a lamp's largest power, is not an instrument's noise.
inline constexpr double most_noise = 0.05;

/// A table of numbers over wavelength, as instruments write it.
struct CsvTable {
    std::string path;
    CsvRow heading;            ///< without fields if there is none
    std::vector<CsvRow> rows;  ///< wavelengths first; reversed if the file has the longest first
    bool says_percent = false;

    bool has_heading() const { return !heading.fields.empty(); }
};

/// Finds the table in a file. What stands before it is left out.
///
/// The table begins behind the first row whose first field is a heading of wavelengths; rows without any number that
/// follow it (units) are left out too. Without such a heading it begins at the first row whose first two fields are
/// numbers, and the row before that is its heading. Throws IoError or Error.
CsvTable read_csv_table(const std::string& path);

/// wavelength_nm, "Wavelength (nm)", wl, lambda, nm and the like, in upper or lower case.
bool is_wavelength_heading(const std::string& field);

/// The wavelengths of the rows. Throws Error unless they ascend within [1, 1e6] nm, and if they end like micrometres.
std::vector<double> csv_wavelengths(const CsvTable& table);

/// The column of a specimen. Throws Error with the known names if there is none, or two, of that name.
std::size_t column_named(const CsvTable& table, const std::string& name);

/// One column's values, as fractions if they are percent; with noise below 0 clipped if the keys say so.
/// Throws Error for what is missing (NA, empty) and for what is not a number, and if the file says percent and the keys
/// say nothing.
std::vector<double> csv_values(const CsvTable& table, std::size_t column, const CsvKeys& keys);

/// A table of two columns, such as wavelength_nm,power; or of more, of which `column` of the keys names one.
SampledCurve read_curve_csv(const std::string& path, const CsvKeys& keys = {});

}  // namespace nacre
