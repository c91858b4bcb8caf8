#pragma once

#include <string_view>

#include "nacre/colour/oklab.h"

namespace nacre {

/// What people call a hue: "red", "orange", "yellow", "green", "cyan", "blue", "purple", "magenta" or "pink".
///
/// It is the one of these colours, as CSS Color 4 defines their names, whose hue in Oklab is nearest. Of a colour
/// without chroma it means nothing.
std::string_view hue_name(const Oklab& colour);

/// "white", "grey" or "black", by the lightness alone.
std::string_view grey_name(const Oklab& colour);

}  // namespace nacre
