#pragma once

#include <string>
#include <string_view>

namespace nacre {

/// The shortest text that reads back as the same number: "0.7", "460", "1e-06".
std::string number_text(double value);

/// The same of the number rounded to so many significant digits: "0.021".
/// @param digits  1 to 15
std::string significant_text(double value, int digits);

/// As a basic string of TOML, quotes included.
std::string toml_string(std::string_view text);

}  // namespace nacre
