#include "nacre/base/text.h"

#include <cmath>
#include <cstddef>

#include "nacre/base/decimal.h"

namespace nacre {

std::string number_text(double value) {
    std::string text = shortest_decimal(value);
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
    return number_text(rounded_to_digits(value, digits));
}

std::string fixed_text(double value, int decimals) {
    const std::string text = fixed_decimal(value, decimals);
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
