// The parser says what it expected. Here the line where it stopped is searched for what people write instead of TOML.
#include "io/scene/toml_hints.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace nacre {
namespace {

constexpr std::string_view line_blanks = " \t\r";
constexpr std::size_t longest_shown = 100;  // of a line, in messages

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_hex(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
bool is_bare(char c) {
    return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '.';
}

template <typename Is>
std::string_view taken_while(std::string_view text, Is is) {
    return text.substr(0, static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is) - text.begin()));
}

std::string_view without_blanks(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(line_blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(line_blanks) - begin + 1);
}

// What stands on the two sides of an equals sign; the value goes to the end of the line.
struct Assignment {
    std::string_view key;
    std::string_view value;
};
std::optional<Assignment> assignment_at(std::string_view line, std::size_t equals) {
    const std::string_view left = without_blanks(line.substr(0, equals));
    std::size_t begin = left.size();
    while (begin > 0 && is_bare(left[begin - 1])) --begin;
    const std::string_view key = left.substr(begin);
    if (key.empty() || key.size() > longest_shown) return {};
    return Assignment{key, without_blanks(line.substr(equals + 1))};
}

std::string instead(const Assignment& wrong, std::string_view wrong_value, const std::string& right_value) {
    const std::string key = std::string(wrong.key) + " = ";
    return "; write " + key + right_value + " instead of " + key + std::string(wrong_value.substr(0, longest_shown));
}

std::string unquoted_colour(const Assignment& assignment) {
    if (!assignment.value.starts_with('#')) return {};
    const std::string_view digits = taken_while(assignment.value.substr(1), is_hex);
    if (digits.size() != 3 && digits.size() != 6) return {};
    const std::string_view colour = assignment.value.substr(0, digits.size() + 1);
    return "a colour needs quotes, because # begins a comment" +
           instead(assignment, colour, '"' + std::string(colour) + '"');
}

std::string decimal_comma(const Assignment& assignment) {
    const std::string_view value = assignment.value;
    const std::size_t sign = value.starts_with('-') || value.starts_with('+') ? 1 : 0;
    const std::string_view whole = taken_while(value.substr(sign), is_digit);
    const std::size_t comma = sign + whole.size();
    if (whole.empty() || comma >= value.size() || value[comma] != ',') return {};
    const std::string_view decimals = taken_while(value.substr(comma + 1), is_digit);
    if (decimals.empty()) return {};
    const std::string_view number = value.substr(0, comma + 1 + decimals.size());
    std::string right(number);
    right[comma] = '.';
    return "a number has a decimal point" + instead(assignment, number, right);
}

// `true` and `false` are the only words that stand without quotes.
std::string unquoted_word(const Assignment& assignment) {
    if (assignment.value.empty() || !is_letter(assignment.value.front())) return {};
    const std::string_view word = taken_while(assignment.value, is_bare);
    std::string lower(word);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (word == "true" || word == "false" || word == "inf" || word == "nan") return {};
    if (lower == "true" || lower == "false")
        return "true and false have small letters" + instead(assignment, word, lower);
    return "text needs quotes" + instead(assignment, word, '"' + std::string(word) + '"');
}

std::string hint_of_assignments(std::string_view line) {
    for (const auto hint : {unquoted_colour, decimal_comma, unquoted_word}) {
        for (std::size_t equals = line.find('='); equals != std::string_view::npos;
             equals = line.find('=', equals + 1)) {
            const auto assignment = assignment_at(line, equals);
            if (!assignment) continue;
            std::string text = hint(*assignment);
            if (!text.empty()) return text;
        }
    }
    return {};
}

// Of word processors: double and single quotation marks of several languages, in UTF-8.
constexpr std::array<std::string_view, 8> curly_quotes{"\xE2\x80\x9C", "\xE2\x80\x9D", "\xE2\x80\x9E", "\xE2\x80\x98",
                                                       "\xE2\x80\x99", "\xE2\x80\x9A", "\xC2\xAB",     "\xC2\xBB"};

std::string hint_of_quotes(std::string_view line) {
    std::string straight(line);
    for (const std::string_view curly : curly_quotes) {
        for (std::size_t at = straight.find(curly); at != std::string::npos; at = straight.find(curly, at + 1))
            straight.replace(at, curly.size(), 1, '"');
    }
    if (straight == line || line.size() > longest_shown) return {};
    return "quotation marks must be straight; write " + straight + " instead of " + std::string(line);
}

}  // namespace

bool is_utf16(std::string_view bytes) {
    if (bytes.size() < 2) return false;
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF") || bytes[0] == '\0' || bytes[1] == '\0';
}

std::string toml_hint(std::string_view line, std::string_view message) {
    const std::string_view content = without_blanks(line);
    std::string hint = hint_of_quotes(content);
    if (hint.empty()) hint = hint_of_assignments(content);
    if (!hint.empty()) return hint;
    if (message.find("inline table") != std::string_view::npos && message.find("\\n") != std::string_view::npos) {
        return "a table between { and } must stand on one line; join this line and those up to the }: " +
               std::string(content.substr(0, longest_shown));
    }
    return {};
}

}  // namespace nacre
