#include "nacre/swatch/swatch_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

namespace nacre {
namespace {

constexpr double grazing_cos = 0.5;  // from 60 degrees on the rim may be brighter than white

// Chosen by eye: for lights on two sides of the ball and one below.
const std::array<Lamp, 3> ball_lamps{{{{-0.9, 1.5, 2.4}, 1.0}, {{1.5, 1.0, 2.0}, 0.55}, {{0.3, -1.3, 2.6}, 0.35}}};
constexpr double room_light = 0.35;  // what scatters of the studio, as if all of it came from the side
constexpr double turned_across = 0.5;
constexpr double dull_metal = 0.3;     // what a ruled metal mirrors straight, about
constexpr double stray_of_ball = 0.2;  // see grooves_seen
const glm::dvec3 groove_axis = glm::normalize(glm::dvec3{0.18, 0.52, 0.84});

// Where a ray enters and leaves the ball.
struct Chord {
    glm::dvec3 enters, leaves;
};
std::optional<Chord> chord_of(const Ray& ray) {
    const double middle = -glm::dot(ray.from, ray.way);
    const double half_squared = 1.0 + middle * middle - glm::dot(ray.from, ray.from);
    if (half_squared < 0.0 || middle < 0.0) return {};
    const double half = std::sqrt(half_squared);
    return Chord{ray.from + (middle - half) * ray.way, ray.from + (middle + half) * ray.way};
}

// On the second axis: 0 at the upper pole, 1 at the lower one.
double along_meridian(const LitTable& table, const glm::dvec3& point) {
    if (!table.second && table.mirrored.height() == 1) return 0.0;
    return 0.5 - std::asin(std::clamp(point.y, -1.0, 1.0)) * std::numbers::inv_pi;
}

Ray mirrored_ray(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& way) {
    return {point, way - 2.0 * glm::dot(way, normal) * normal};
}

Xyz glossy(const LitTable& table, const glm::dvec3& normal, const Ray& ray) {
    const double cos_theta = -glm::dot(normal, ray.way);
    const double along = along_meridian(table, normal);
    const double light = studio_luminance(mirrored_ray(normal, normal, ray.way), blur_rad(table, along));
    const Xyz mirrored = light * mirrored_at(table, cos_theta, along);
    if (table.scattered.size() == 0) return mirrored;
    const double coordinate = std::sqrt(std::clamp(cos_theta, 0.0, 1.0));
    return mirrored + studio_irradiance(normal) * colour_at(table.scattered, coordinate, along);
}

Xyz grooved(const LitTable& table, const glm::dvec3& normal, const Ray& ray) {
    const glm::dvec3 tangent = glm::cross(groove_axis, normal);
    if (glm::dot(tangent, tangent) < 1e-9) return {};
    const glm::dvec3 b = glm::normalize(tangent);
    Xyz seen;
    for (const Lamp& lamp : ball_lamps) {
        Lit lit = lit_at(normal, lamp);
        // Light that only grazes the ball fades, so that arcs do not end at an edge.
        lit.light *= std::clamp(glm::dot(normal, lit.towards) / 0.25, 0.0, 1.0);
        seen = seen + grooves_seen(table, lit, -ray.way, b, glm::cross(b, normal), stray_of_ball,
                                   along_meridian(table, normal));
    }
    return seen;
}

// max(cos, 0) with a soft edge of the shade, as of a large lamp: a parabola from -soft to soft.
double facing(double cos_lamp) {
    constexpr double soft = 0.3;
    if (cos_lamp >= soft) return cos_lamp;
    const double above = std::max(cos_lamp + soft, 0.0);
    return above * above / (4.0 * soft);
}

Xyz scattered(const LitTable& table, const glm::dvec3& normal, const Ray& ray) {
    const Lit lit = lit_at(normal, ball_lamps.front());
    const double in = facing(glm::dot(normal, lit.towards));
    const double out = std::max(-glm::dot(normal, ray.way), 0.0);
    const double share = in + out > 0.0 ? 2.0 * in / (in + out) : 0.0;
    const double turned = 0.5 + 0.5 * glm::dot(lit.towards, ray.way);
    const double along = along_meridian(table, normal);
    return (lit.light * share) * colour_at(table.mirrored, turned, along) +
           (room_light * studio_irradiance(normal)) * colour_at(table.mirrored, turned_across, along);
}

Xyz studio_grey(const Ray& ray) {
    return grey(studio_luminance(ray, 0.0));
}

// What is seen where nothing is in the way.
double background(const LitTable& table, const Ray& ray) {
    return table.through.size() > 0 ? checkerboard(ray) : studio_luminance(ray, 0.0);
}

// What a wall lets through; if nobody says so, all that it does not mirror.
Xyz let_through(const LitTable& table, const Xyz& m, double cos_theta, double along) {
    if (table.through.size() > 0) return colour_at(table.through, std::sqrt(std::clamp(cos_theta, 0.0, 1.0)), along);
    return {std::max(0.0, d65_white.x - m.x), std::max(0.0, d65_white.y - m.y), std::max(0.0, d65_white.z - m.z)};
}

// Light through two walls, between which it goes to and fro: t^2 / (white^2 - m^2), times the light.
Xyz shining_through(double light, const Xyz& m, const Xyz& t) {
    const auto part = [&](double white, double mirrored, double passes) {
        const double kept = white > mirrored ? std::min(passes / (white - mirrored), 1.0) : 1.0;
        return light * white * passes / (white + mirrored) * kept;
    };
    return {part(d65_white.x, m.x, t.x), part(d65_white.y, m.y, t.y), part(d65_white.z, m.z, t.z)};
}

}  // namespace

Camera ball_camera() {
    return camera_at({0.0, 0.8, 7.0}, {0.0, -0.03, 0.0}, 0.192);
}

Lit lit_at(const glm::dvec3& point, const Lamp& lamp) {
    const glm::dvec3 way = lamp.at - point;
    return {glm::normalize(way), lamp.power * glm::dot(lamp.at, lamp.at) / glm::dot(way, way)};
}

Xyz grooves_seen(const LitTable& table, const Lit& lit, const glm::dvec3& towards_eye, const glm::dvec3& along_grooves,
                 const glm::dvec3& across_grooves, double straying, double along) {
    const glm::dvec3 sum = lit.towards + towards_eye;
    const double w = glm::dot(along_grooves, sum) / straying;
    constexpr double unseen = 32.0;  // exp(-16) is 1e-7
    if (w * w > unseen) return {};
    const double u = std::abs(glm::dot(across_grooves, sum));
    return (lit.light * std::exp(-0.5 * w * w)) * colour_at(table.mirrored, 0.5 * u, along);
}

Seen look_at_ball(const LitTable& table, const Ray& ray) {
    const std::optional<Chord> chord = chord_of(ray);
    if (!chord) return {{}, grey(background(table, ray))};
    const glm::dvec3& normal = chord->enters;
    const double cos_theta = -glm::dot(normal, ray.way);
    if (table.through.size() > 0) {
        const Xyz passes = let_through(table, {}, cos_theta, along_meridian(table, normal));
        return {checkerboard(ray) * passes, {}, cos_theta < grazing_cos};
    }
    switch (table.quantity) {
        case Quantity::grating_u:
            return {grooved(table, normal, ray), dull_metal * studio_grey(mirrored_ray(normal, normal, ray.way))};
        case Quantity::cos_scatter:
            return {scattered(table, normal, ray)};
        case Quantity::incidence:
            break;
    }
    return {glossy(table, normal, ray), {}, cos_theta < grazing_cos};
}

Seen look_at_bubble(const LitTable& table, const Ray& ray) {
    const std::optional<Chord> chord = chord_of(ray);
    if (!chord) return {{}, grey(background(table, ray))};
    const double cos_theta = -glm::dot(chord->enters, ray.way);
    const auto wall_seen = [&](const glm::dvec3& point) {
        const double along = along_meridian(table, point);
        return studio_luminance(mirrored_ray(point, point, ray.way), blur_rad(table, along)) *
               mirrored_at(table, cos_theta, along);
    };
    const double along = along_meridian(table, chord->enters);
    const Xyz front = mirrored_at(table, cos_theta, along);
    const Xyz passes = let_through(table, front, cos_theta, along);
    return {wall_seen(chord->enters) + passes.y * passes.y * wall_seen(chord->leaves),
            shining_through(background(table, ray), front, passes), cos_theta < grazing_cos};
}

}  // namespace nacre
