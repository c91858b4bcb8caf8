#include "nacre/base/text.h"

#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <system_error>

namespace nacre {

std::string number_text(double value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    std::string text(buffer, result.ptr);
    // Sixteen digits and more are a whole number that TOML's integers may not hold.
    constexpr std::size_t safe_digits = 15;
    if (text.size() > safe_digits && text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
    return text;
}

std::string limit_text(double limit) {
    constexpr double longest = 1e7;
    const bool is_whole = limit == std::floor(limit) && std::abs(limit) <= longest;
    return is_whole ? std::to_string(static_cast<int>(limit)) : number_text(limit);
}

std::string significant_text(double value, int digits) {
    char buffer[32];
    const auto written =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, digits - 1);
    double rounded = value;  // values that are not finite stay as they are
    std::from_chars(buffer, written.ptr, rounded);
    return number_text(rounded);
}

std::string fixed_text(double value, int decimals) {
    char digits[48];
    const auto [end, error] =
        std::to_chars(std::begin(digits), std::end(digits), value, std::chars_format::fixed, decimals);
    assert(error == std::errc());
    const std::string text(digits, end);
    const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
    return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::string toml_string(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (code < 0x20 || code == 0x7f) {
            constexpr std::string_view digits = "0123456789ABCDEF";
            result += "\\u00";
            result += digits[code >> 4];
            result += digits[code & 15];
        } else {
            result += c;
        }
    }
    return result + '"';
}

}  // namespace nacre
