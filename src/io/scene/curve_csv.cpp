#include "io/scene/curve_csv.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>

#include "io/scene/text_file.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

constexpr std::size_t largest_csv_bytes = 64u << 20;
constexpr std::size_t most_rows = 1000000;
constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

// "a ""b"" c" in quotes is a "b" c.
std::string unquoted(std::string_view text) {
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') return std::string(text);
    std::string plain;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        plain += text[i];
        if (text[i] == '"' && text[i + 1] == '"') ++i;
    }
    return plain;
}

// Where a field ends: at the next separator outside quotes, or at any if a quote is left open.
std::size_t end_of_field(std::string_view content, std::size_t begin) {
    constexpr std::string_view separators = ",;\t";
    bool is_quoted = false;
    for (std::size_t i = begin; i < content.size(); ++i) {
        if (content[i] == '"') is_quoted = !is_quoted;
        if (!is_quoted && separators.find(content[i]) != std::string_view::npos) return i;
    }
    return is_quoted ? content.find_first_of(separators, begin) : std::string_view::npos;
}

CsvRow split(int line, std::string_view content) {
    CsvRow row{line, {}, {}};
    for (std::size_t begin = 0;;) {
        const std::size_t end = end_of_field(content, begin);
        row.fields.emplace_back(unquoted(trimmed(content.substr(begin, end - begin))));
        row.columns.push_back(static_cast<int>(begin) + 1);
        if (end == std::string_view::npos) return row;
        begin = end + 1;
    }
}

bool parse_number(std::string_view text, double& number) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && !text.empty();
}

std::string place(const std::string& path, int line) {
    return path + ":" + std::to_string(line) + ": ";
}

}  // namespace

std::vector<CsvRow> read_csv(const std::string& path) {
    const std::string text = read_text_file(path, largest_csv_bytes);
    std::string_view rest = text;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    std::vector<CsvRow> rows;
    for (int line = 1; !rest.empty(); ++line) {
        const std::size_t end = rest.find('\n');
        const std::string_view content = trimmed(rest.substr(0, end));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (content.empty() || content.front() == '#') continue;
        if (rows.size() >= most_rows)
            throw Error(place(path, line) + "more than " + std::to_string(most_rows) + " rows");
        rows.push_back(split(line, content));
    }
    return rows;
}

double csv_number(const std::string& path, const CsvRow& row, std::size_t column) {
    if (column >= row.fields.size()) {
        throw Error(place(path, row.line) + "has " + std::to_string(row.fields.size()) + " columns; column " +
                    std::to_string(column + 1) + " is missing");
    }
    double number = 0.0;
    if (!parse_number(row.fields[column], number) || !std::isfinite(number)) {
        throw Error(path + ":" + std::to_string(row.line) + ":" + std::to_string(row.columns[column]) + ": " +
                    in_quotes(row.fields[column]) + " is not a finite number");
    }
    return number;
}

SampledCurve read_curve_csv(const std::string& path) {
    std::vector<CsvRow> rows = read_csv(path);
    double ignored = 0.0;
    if (!rows.empty() && !parse_number(rows.front().fields.front(), ignored)) rows.erase(rows.begin());
    SampledCurve curve;
    for (const CsvRow& row : rows) {
        if (row.fields.size() != 2) {
            throw Error(place(path, row.line) + "has " + std::to_string(row.fields.size()) +
                        " columns; a table of power has two, wavelength_nm,power");
        }
        const double nm = csv_number(path, row, 0);
        if (!curve.wavelength_nm.empty() && !(nm > curve.wavelength_nm.back())) {
            throw Error(place(path, row.line) + "wavelength " + row.fields[0] +
                        " does not ascend; give every wavelength once, smallest first");
        }
        curve.wavelength_nm.push_back(nm);
        curve.value.push_back(csv_number(path, row, 1));
    }
    if (curve.value.size() < 2)
        throw Error(path + ": has " + std::to_string(curve.value.size()) +
                    " rows of numbers; a curve needs two or more");
    return curve;
}

}  // namespace nacre
