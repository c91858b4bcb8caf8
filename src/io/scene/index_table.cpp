#include "io/scene/index_table.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

#include "io/scene/csv_table.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

// refractiveindex.info heads wavelengths in micrometres so, in its CSV.
constexpr std::string_view um_heading = "wl";
constexpr std::string_view allowed_columns = "wavelength_nm,n or wavelength_nm,n,k";

[[noreturn]] void fail_at(const std::string& file, int line, const std::string& message) {
    throw Error(file + ":" + std::to_string(line) + ": " + message);
}

std::string nm_text(double nm) {
    return number_text(nm) + " nm";
}

void check(const IndexTable& table, const IndexRow& row, const std::string& file) {
    if (!(row.wavelength_nm > 0.0))
        fail_at(file, row.line, "wavelength " + nm_text(row.wavelength_nm) + " is not above 0; allowed: above 0");
    if (table.gives_n && !(row.n > 0.0)) {
        fail_at(
            file, row.line,
            "n = " + number_text(row.n) + " at " + nm_text(row.wavelength_nm) + " is not above 0; allowed: above 0");
    }
    if (table.gives_k && !(row.k >= 0.0)) {
        fail_at(file, row.line,
                "k = " + number_text(row.k) + " at " + nm_text(row.wavelength_nm) +
                    " is negative, which would be gain; allowed: 0 or more");
    }
}

std::string values_text(const IndexTable& table, const IndexRow& row) {
    std::string text;
    if (table.gives_n) text += "n = " + number_text(row.n);
    if (table.gives_k) text += (text.empty() ? "k = " : ", k = ") + number_text(row.k);
    return text;
}

// Whether a row repeats the one before it, which then counts for both.
bool repeats(const IndexTable& table, const IndexRow& row, const IndexRow& before, const std::string& file) {
    if (row.wavelength_nm != before.wavelength_nm) return false;
    if (row.n != before.n || row.k != before.k) {
        fail_at(file, row.line,
                nm_text(row.wavelength_nm) + " is given twice, with " + values_text(table, row) + " and in line " +
                    std::to_string(before.line) + " with " + values_text(table, before) + "; give it once");
    }
    return true;
}

// @param shift  of wavelengths, which are then nanometres
IndexRow csv_row(const std::string& path, const CsvRow& row, std::size_t columns, bool gives_n, int shift) {
    if (row.fields.size() != columns) {
        fail_at(path, row.line,
                "has " + std::to_string(row.fields.size()) + " columns, the first row has " + std::to_string(columns) +
                    "; every row must have the same number");
    }
    const double nm = csv_number(path, row, 0, shift), value = csv_number(path, row, 1);
    if (!gives_n) return {row.line, nm, 0.0, value};
    return {row.line, nm, value, columns > 2 ? csv_number(path, row, 2) : 0.0};
}

double largest_wavelength(const std::string& path, std::span<const CsvRow> rows) {
    double largest = 0.0;
    for (const CsvRow& row : rows) largest = std::max(largest, csv_number(path, row, 0));
    return largest;
}

// One heading and its rows. @param heading  without fields if there is none
IndexTable index_block(const std::string& path, const CsvRow& heading, std::span<const CsvRow> rows) {
    if (rows.empty()) throw Error(path + ": has no numbers; allowed: columns " + std::string(allowed_columns));
    const std::size_t columns = rows.front().fields.size();
    if (columns != 2 && columns != 3) {
        fail_at(path, rows.front().line,
                "has " + std::to_string(columns) + " columns; allowed: " + std::string(allowed_columns));
    }
    const bool gives_n = columns == 3 || heading.fields.size() != 2 || heading.fields[1] != "k";
    const double last = largest_wavelength(path, rows);
    const bool is_um = last < least_last_nm && !heading.fields.empty() && heading.fields.front() == um_heading;
    if (last < least_last_nm && !is_um) {
        fail_at(path, rows.front().line,
                "wavelengths end at " + number_text(last) + " nm, as if they were micrometres; give nanometres");
    }
    IndexTable table{gives_n, columns == 3 || !gives_n, {}};
    for (const CsvRow& row : rows) table.rows.push_back(csv_row(path, row, columns, gives_n, is_um ? 3 : 0));
    return table;
}

}  // namespace

IndexCurves index_curves(IndexTable table, const std::string& file, int line) {
    for (const IndexRow& row : table.rows) check(table, row, file);
    std::stable_sort(table.rows.begin(), table.rows.end(),
                     [](const IndexRow& a, const IndexRow& b) { return a.wavelength_nm < b.wavelength_nm; });
    IndexCurves curves;
    const IndexRow* before = nullptr;
    for (const IndexRow& row : table.rows) {
        if (before && repeats(table, row, *before, file)) continue;
        before = &row;
        if (table.gives_n) {
            curves.n.wavelength_nm.push_back(row.wavelength_nm);
            curves.n.value.push_back(row.n);
        }
        if (table.gives_k) {
            curves.k.wavelength_nm.push_back(row.wavelength_nm);
            curves.k.value.push_back(row.k);
        }
    }
    if (before == nullptr) fail_at(file, line, "a table of no wavelengths; give one or more");
    return curves;
}

std::vector<IndexTable> read_index_csv(const std::string& path) {
    const CsvTable table = read_csv_table(path);
    // A number is no heading: this is a row whose wavelength is misspelt.
    if (table.has_heading() && find_csv_number(table.heading, 1)) csv_number(path, table.heading, 0);
    const std::span<const CsvRow> rows = table.rows;
    const auto second = std::find_if(rows.begin(), rows.end(),
                                     [](const CsvRow& row) { return is_wavelength_heading(row.fields.front()); });
    if (second == rows.end()) return {index_block(path, table.heading, rows)};
    const auto count = static_cast<std::size_t>(second - rows.begin());
    return {index_block(path, table.heading, rows.first(count)), index_block(path, *second, rows.subspan(count + 1))};
}

}  // namespace nacre
