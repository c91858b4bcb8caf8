#pragma once

#include <optional>
#include <string>

#include "nacre/colour/colour_types.h"

namespace nacre {

/// "#rgb" or "#rrggbb", upper or lower case: components in [0, 1]; nothing for any other text.
std::optional<Rgb> parse_hex_colour(const std::string& text);

/// "#rgb" of "#rgba", "#rrggbb" of "#rrggbbaa"; empty for any other text.
std::string without_alpha(const std::string& text);

}  // namespace nacre
