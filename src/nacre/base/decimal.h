#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace nacre {

/// Doubles as decimal text and back, the same with every standard library: those of WebAssembly know <charconv> for
/// whole numbers only.

/// The shortest text that reads back as the same number, as std::to_chars() writes it: "0.7", "1e-06".
std::string shortest_decimal(double value);

/// Rounded to so many decimals, ties by the number's exact value: "0.020".
std::string fixed_decimal(double value, int decimals);

/// Rounded to so many significant digits.
/// @param digits  1 to 17
double rounded_to_digits(double value, int digits);

/// The number that the whole text is, as std::from_chars() reads it: no blanks, no leading plus sign, "inf" and "nan"
/// among the numbers. Nothing for any other text, and for numbers that no double is near to ("1e999").
std::optional<double> read_decimal(std::string_view text);

/// The same by the C library, whose decimal sign is that of the locale: what the functions above are made of where
/// <charconv> lacks doubles. Declared for the tests, which compare the two.
namespace by_c_library {
std::string shortest_decimal(double value);
std::string fixed_decimal(double value, int decimals);
double rounded_to_digits(double value, int digits);
std::optional<double> read_decimal(std::string_view text);
}  // namespace by_c_library

}  // namespace nacre
