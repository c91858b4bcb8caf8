#pragma once

#include <array>

namespace nacre::reference {

/// Relative to D65, Y = 1 for the perfect reflector.
struct ModelXyz {
    double x = 0.0, y = 0.0, z = 0.0;
};
/// CIE 1976 L*, a*, b*.
struct ModelLab {
    double l = 0.0, a = 0.0, b = 0.0;
};
/// Linear R, G, B of Rec.709: (1, 1, 1) is D65 at Y = 1. Negative outside its gamut.
using ModelRgb = std::array<double, 3>;

ModelRgb to_rec709(const ModelXyz& colour);
ModelXyz from_rec709(const ModelRgb& rgb);

/// From R, G, B in [0, 1] as a screen takes them: IEC 61966-2-1.
ModelXyz from_srgb(const ModelRgb& encoded);
/// Linear P3 with the white D65 (SMPTE EG 432-1), and ACEScg (S-2014-004, adapted from its own white by Bradford).
ModelXyz from_p3d65(const ModelRgb& rgb);
ModelXyz from_acescg(const ModelRgb& rgb);

/// Oklab's lightness, a and b, with the matrices that Ottosson printed (A perceptual color space for image processing,
/// 2020): ten digits.
std::array<double, 3> oklab_of(const ModelXyz& colour);

/// White (0.3127, 0.3290) at Y = 1. The straight part of the curve goes on below 0.
ModelLab lab_of(const ModelXyz& colour);

/// CIEDE2000 with kL = kC = kH = 1: Sharma, Wu, Dalal 2005, Color Res. Appl. 30(1), equations 2 to 22.
double ciede2000(const ModelLab& one, const ModelLab& two);

/// CIEDE2000 of two colours, both multiplied by a scale.
double difference(const ModelXyz& one, const ModelXyz& two, double scale);

/// The scale at which a colour of this brightness has Y = 1; without light 1.
inline double scale_of_brightest(double brightest_y) {
    return brightest_y > 0.0 ? 1.0 / brightest_y : 1.0;
}

/// sum + share * colour
inline ModelXyz plus(const ModelXyz& sum, double share, const ModelXyz& colour) {
    return {sum.x + share * colour.x, sum.y + share * colour.y, sum.z + share * colour.z};
}

}  // namespace nacre::reference
