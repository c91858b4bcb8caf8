#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "nacre/base/sampled_curve.h"

namespace nacre {

/// Lines of a CSV file as fields, with their line numbers. Comments (#) and empty lines are left out.
struct CsvRow {
    int line = 0;
    std::vector<std::string> fields;  ///< without surrounding blanks and quotes
    std::vector<int> columns;         ///< where each field begins in its line, from 1
};

/// Separators: comma, semicolon or tab, outside quotes. A byte order mark and CRLF are accepted. Throws IoError, or
/// Error beyond 1 000 000 rows.
std::vector<CsvRow> read_csv(const std::string& path);

/// The number in a field. Throws Error, naming the file, the line and the text, if it is not a finite number.
double csv_number(const std::string& path, const CsvRow& row, std::size_t column);

/// A table of wavelength_nm,power: two columns, ascending wavelengths; a first row of words is a heading.
SampledCurve read_curve_csv(const std::string& path);

}  // namespace nacre
