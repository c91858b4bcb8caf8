#pragma once

#include <string>

namespace nacre {

/// What every gnuplot script loads first: terminal, letters, colours.
std::string plot_style_script();
inline constexpr const char* plot_style_file = "style.gp";

}  // namespace nacre
