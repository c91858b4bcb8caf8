#include "nacre/swatch/swatch_disc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "nacre/swatch/swatch_sphere.h"

namespace nacre {
namespace {

// Chosen by eye: four lamps far away, so that u changes along a spoke from 0.46 to 0.23 on one side of the middle, the
// first order of a compact disc, and from 0.74 to 0.97 on the other, that of a DVD.
const std::array<Lamp, 4> disc_lamps{
    {{{2.6, 4.05, -1.3}, 1.0}, {{-2.6, 2.85, -3.2}, 1.0}, {{-1.6, 4.75, 0.0}, 0.8}, {{1.6, 1.5, -4.5}, 0.8}}};
constexpr double stray_of_disc = 0.10;  // see grooves_seen: the lamps are as wide as that
constexpr double disc_metal = 0.09;     // what the grooved metal mirrors of the studio
constexpr double disc_glow = 0.07;      // and of a lamp, where it faces it: grooves are rough
constexpr double stray_of_glow = 0.25;
constexpr double plain_metal = 0.4;       // and the plain one
constexpr double plastic = 0.04;          // reflectance of clear plastic at its face, n = 1.5
constexpr double table_luminance = 0.05;  // what the disc lies on
constexpr double shade_width = 0.05;      // of the disc on the table

double table_seen(double radius) {
    const double beside = radius > 1.0 ? radius - 1.0 : disc_hole - radius;
    return table_luminance * (1.0 - 0.7 * std::exp(-std::max(beside, 0.0) / shade_width));
}

}  // namespace

Seen look_at_disc(const LitTable& table, const Ray& ray) {
    const glm::dvec3 point = ray.from - (ray.from.y / ray.way.y) * ray.way;
    const double radius = std::sqrt(point.x * point.x + point.z * point.z);
    if (radius < disc_hole || radius > 1.0) return {{}, grey(table_seen(radius))};
    const double sky = studio_luminance({point, {ray.way.x, -ray.way.y, ray.way.z}}, 0.0);
    if (radius < disc_metal_from || radius > disc_grooves_to) return {{}, grey(table_luminance + plastic * sky)};
    if (radius < disc_grooves_from) return {{}, grey(plain_metal * sky)};
    const glm::dvec3 across{point.x / radius, 0.0, point.z / radius};
    const glm::dvec3 along_grooves{-across.z, 0.0, across.x};
    const double along = (radius - disc_grooves_from) / (disc_grooves_to - disc_grooves_from);
    Xyz seen;
    double metal = disc_metal * sky;
    for (const Lamp& lamp : disc_lamps) {
        const Lit lit = lit_at(point, lamp);
        seen = seen + grooves_seen(table, lit, -ray.way, along_grooves, across, stray_of_disc, along);
        const double w = glm::dot(along_grooves, lit.towards - ray.way) / stray_of_glow;
        metal += disc_glow * lit.light * std::exp(-0.5 * w * w);
    }
    return {seen, grey(metal)};
}

Camera disc_camera() {
    return camera_at({0.0, 5.2, 2.6}, {0.0, 0.0, 0.03}, 0.21);
}

}  // namespace nacre
