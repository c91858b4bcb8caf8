#include "nacre/swatch/swatch_puddle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace nacre {
namespace {

constexpr double farthest_wet = 1.25 * 1.1;  // outline and wet edge together end before that

// Chosen by eye.
constexpr double wet_edge = 0.10;      // width of the wet asphalt around the water
constexpr double dry_asphalt = 0.050;  // luminances
constexpr double wet_asphalt = 0.016;
constexpr double grain = 0.012;  // of the asphalt, and its share of the luminance
constexpr double grain_contrast = 0.75;
constexpr double winding = 0.42;  // of the bands: part of the second axis, and size
constexpr double winding_size = 0.55;
constexpr double roof_height = 0.44;  // sine of the elevation of roofs across the street
constexpr double roof_steps = 0.10;
constexpr double roof_blur = 0.02;
constexpr double house_luminance = 0.18;

// In [0, 1), without order: the finaliser of MurmurHash3 (Appleby, public domain) on two whole numbers.
double hashed(std::int64_t i, std::int64_t j) {
    std::uint64_t h = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(j);
    h = (h ^ (h >> 33U)) * 0xFF51AFD7ED558CCDU;
    h = (h ^ (h >> 33U)) * 0xC4CEB9FE1A85EC53U;
    return static_cast<double>((h ^ (h >> 33U)) >> 11U) * 0x1p-53;
}

// The next whole number below; without the call of std::floor(), which takes longer than all else in noise().
std::int64_t whole_below(double x) {
    const auto whole = static_cast<std::int64_t>(x);
    return static_cast<double>(whole) > x ? whole - 1 : whole;
}

// Value noise: smooth between the whole numbers. In [0, 1).
double noise(double x, double z) {
    const std::int64_t i = whole_below(x), j = whole_below(z);
    const auto eased = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const double a = eased(x - static_cast<double>(i));
    return glm::mix(glm::mix(hashed(i, j), hashed(i + 1, j), a), glm::mix(hashed(i, j + 1), hashed(i + 1, j + 1), a),
                    eased(z - static_cast<double>(j)));
}

double rough_noise(double x, double z) {
    return (noise(x, z) + 0.4 * noise(2.03 * x + 7.1, 2.03 * z + 1.7)) / 1.4;
}

// How far inside the outline, in its radii; negative outside; -1 far away.
double inside_puddle(double x, double z) {
    if (x * x + z * z > farthest_wet * farthest_wet) return -1.0;
    const double turn = std::atan2(z, x);
    const double outline =
        1.0 + 0.13 * std::sin(2.0 * turn + 0.6) + 0.08 * std::sin(3.0 * turn + 2.0) + 0.04 * std::sin(5.0 * turn + 4.0);
    return std::max(-1.0, 1.0 - std::hypot(x, z) / outline);
}

double ground(double x, double z, double inside) {
    const double wet = std::clamp(1.0 + inside / wet_edge, 0.0, 1.0);
    const double grains = noise(x / grain, z / grain) + 0.6 * noise(0.31 * x / grain, 0.31 * z / grain);
    return glm::mix(dry_asphalt, wet_asphalt, wet) * (1.0 + grain_contrast * (grains - 0.8));
}

// On the second axis, from the edge to the middle.
double along_flow(double x, double z, double inside) {
    const double turned = rough_noise(x / winding_size + 11.0, z / winding_size + 5.0);
    const double bent = rough_noise(x / winding_size + 3.0 * turned, z / winding_size - 2.0 * turned);
    return std::clamp(std::pow(std::clamp(inside, 0.0, 1.0), 0.8) + winding * (bent - 0.5), 0.0, 1.0);
}

// The sky, and in front of it, out of focus, a row of roofs.
double sky_above_houses(const glm::dvec3& way) {
    const double roof = roof_height + roof_steps * noise(16.0 * way.x / std::max(-way.z, 1e-6), 0.5);
    const double above = std::clamp(0.5 + (way.y - roof) / roof_blur, 0.0, 1.0);
    return glm::mix(house_luminance, overcast_sky(way), above);
}

}  // namespace

Seen look_at_puddle(const LitTable& table, const Ray& ray) {
    const double distance = -ray.from.y / ray.way.y;
    const double x = ray.from.x + distance * ray.way.x;
    const double z = ray.from.z + distance * ray.way.z;
    const double inside = inside_puddle(x, z);
    const double below = ground(x, z, inside);
    if (inside <= 0.0) return {{}, grey(below)};
    const Xyz mirrored = mirrored_at(table, -ray.way.y, along_flow(x, z, inside));
    const double sky = sky_above_houses({ray.way.x, -ray.way.y, ray.way.z});
    return {sky * mirrored, grey(below * std::max(0.0, 1.0 - mirrored.y))};
}

Camera puddle_camera() {
    return camera_at({0.0, 2.3, 3.6}, {0.0, 0.0, 0.1}, 0.30);
}

}  // namespace nacre
