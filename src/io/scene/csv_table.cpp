#include "io/scene/csv_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string_view>
#include <utility>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

constexpr double shortest_nm = 1.0;
constexpr double longest_nm = 1e6;

// Without units, blanks and signs, in lower case: "Wavelength (nm)" is "wavelength".
std::string plain_words(std::string_view text) {
    std::string plain;
    for (const char c : text.substr(0, text.find_first_of("([")))
        if (c != ' ' && c != '_' && c != '.') plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return plain;
}

bool has_number(const CsvRow& row) {
    for (std::size_t i = 0; i < row.fields.size(); ++i) {
        if (find_csv_number(row, i)) return true;
    }
    return false;
}

bool is_missing(const std::string& field) {
    constexpr std::array<std::string_view, 8> words{"", "na", "n/a", "#n/a", "nan", "-", "--", "null"};
    std::string lower;
    for (const char c : field) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return std::find(words.begin(), words.end(), lower) != words.end();
}

bool is_row_of_numbers(const CsvRow& row) {
    return row.fields.size() >= 2 && find_csv_number(row, 0) && (find_csv_number(row, 1) || is_missing(row.fields[1]));
}

bool says_percent(const CsvRow& row) {
    return std::any_of(row.fields.begin(), row.fields.end(),
                       [](const std::string& field) { return field.find('%') != std::string::npos; });
}

// @param scale  what is as much as a white standard, or the largest value
void clip_noise(std::vector<double>& values, double scale) {
    for (double& value : values) {
        if (value < 0.0 && value >= -most_noise * scale) value = 0.0;
    }
}

}  // namespace

bool is_wavelength_heading(const std::string& field) {
    constexpr std::array<std::string_view, 7> words{"wavelength", "wavelengthnm", "wl",      "wlnm",
                                                    "lambda",     "nm",           "lambdanm"};
    const std::string plain = plain_words(field);
    const std::string_view unit = std::string_view(field).substr(std::min(field.find_first_of("(["), field.size()));
    return (unit.empty() || unit.substr(1).starts_with("nm")) &&
           std::find(words.begin(), words.end(), plain) != words.end();
}

CsvTable read_csv_table(const std::string& path) {
    CsvTable table{path, {}, read_csv(path), false};
    std::vector<CsvRow>& rows = table.rows;
    const auto heading = std::find_if(rows.begin(), rows.end(),
                                      [](const CsvRow& row) { return is_wavelength_heading(row.fields.front()); });
    auto first = heading;
    if (heading != rows.end()) {
        table.heading = *heading;
        for (++first; first != rows.end() && !has_number(*first); ++first)
            table.says_percent = table.says_percent || says_percent(*first);
    } else {
        first = std::find_if(rows.begin(), rows.end(), is_row_of_numbers);
        // Of a file without numbers all rows are left, for the message.
        if (first == rows.end()) first = rows.begin();
        if (first != rows.begin()) table.heading = *(first - 1);
    }
    table.says_percent = table.says_percent || says_percent(table.heading);
    rows.erase(rows.begin(), first);
    if (rows.size() > 1) {
        const auto begin_nm = find_csv_number(rows.front(), 0), end_nm = find_csv_number(rows.back(), 0);
        if (begin_nm && end_nm && *begin_nm > *end_nm) std::reverse(rows.begin(), rows.end());
    }
    return table;
}

std::vector<double> csv_wavelengths(const CsvTable& table) {
    std::vector<double> wavelengths_nm;
    for (const CsvRow& row : table.rows) {
        const double nm = csv_number(table.path, row, 0);
        if (nm < shortest_nm || nm > longest_nm) {
            fail_csv(table.path, row, 0,
                     "wavelength " + number_text(nm) + " is out of range; allowed [" + limit_text(shortest_nm) + ", " +
                         limit_text(longest_nm) + "] nm");
        }
        if (!wavelengths_nm.empty() && !(nm > wavelengths_nm.back())) {
            fail_csv(table.path, row, 0,
                     "wavelength " + number_text(nm) +
                         " does not ascend; give every wavelength once, smallest or largest first");
        }
        wavelengths_nm.push_back(nm);
    }
    if (!wavelengths_nm.empty() && wavelengths_nm.back() < least_last_nm) {
        fail_csv(table.path, table.rows.front(), 0,
                 "wavelengths end at " + number_text(wavelengths_nm.back()) +
                     " nm, as if they were micrometres; give nanometres");
    }
    return wavelengths_nm;
}

std::size_t column_named(const CsvTable& table, const std::string& name) {
    const std::vector<std::string>& fields = table.heading.fields;
    const auto names = std::span(fields).subspan(fields.empty() ? 0 : 1);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        const std::string known = names.empty() ? "the table has no heading" : "known: " + known_like(name, names);
        throw Error(table.path + ": has no column " + in_quotes(name) + "; " + known);
    }
    const auto column = static_cast<std::size_t>(found - names.begin()) + 1;
    if (std::find(found + 1, names.end(), name) != names.end()) {
        fail_csv(table.path, table.heading, column,
                 "two columns are headed " + in_quotes(name) + "; give every column a name of its own");
    }
    return column;
}

std::vector<double> csv_values(const CsvTable& table, std::size_t column, const CsvKeys& keys) {
    if (keys.is_reflectance && table.says_percent && !keys.is_percent) {
        fail_csv(
            table.path, table.heading, 0,
            "the heading says percent; write unit = \"percent\" in the scene, or unit = \"fraction\" if the values "
            "are fractions");
    }
    std::vector<double> values;
    for (const CsvRow& row : table.rows) {
        if (column < row.fields.size() && is_missing(row.fields[column])) {
            fail_csv(table.path, row, column,
                     "the value is missing" +
                         (row.fields[column].empty() ? "" : " (" + in_quotes(row.fields[column]) + ")") +
                         "; fill it in, or delete the row: nacre interpolates between the rows that are left");
        }
        const double value = csv_number(table.path, row, column);
        values.push_back(keys.is_percent.value_or(false) ? value / 100.0 : value);
    }
    if (keys.clips_negative && !values.empty())
        clip_noise(values, keys.is_reflectance ? 1.0 : *std::max_element(values.begin(), values.end()));
    return values;
}

SampledCurve read_curve_csv(const std::string& path, const CsvKeys& keys) {
    const CsvTable table = read_csv_table(path);
    // A number is no heading: this is a row whose wavelength is misspelt.
    if (table.has_heading() && has_number(table.heading)) csv_number(path, table.heading, 0);
    if (table.rows.size() < 2) {
        throw Error(path + ": has " + std::to_string(table.rows.size()) +
                    " rows of numbers; a curve needs two or more");
    }
    std::size_t column = 1;
    if (!keys.column.empty()) {
        column = column_named(table, keys.column);
    } else if (table.heading.fields.size() > 2) {
        fail_csv(path, table.heading, 2,
                 "the table has several columns of values; choose one with column = " +
                     in_quotes(table.heading.fields[1]) + " in the scene");
    }
    for (const CsvRow& row : table.rows) {
        if (row.fields.size() == (keys.column.empty() ? 2 : table.heading.fields.size())) continue;
        fail_csv(path, row, row.fields.size(),
                 "has " + std::to_string(row.fields.size()) +
                     " columns; a curve has two, such as wavelength_nm,power (decimal commas need a semicolon or a tab "
                     "between the columns)");
    }
    return {csv_wavelengths(table), csv_values(table, column, keys)};
}

}  // namespace nacre
