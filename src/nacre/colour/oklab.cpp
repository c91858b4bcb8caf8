#include "nacre/colour/oklab.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace nacre {
namespace {

// glm's constructor takes columns; the numbers are written in rows, as they are published.
const glm::dmat3 cones_of_xyz = glm::transpose(glm::dmat3{
    0.8190224379967030, 0.3619062600528904, -0.1288737815209879,  // long
    0.0329836539323885, 0.9292868615863434, 0.0361446663506424,   // medium
    0.0481771893596242, 0.2642395317527308, 0.6335478284694309,   // short
});
const glm::dmat3 lab_of_roots = glm::transpose(glm::dmat3{
    0.2104542683093140, 0.7936177747023054, -0.0040720430116193,  // lightness
    1.9779985324311684, -2.4285922420485799, 0.4505937096174110,  // a
    0.0259040424655478, 0.7827717124575296, -0.8086757549230774,  // b
});
// Inverted here rather than copied, so that there and back is the same within rounding.
const glm::dmat3 xyz_of_cones = glm::inverse(cones_of_xyz);
const glm::dmat3 roots_of_lab = glm::inverse(lab_of_roots);

}  // namespace

Oklab xyz_to_oklab(Xyz colour) {
    const glm::dvec3 cones = cones_of_xyz * glm::dvec3{colour.x, colour.y, colour.z};
    const glm::dvec3 lab = lab_of_roots * glm::dvec3{std::cbrt(cones.x), std::cbrt(cones.y), std::cbrt(cones.z)};
    return {lab.x, lab.y, lab.z};
}

Xyz oklab_to_xyz(const Oklab& colour) {
    const glm::dvec3 roots = roots_of_lab * glm::dvec3{colour.lightness, colour.a, colour.b};
    const glm::dvec3 xyz = xyz_of_cones * (roots * roots * roots);
    return {xyz.x, xyz.y, xyz.z};
}

const glm::dmat3& xyz_of_oklab_cones() {
    return xyz_of_cones;
}

const glm::dmat3& oklab_roots_of_lab() {
    return roots_of_lab;
}

}  // namespace nacre
