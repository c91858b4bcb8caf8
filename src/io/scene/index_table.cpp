#include "io/scene/index_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

#include "io/scene/curve_csv.h"
#include "io/scene/text_file.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

// No table for light ends below this, but one in micrometres does.
constexpr double least_last_nm = 100.0;
constexpr std::size_t largest_table_bytes = 64u << 20;

[[noreturn]] void fail_at(const std::string& file, int line, const std::string& message) {
    throw Error(file + ":" + std::to_string(line) + ": " + message);
}

template <typename Number>
std::optional<Number> whole_number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
    return number;
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

// "400;1,5" would be read as three columns.
void refuse_decimal_commas(const std::string& path) {
    const std::string text = read_text_file(path, largest_table_bytes);
    std::string_view rest = text;
    for (int line = 1; !rest.empty(); ++line) {
        const std::string_view content = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(content.size() + 1, rest.size()));
        if (content.starts_with('#') || content.find(',') == std::string_view::npos) continue;
        if (content.find_first_of(";\t") != std::string_view::npos)
            fail_at(path, line,
                    "has two kinds of separators; write decimals with a point, and separate the columns in one way");
    }
}

bool is_heading(const CsvRow& row) {
    return std::none_of(row.fields.begin(), row.fields.end(),
                        [](const std::string& field) { return decimal_number(field).has_value(); });
}

IndexRow csv_row(const std::string& path, const CsvRow& row, std::size_t columns) {
    if (row.fields.size() != columns) {
        fail_at(path, row.line,
                "has " + std::to_string(row.fields.size()) + " columns, the first row has " + std::to_string(columns) +
                    "; every row must have the same number");
    }
    return {row.line, csv_number(path, row, 0), csv_number(path, row, 1), columns > 2 ? csv_number(path, row, 2) : 0.0};
}

}  // namespace

std::optional<double> decimal_number(std::string_view text, int shift) {
    const std::optional<double> number = whole_number<double>(text);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    if (shift == 0) return number;
    const std::size_t e = text.find_first_of("eE");
    const std::optional<int> exponent = e == std::string_view::npos ? 0 : whole_number<int>(text.substr(e + 1));
    if (!exponent) return std::nullopt;
    return whole_number<double>(std::string(text.substr(0, e)) + "e" + std::to_string(*exponent + shift));
}

IndexCurves index_curves(IndexTable table, const std::string& file, int line) {
    for (const IndexRow& row : table.rows) check(table, row, file);
    std::stable_sort(table.rows.begin(), table.rows.end(),
                     [](const IndexRow& a, const IndexRow& b) { return a.wavelength_nm < b.wavelength_nm; });
    IndexCurves curves;
    const IndexRow* before = nullptr;
    std::size_t count = 0;
    for (const IndexRow& row : table.rows) {
        if (before && repeats(table, row, *before, file)) continue;
        before = &row;
        ++count;
        if (table.gives_n) {
            curves.n.wavelength_nm.push_back(row.wavelength_nm);
            curves.n.value.push_back(row.n);
        }
        if (table.gives_k) {
            curves.k.wavelength_nm.push_back(row.wavelength_nm);
            curves.k.value.push_back(row.k);
        }
    }
    if (count < 2) {
        fail_at(file, line,
                std::string("a table of ") + (count == 0 ? "no wavelengths" : "one wavelength") +
                    "; two or more are needed (a constant index is a number in the scene)");
    }
    return curves;
}

IndexTable read_index_csv(const std::string& path) {
    refuse_decimal_commas(path);
    std::vector<CsvRow> rows = read_csv(path);
    if (!rows.empty() && is_heading(rows.front())) rows.erase(rows.begin());
    if (rows.empty()) throw Error(path + ": has no numbers; allowed: columns wavelength_nm,n or wavelength_nm,n,k");
    const std::size_t columns = rows.front().fields.size();
    if (columns != 2 && columns != 3) {
        fail_at(path, rows.front().line,
                "has " + std::to_string(columns) + " columns; allowed: wavelength_nm,n or wavelength_nm,n,k");
    }
    IndexTable table{true, columns == 3, {}};
    double last_nm = 0.0;
    for (const CsvRow& row : rows) {
        table.rows.push_back(csv_row(path, row, columns));
        last_nm = std::max(last_nm, table.rows.back().wavelength_nm);
    }
    if (last_nm < least_last_nm) {
        fail_at(path, rows.front().line,
                "wavelengths end at " + number_text(last_nm) + " nm, as if they were micrometres; give nanometres");
    }
    return table;
}

}  // namespace nacre
