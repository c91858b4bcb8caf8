#include "nacre/base/decimal.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace nacre {
namespace by_c_library {
namespace {

// So many digits tell every double from its neighbours.
constexpr int most_digits = 17;

std::string printed(const char* format, int precision, double value) {
    std::array<char, 400> text{};  // the largest double has 309 digits before the point
    const int length = std::snprintf(text.data(), text.size(), format, precision, value);
    return {text.data(), static_cast<std::size_t>(length)};
}

// "-1.25e+01" as "-12.5": the digits, and a point and zeros where they belong.
std::string without_exponent(const std::string& scientific, int exponent) {
    const std::string sign = scientific.front() == '-' ? "-" : "";
    std::string digits = scientific.substr(sign.size(), scientific.find('e') - sign.size());
    std::erase(digits, '.');
    if (exponent < 0) return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
    const auto whole = static_cast<std::size_t>(exponent) + 1;
    if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0');
    return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

}  // namespace

std::string shortest_decimal(double value) {
    if (!std::isfinite(value))
        return std::isnan(value) ? (std::signbit(value) ? "-nan" : "nan") : value < 0 ? "-inf" : "inf";
    std::string scientific;
    for (int digits = 1; digits <= most_digits; ++digits) {
        scientific = printed("%.*e", digits - 1, value);
        if (std::strtod(scientific.c_str(), nullptr) == value) break;
    }
    const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
    // Where both are equally long, std::to_chars() prefers the one without an exponent, and writes whole numbers
    // exactly.
    const std::string plain = without_exponent(scientific, exponent);
    if (plain.size() > scientific.size()) return scientific;
    return plain.find('.') == std::string::npos ? printed("%.*f", 0, value) : plain;
}

std::string fixed_decimal(double value, int decimals) {
    return printed("%.*f", decimals, value);
}

double rounded_to_digits(double value, int digits) {
    return std::strtod(printed("%.*e", digits - 1, value).c_str(), nullptr);
}

std::optional<double> read_decimal(std::string_view text) {
    // What the C library reads beyond std::from_chars(): blanks, a plus sign, hexadecimal numbers.
    if (text.empty() || text.find_first_of(" \t\n\v\f\rxX") != std::string_view::npos || text.front() == '+')
        return std::nullopt;
    const std::string copy(text);
    char* end = nullptr;
    const double value = std::strtod(copy.c_str(), &end);
    if (end != copy.c_str() + copy.size()) return std::nullopt;
    const bool is_named = copy.find_first_of("iInN") != std::string::npos;
    if (std::isinf(value) && !is_named) return std::nullopt;
    if (value == 0.0 && copy.find_first_of("123456789") < copy.find_first_of("eE")) return std::nullopt;
    return value;
}

}  // namespace by_c_library

#ifdef __cpp_lib_to_chars

std::string shortest_decimal(double value) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string fixed_decimal(double value, int decimals) {
    std::array<char, 400> text{};
    return {text.data(),
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr};
}

double rounded_to_digits(double value, int digits) {
    std::array<char, 32> text{};
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
    double rounded = value;  // values that are not finite stay as they are
    std::from_chars(text.data(), written.ptr, rounded);
    return rounded;
}

std::optional<double> read_decimal(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

#else

std::string shortest_decimal(double value) {
    return by_c_library::shortest_decimal(value);
}
std::string fixed_decimal(double value, int decimals) {
    return by_c_library::fixed_decimal(value, decimals);
}
double rounded_to_digits(double value, int digits) {
    return by_c_library::rounded_to_digits(value, digits);
}
std::optional<double> read_decimal(std::string_view text) {
    return by_c_library::read_decimal(text);
}

#endif

}  // namespace nacre
