#pragma once

#include <cstddef>
#include <string>

#include "nacre/base/image.h"
#include "nacre/lut/colour_space.h"

namespace nacre {

/// The texels of a LUT as a picture for a display.
struct LutPng {
    std::string bytes;        ///< a PNG of 16 bits per component
    std::size_t clamped = 0;  ///< texels that the display cannot show: a component was outside [0, 1]
};

/// One pixel per texel, in the rows of the EXR. For programs that show pictures; a shader needs linear numbers.
/// @param texels  as stored, in the LUT's space
/// @pre space.has_inverse()
LutPng lut_png(const Image<Rgb>& texels, const ColourSpace& space, const ColourSpace& display);

/// Whether its numbers are those of an sRGB display.
bool is_srgb_display(const ColourSpace& display);

}  // namespace nacre
