#pragma once

#include <cmath>

#include <glm/mat3x3.hpp>

#include "nacre/colour/colour_types.h"

namespace nacre {

/// Oklab: lightness, and two coordinates whose angle is hue and whose distance from 0 is chroma.
///
/// Grey is (lightness, 0, 0), white is (1, 0, 0). All three grow with the cube root of light, so that exposure changes
/// neither hue nor chroma / lightness.
struct Oklab {
    double lightness = 0.0;
    double a = 0.0;  ///< towards red, away from green
    double b = 0.0;  ///< towards yellow, away from blue
    friend bool operator==(const Oklab&, const Oklab&) = default;
};

/// CIE XYZ (D65, Y = 1 for white) to Oklab, by B. Ottosson, A perceptual color space for image processing (2020).
///
/// With the matrices of CSS Color 4 (w3c/csswg-drafts issue 6642), which are his with more digits: D65 as (0.3127,
/// 0.3290) becomes (1, 0, 0) within 1e-15. Any XYZ is allowed; imaginary colours have negative cones, whose cube roots
/// are negative. Not finite stays not finite.
Oklab xyz_to_oklab(Xyz colour);

/// The inverse.
Xyz oklab_to_xyz(const Oklab& colour);

/// 0 for grey.
inline double chroma_of(const Oklab& colour) {
    return std::hypot(colour.a, colour.b);
}

/// The two linear steps of the inverse, for code that works between them: XYZ = first * (second * (L, a, b))³.
const glm::dmat3& xyz_of_oklab_cones();
const glm::dmat3& oklab_roots_of_lab();

}  // namespace nacre
