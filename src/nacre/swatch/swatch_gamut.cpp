#include "nacre/swatch/swatch_gamut.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "nacre/colour/rgb_space.h"

namespace nacre {
namespace {

const glm::dmat3 rec709_of_xyz = xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene"));
const glm::dmat3 xyz_of_rec709 = glm::inverse(rec709_of_xyz);

// Distances from the largest component, as its fraction; 1 is the edge of the gamut.
constexpr double untouched = 0.90;
constexpr double bend = 1.2;  // how sharply the curve turns; that of the ACES reference

// [0, untouched] to itself, the rest into [untouched, 1), smoothly and in order.
double nearer(double distance) {
    if (distance <= untouched) return distance;
    const double beyond = (distance - untouched) / (1.0 - untouched);
    return untouched + (1.0 - untouched) * beyond / std::pow(1.0 + std::pow(beyond, bend), 1.0 / bend);
}

}  // namespace

Rgb linear_rec709(Xyz colour) {
    const glm::dvec3 rgb = rec709_of_xyz * glm::dvec3{colour.x, colour.y, colour.z};
    return {rgb.x, rgb.y, rgb.z};
}

Xyz fit_to_srgb(Xyz colour) {
    const Rgb rgb = linear_rec709(colour);
    const double most = std::max({rgb.r, rgb.g, rgb.b});
    const auto fitted = [&](double component) { return most * (1.0 - nearer((most - component) / most)); };
    if (!(most > 0.0) || std::min({rgb.r, rgb.g, rgb.b}) >= (1.0 - untouched) * most) return colour;
    const glm::dvec3 xyz = xyz_of_rec709 * glm::dvec3{fitted(rgb.r), fitted(rgb.g), fitted(rgb.b)};
    return {xyz.x, xyz.y, xyz.z};
}

Image<Xyz> fit_to_srgb(const Image<Xyz>& image) {
    Image<Xyz> fitted = image;
    for (Xyz& colour : fitted) colour = fit_to_srgb(colour);
    return fitted;
}

}  // namespace nacre
