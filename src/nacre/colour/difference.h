#pragma once

#include <array>

#include "nacre/colour/colour_types.h"

namespace nacre {

/// CIE 1976 L*a*b*: L = 100 for the white it was made with. Values beyond [0, 100] are colours brighter than white.
struct Lab {
    double l = 0.0;
    double a = 0.0;
    double b = 0.0;
    friend bool operator==(const Lab&, const Lab&) = default;
};

/// CIE 15:2004, section 8.2.1, with the exact rationals 24/116 and 841/108 for the straight part near black, which also
/// takes what lies below 0.
/// @param white  of positive components
Lab to_lab(Xyz colour, Xyz white);
/// The other way.
Xyz from_lab(const Lab& lab, Xyz white);

/// Luminances up to this count as black, at any exposure: rounding errors of zero.
inline constexpr double black_luminance = 1e-12;

/// CIEDE2000, kL = kC = kH = 1: 1 is about a just noticeable difference.
///
/// Source: Sharma, Wu, Dalal 2005, Color Res. Appl. 30(1), 21-30, equations 2-22; symmetric in its arguments.
/// Accuracy: that article's 34 pairs to their four decimals.
double ciede2000(const Lab& one, const Lab& other);

/// The same as three parts whose squares sum to the square of ciede2000(): lightness; chroma, with half of the rotation
/// term; and the rest of hue. For optimisers that need residuals.
/// @param side  Where hues are opposite CIEDE2000 jumps, because the shorter way around the hue circle changes sides. 1
/// counts the way upwards from one's hue, -1 the way downwards, so long as either is more than 90 degrees: smooth
/// across the jump
std::array<double, 3> ciede2000_parts(const Lab& one, const Lab& other, double side = 0.0);

/// No two colours differ by more in CIEDE2000 than by so many times their Euclidean distance in L*a*b*.
///
/// S_L, S_C and S_H are 1 or more; a* is stretched by up to 1.5; and the rotation, |R_T| <= sqrt(3), turns c^2 + h^2
/// into up to 1 + sqrt(3) / 2 as much: 1.5 * sqrt(1.866) = 2.05.
inline constexpr double most_ciede2000_per_lab = 2.1;

/// How many times brighter colours are shown so that this luminance has Y = 1: colour differences depend on it. 1 for
/// black.
double display_scale(double luminance);

/// CIEDE2000 of two XYZ under D65, both shown `scale` times brighter.
double difference_at(const Xyz& one, const Xyz& other, double scale);

}  // namespace nacre
