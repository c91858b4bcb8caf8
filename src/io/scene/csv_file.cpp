#include "io/scene/csv_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <utility>

#include "io/scene/text_file.h"
#include "nacre/base/decimal.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"

namespace nacre {
namespace {

constexpr std::size_t largest_csv_bytes = 64u << 20;
constexpr std::size_t most_rows = 1000000;
constexpr std::string_view blanks = " \t\r";
constexpr std::string_view separators = "\t;,";  // by rank

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

void append_utf8(std::string& text, std::uint32_t code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
        return;
    }
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    constexpr std::uint32_t leads[] = {0, 0xC0, 0xE0, 0xF0};
    text += static_cast<char>(leads[more] | code >> 6 * more);
    for (int i = more - 1; i >= 0; --i) text += static_cast<char>(0x80 | (code >> 6 * i & 0x3F));
}

// UTF-16 behind its byte order mark. A surrogate without its pair is no text, and later no number.
std::string from_utf16(std::string_view bytes, bool is_little_endian) {
    std::string text;
    std::uint32_t high = 0;
    for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
        const std::uint32_t first = static_cast<unsigned char>(bytes[i]);
        const std::uint32_t second = static_cast<unsigned char>(bytes[i + 1]);
        const std::uint32_t unit = is_little_endian ? second << 8 | first : first << 8 | second;
        if (unit >= 0xD800 && unit < 0xDC00) {
            high = unit;
        } else if (unit >= 0xDC00 && unit < 0xE000 && high != 0) {
            append_utf8(text, 0x10000 + ((high - 0xD800) << 10) + (unit - 0xDC00));
            high = 0;
        } else {
            append_utf8(text, unit);
        }
    }
    return text;
}

std::string read_utf8(const std::string& path) {
    std::string bytes = read_text_file(path, largest_csv_bytes);
    if (bytes.starts_with("\xEF\xBB\xBF")) return bytes.substr(3);
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) bytes = from_utf16(bytes, bytes[0] == '\xFF');
    if (bytes.find('\0') != std::string::npos)
        throw Error(path + ": has zero bytes, so it is not a text that nacre reads; save it as CSV in UTF-8");
    return bytes;
}

// Where a field ends: at the next separator outside quotes, or at any if a quote is left open.
std::size_t end_of_field(std::string_view content, std::size_t begin, char separator) {
    bool is_quoted = false;
    for (std::size_t i = begin; i < content.size(); ++i) {
        if (content[i] == '"') is_quoted = !is_quoted;
        if (!is_quoted && content[i] == separator) return i;
    }
    return is_quoted ? content.find(separator, begin) : std::string_view::npos;
}

CsvRow split(int line, std::string_view content, char separator) {
    CsvRow row{line, {}, {}, separator};
    for (std::size_t begin = 0;;) {
        const std::size_t end = end_of_field(content, begin, separator);
        row.fields.emplace_back(unquoted(trimmed(content.substr(begin, end - begin))));
        row.columns.push_back(static_cast<int>(begin) + 1);
        if (end == std::string_view::npos) return row;
        begin = end + 1;
    }
}

using Line = std::pair<int, std::string_view>;

char separator_of(const std::vector<Line>& lines) {
    const auto has = [](std::string_view content, char separator) {
        return end_of_field(content, 0, separator) != std::string_view::npos;
    };
    const auto best_in = [&](std::string_view content) {
        const auto found = std::find_if(separators.begin(), separators.end(), [&](char c) { return has(content, c); });
        return found == separators.end() ? separators.back() : *found;
    };
    for (const auto& [line, content] : lines) {
        const char separator = best_in(content);
        if (has(content, separator) && find_csv_number(split(line, content, separator), 0)) return separator;
    }
    return lines.empty() ? separators.back() : best_in(lines.front().second);
}

std::string_view without_plus(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    return text;
}

std::optional<int> whole_number(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
    return number;
}

}  // namespace

std::vector<CsvRow> read_csv(const std::string& path) {
    const std::string text = read_utf8(path);
    std::string_view rest = text;
    std::vector<Line> lines;
    for (int line = 1; !rest.empty(); ++line) {
        const std::size_t end = rest.find('\n');
        const std::string_view content = trimmed(rest.substr(0, end));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (content.empty() || content.front() == '#') continue;
        if (lines.size() >= most_rows)
            throw Error(path + ":" + std::to_string(line) + ": more than " + std::to_string(most_rows) + " rows");
        lines.emplace_back(line, content);
    }
    const char separator = separator_of(lines);
    std::vector<CsvRow> rows;
    rows.reserve(lines.size());
    for (const auto& [line, content] : lines) rows.push_back(split(line, content, separator));
    return rows;
}

void fail_csv(const std::string& path, const CsvRow& row, std::size_t column, const std::string& message) {
    std::string where = path + ":" + std::to_string(row.line);
    if (column < row.columns.size()) where += ":" + std::to_string(row.columns[column]);
    throw Error(where + ": " + message);
}

std::optional<double> find_csv_number(const CsvRow& row, std::size_t column, int shift) {
    if (column >= row.fields.size()) return std::nullopt;
    std::string text = row.fields[column];
    // Of "1.234,5" and "1,234,5" nobody knows what is meant.
    if (row.separator != ',' && text.find('.') == std::string::npos && std::count(text.begin(), text.end(), ',') == 1)
        std::replace(text.begin(), text.end(), ',', '.');
    return decimal_number(text, shift);
}

double csv_number(const std::string& path, const CsvRow& row, std::size_t column, int shift) {
    if (column >= row.fields.size()) {
        fail_csv(path, row, column,
                 "has " + std::to_string(row.fields.size()) + " columns; column " + std::to_string(column + 1) +
                     " is missing");
    }
    const std::optional<double> number = find_csv_number(row, column, shift);
    if (!number) fail_csv(path, row, column, in_quotes(row.fields[column]) + " is not a finite number");
    return *number;
}

std::optional<double> decimal_number(std::string_view text, int shift) {
    const std::optional<double> number = read_decimal(without_plus(text));
    if (!number || !std::isfinite(*number)) return std::nullopt;
    if (shift == 0) return number;
    const std::size_t e = text.find_first_of("eE");
    const std::optional<int> exponent =
        e == std::string_view::npos ? 0 : whole_number(without_plus(text.substr(e + 1)));
    if (!exponent) return std::nullopt;
    return read_decimal(std::string(without_plus(text.substr(0, e))) + "e" + std::to_string(*exponent + shift));
}

}  // namespace nacre
