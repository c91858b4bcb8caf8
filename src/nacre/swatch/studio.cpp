#include "nacre/swatch/studio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace nacre {
namespace {

// All numbers of the room are chosen by eye: a car maker's studio, in which a glossy object shows bright panels with
// clear edges, a dark horizon, and colours at every angle.
struct Softbox {
    glm::dvec3 towards, across, along;
    double half_across, half_along, luminance;
};

Softbox softbox(const glm::dvec3& towards, double half_across, double half_along, double luminance) {
    const glm::dvec3 to = glm::normalize(towards);
    const glm::dvec3 across = glm::normalize(glm::cross(glm::dvec3{0.0, 1.0, 0.0}, to));
    return {to, across, glm::cross(to, across), half_across, half_along, luminance};
}

const std::array<Softbox, 4> softboxes{
    softbox({0.18, 1.0, 0.0}, 0.75, 0.42, 0.9),    // overhead
    softbox({-0.8, 0.48, 0.95}, 0.40, 0.30, 1.0),  // key, at the upper left
    softbox({1.0, 0.05, 0.05}, 0.16, 0.55, 0.75),  // strips at the sides, for the rim
    softbox({-1.0, 0.05, -0.75}, 0.1, 0.7, 0.6),
};
constexpr double penumbra = 0.012;    // radians: the edge of a light
constexpr double edge_falloff = 0.3;  // what a light has less in its corners

constexpr double back_wall = 0.045;
constexpr double front_wall = 0.52;  // behind the camera: what the middle of a ball mirrors
constexpr double matte_wall = 0.12;  // what a matte surface sees of all walls, in the mean
constexpr double floor_behind = 0.10;
constexpr double floor_in_front = 0.36;  // out of the picture, seen in mirrors only
constexpr double floor_reach = 7.0;      // where the floor turns into the wall, in radii of the ball

// From 0 to 1 over [-width, width], a cubic: the integral of a parabola, whose standard deviation is width / sqrt(5).
double ramp(double t, double width) {
    const double x = std::clamp(t / width, -1.0, 1.0);
    return 0.5 + x * (0.75 - 0.25 * x * x);
}

double box(double t, double half, double width) {
    return ramp(t + half, width) - ramp(t - half, width);
}

double light_of(const Softbox& light, const glm::dvec3& way, double width) {
    const double ahead = glm::dot(way, light.towards);
    if (ahead < 0.05) return 0.0;
    const double across = glm::dot(way, light.across), along = glm::dot(way, light.along);
    // Most ways miss most lights: box() is 0 there.
    if (std::abs(across) > (light.half_across + width) * ahead) return 0.0;
    if (std::abs(along) > (light.half_along + width) * ahead) return 0.0;
    const double u = across / ahead / light.half_across;
    const double w = along / ahead / light.half_along;
    const double falloff = 1.0 - 0.5 * edge_falloff * std::min(u * u + w * w, 2.0);
    return light.luminance * falloff * box(u, 1.0, width / light.half_across) * box(w, 1.0, width / light.half_along);
}

double wall(const glm::dvec3& way) {
    const double front = 0.5 + 0.5 * way.z;
    return glm::mix(back_wall, front_wall, front * front);
}

// With the shade of the ball: the part of the sky above a point of the floor that the ball hides, weighted by the
// cosine, is cos / distance^2 (a sphere of radius 1; exact as long as all of it is above the floor).
double floor_at(const Ray& ray) {
    const double distance = (ray.from.y + 1.0) / std::max(-ray.way.y, 1e-6);
    const double x = ray.from.x + distance * ray.way.x;
    const double z = ray.from.z + distance * ray.way.z;
    const double from_foot = x * x + z * z;
    const double to_middle = std::sqrt(from_foot + 1.0);
    const double shade = 1.0 / (to_middle * to_middle * to_middle);
    const double far = 1.0 - std::exp(-from_foot / (floor_reach * floor_reach));
    const double lit = glm::mix(floor_behind, floor_in_front, ramp(z - 3.0, 3.0));
    return glm::mix(lit * (1.0 - shade), wall(ray.way), far);
}

}  // namespace

double studio_luminance(const Ray& ray, double blur_rad) {
    const double width = std::sqrt(5.0 * (penumbra * penumbra + blur_rad * blur_rad));
    const double above = ramp(ray.way.y, width);
    double seen = 0.0;
    if (above < 1.0) seen += (1.0 - above) * floor_at(ray);
    if (above <= 0.0) return seen;
    double sky = wall(ray.way);
    for (const Softbox& light : softboxes) sky += light_of(light, ray.way, width);
    return seen + above * sky;
}

double studio_irradiance(const glm::dvec3& normal) {
    double seen = 0.5 * (1.0 - normal.y) * floor_behind + 0.5 * (1.0 + normal.y) * matte_wall;
    for (const Softbox& light : softboxes) {
        const double solid_angle = 4.0 * light.half_across * light.half_along;
        // Large lights reach around the edge of the shade.
        const double facing = std::max(0.0, 0.25 + 0.75 * glm::dot(normal, light.towards));
        seen += light.luminance * solid_angle * facing * facing / std::numbers::pi;
    }
    return seen;
}

double checkerboard(const Ray& ray) {
    constexpr double depth = -3.0;  // chosen: some eight squares across a picture
    constexpr double side = 0.48;
    if (!(ray.way.z < 0.0)) return dark_square;
    const glm::dvec3 at = ray.from + (depth - ray.from.z) / ray.way.z * ray.way;
    const double squares = std::floor(at.x / side) + std::floor(at.y / side);
    return std::fmod(std::abs(squares), 2.0) < 0.5 ? light_square : dark_square;
}

double overcast_sky(const glm::dvec3& way) {
    return (1.0 + 2.0 * std::max(way.y, 0.0)) / 3.0;
}

}  // namespace nacre
