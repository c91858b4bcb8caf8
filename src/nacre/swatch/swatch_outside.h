#pragma once

#include <functional>
#include <string>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// The colour space of the LUTs of a scene, for pictures of LUTs, because the core has no OpenColorIO.
struct LutSpace {
    std::string name;
    std::function<Image<Rgb>(const Image<Xyz>&)>
        to_rgb;  ///< before the gamut rule; empty: the picture does not show it
};

/// What the mark of a strip is: a bar along its lower edge, and air between it and the colours.
inline constexpr double outside_bar_px = 5.0;
inline constexpr double outside_air_px = 3.0;

/// Shows where a LUT leaves its space, that is, where a component is below gamut_tolerance: with a bar along the lower
/// edge of a strip, with hatching in a picture of two axes; and says below the picture how much that is.
///
/// Nothing is drawn where nothing is outside. Else the picture becomes higher by a line of text.
/// @param colours    the panel's, before any exposure
/// @param is_strip   whether all rows are alike
/// @throws whatever the space does
void draw_outside(Swatch& swatch, const PlotArea& area, const Image<Xyz>& colours, bool is_strip,
                  const LutSpace& space);

/// The same hatching on a panel of one colour, without a caption.
/// @return whether the colour is outside
bool draw_outside_patch(Swatch& swatch, const Panel& panel, const LutSpace& space);

}  // namespace nacre
