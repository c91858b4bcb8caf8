#pragma once

#include <functional>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/formats.h"

namespace nacre {

/// What lies between XYZ and the numbers in a texture, and how to get back: the front end's colour space, gamut rule
/// and number formats. All may be called from several threads.
struct Encoding {
    /// XYZ (white D65, Y = 1 for the perfect reflector) to components of the texture's colour space, gamut rule
    /// applied.
    std::function<Image<Rgb>(const Image<Xyz>&)> to_rgb;
    /// Back, for what a shader has fetched. Empty for a space with no way back: then errors cannot be known.
    std::function<Image<Xyz>(const Image<Rgb>&)> to_xyz;
    /// The number that a component is stored as.
    std::function<double(double, PixelFormat)> stored;
    /// Whether to_xyz undoes to_rgb: not so where a gamut rule changes colours.
    bool keeps_colours = true;
};

}  // namespace nacre
