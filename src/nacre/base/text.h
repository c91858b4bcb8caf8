#pragma once

#include <string>
#include <string_view>

namespace nacre {

/// The shortest text that reads back as the same number: "0.7", "460", "1e-06".
std::string number_text(double value);

/// The same of the number rounded to so many significant digits: "0.021".
/// @param digits  1 to 15
std::string significant_text(double value, int digits);

/// The number rounded to so many decimals, never "-0": "0.02", "130".
/// @pre the value is finite and below 1e15; 0 <= decimals <= 15
std::string fixed_text(double value, int decimals);

/// The same for messages: whole numbers up to 1e7 in full, "100000" where number_text() has "1e+05".
std::string limit_text(double limit);

/// As a basic string of TOML, quotes included.
std::string toml_string(std::string_view text);

}  // namespace nacre
