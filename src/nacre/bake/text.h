#pragma once

#include <string>
#include <string_view>

namespace nacre {

/// The shortest text that reads back as the same number: "0.7", "460", "1e-06".
std::string number_text(double value);

/// As a basic string of TOML, quotes included.
std::string toml_string(std::string_view text);

}  // namespace nacre
