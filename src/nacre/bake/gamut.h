#pragma once

#include <cstddef>

#include "nacre/bake/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

/// What happens to colours that the target's primaries cannot make, i.e. to negative components.
///
/// `keep` writes them as they are: right in colour, and what a shader that renders in a wider space wants.
/// `clip` cuts at zero: shifts hue and raises luminance. `compress` desaturates along a straight line towards the grey
/// of the same luminance, just far enough: keeps Y, and hue in the chromaticity diagram.
enum class Gamut { keep, clip, compress };

/// A component below this is outside the gamut, not rounding.
///
/// OpenColorIO computes in float: components of order 1 carry some 1e-7, and a colour on the hull of the gamut (black,
/// a pure primary) lands on either side of zero by that much. Half, the file's type, resolves 1e-6 only below 0.002.
inline constexpr double gamut_tolerance = -1e-6;

struct GamutReport {
    std::size_t outside = 0;     ///< texels with a component below gamut_tolerance
    double most_negative = 0.0;  ///< the smallest component of all, 0 when none is negative
    friend bool operator==(const GamutReport&, const GamutReport&) = default;
};

/// Negative components become 0 (and -0 becomes 0).
Rgb clip_to_gamut(Rgb colour);

/// The mix of a colour with the grey of its luminance, of which no component is negative, nearest to the colour.
///
/// The luminance of the result is the colour's own: mixing is linear, so is luminance, and the grey (Y, Y, Y) has the
/// luminance Y in every linear space whose white is (1, 1, 1).
/// @param colour     linear light
/// @param luminance  Y of that colour, >= 0 (0 gives black)
Rgb compress_to_gamut(Rgb colour, double luminance);

/// How much of the image is outside.
GamutReport gamut_report(const Image<Rgb>& image);

/// Treats every pixel of the image, and reports what the image was before.
///
/// @param image  RGB of the target; linear light for `compress` (planning refuses it for encoded targets)
/// @param xyz    the same pixels before the conversion, Y = 1 for the perfect reflector; read by `compress` only
/// @pre for `compress`, both have the same size and every Y is >= 0
GamutReport fit_to_gamut(Gamut gamut, Image<Rgb>& image, const Image<Xyz>& xyz);

}  // namespace nacre
