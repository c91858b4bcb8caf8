#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "nacre/bake/table.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/lobe_finder.h"

namespace nacre {

/// A pick that a scene gives as a colour, and the lobe that stands for it.
struct PickedColour {
    std::size_t pick = 0;  ///< which of the material's picks
    double angle_deg = 0.0;
    std::string text;  ///< as the user wrote it: "#3a6fd0", "[0.1, 0.2, 0.4] in lin_rec709"
    Xyz colour;        ///< relative to D65
    LobeMatch lobe;
    Where where;
};

/// "exact", or how far away the lobe is and why.
std::string match_text(const PickedColour& picked);

/// The colours of a palette as the user wrote them, and what they became: "#3a6fd0 at 0 deg: exact; ...".
std::string picked_text(const std::vector<PickedColour>& picked);

/// How the core asks for a colour's XYZ, relative to D65 and Y = 1 for the perfect reflector.
/// @param space  of the scene's OpenColorIO config; empty: its role color_picking
/// Throws Error with `where`.
using ColourReader = std::function<Xyz(const Rgb& colour, const std::string& space, const Where& where)>;

/// The lobe of a colour under the scene's light.
using LobeReader = std::function<LobeMatch(const Xyz& colour)>;

/// Reads the colour of one pick: `colour` = "#rrggbb" or [r, g, b], and `space`. Components are finite and at most
/// 65504; they may be negative or exceed 1.
/// Nothing, if the pick has no `colour`.
std::optional<PickedColour> read_picked_colour(const Table& pick, const ColourReader& read, const LobeReader& find);

}  // namespace nacre
