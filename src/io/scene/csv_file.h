#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// A line of a CSV file as fields, with its number. Comments (#) and empty lines are left out.
struct CsvRow {
    int line = 0;
    std::vector<std::string> fields;  ///< without surrounding blanks and quotes
    std::vector<int> columns;         ///< where each field begins in its line, from 1
    char separator = ',';             ///< of the whole file
};

/// One separator holds for the whole file, outside quotes: that of the first row that begins with a number, else that
/// of the first row. It is the tab if that row has one, else the semicolon, else the comma.
///
/// A byte order mark and CRLF are accepted, and UTF-16 with a byte order mark. Throws IoError, or Error beyond 1 000
/// 000 rows.
std::vector<CsvRow> read_csv(const std::string& path);

/// Throws Error with file, line and, if the row has that field, column.
[[noreturn]] void fail_csv(const std::string& path, const CsvRow& row, std::size_t column, const std::string& message);

/// The number in a field, times 10^shift. Where the comma does not separate fields it may be the decimal sign. Nothing
/// if the row has no such field, or it is not a finite number.
std::optional<double> find_csv_number(const CsvRow& row, std::size_t column, int shift = 0);

/// The same. Throws Error if there is none.
double csv_number(const std::string& path, const CsvRow& row, std::size_t column, int shift = 0);

/// The number in a text, times 10^shift: the double nearest to the decimal that is meant, so that 1.005 um are 1005 nm
/// and not 1004.9999999999999. Nothing if the text is not a finite number.
std::optional<double> decimal_number(std::string_view text, int shift = 0);

}  // namespace nacre
