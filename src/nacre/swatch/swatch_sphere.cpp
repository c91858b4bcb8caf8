#include "nacre/swatch/swatch_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/axis.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/job.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/swatch/swatch_gamut.h"

namespace nacre {
namespace {

constexpr int table_size = 1024;
constexpr int rim_samples = 4;
constexpr double wall_luminance = 0.017;  // behind the ball; about 0.14 as a display shows it
constexpr double corner_fade = 0.62;      // what the corners lose of it

const glm::dvec3 eye{0.0, 0.0, 1.0};
const glm::dvec3 up{0.0, 1.0, 0.0};
const glm::dvec3 towards_light = glm::normalize(glm::dvec3{-0.38, 0.50, 0.78});
const glm::dvec3 half_vector = glm::normalize(towards_light + eye);

Xyz operator+(Xyz a, Xyz b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Xyz operator*(double factor, Xyz colour) {
    return {factor * colour.x, factor * colour.y, factor * colour.z};
}

// Linear interpolation, as a texture unit does it. @param coordinate  on the table's axis
Xyz colour_at(const SphereTable& table, double coordinate) {
    const Image<Xyz>& colours = table.colours;
    const double position = std::clamp(coordinate, 0.0, 1.0) * (colours.width() - 1);
    const int texel = std::min(static_cast<int>(position), colours.width() - 2);
    const double rest = position - texel;
    return (1.0 - rest) * colours.at(texel, 0) + rest * colours.at(texel + 1, 0);
}

Xyz colour_at_cos(const SphereTable& table, double cos_theta) {
    return colour_at(table, std::sqrt(std::clamp(cos_theta, 0.0, 1.0)));
}

Xyz glossy_shade(const SphereTable& table, const glm::dvec3& normal) {
    const double wrapped = std::max(glm::dot(normal, towards_light) + Ball::wrap, 0.0) / (1.0 + Ball::wrap);
    const double lit = Ball::light * wrapped * wrapped;
    const double sky = Ball::surround * 0.5 * (1.0 + glm::dot(normal, up));
    return lit * colour_at_cos(table, glm::dot(normal, half_vector)) +
           sky * colour_at_cos(table, glm::dot(normal, eye));
}

// ---- lamps nearby

struct Lamp {
    glm::dvec3 at;
    double power;
};
const std::array<Lamp, 3> lamps{{{{-0.9, 1.5, 2.4}, 1.0}, {{1.5, 1.0, 2.0}, 0.55}, {{0.3, -1.3, 2.6}, 0.35}}};
const glm::dvec3 groove_axis = glm::normalize(glm::dvec3{0.18, 0.52, 0.84});

struct Lit {
    glm::dvec3 towards;  // the lamp
    double light;        // what arrives of it
};
Lit lit_at(const glm::dvec3& point, const Lamp& lamp) {
    const glm::dvec3 way = lamp.at - point;
    return {glm::normalize(way), lamp.power * glm::dot(lamp.at, lamp.at) / glm::dot(way, way)};
}

// @param b,t  along the grooves and across them
Xyz arcs(const SphereTable& table, const glm::dvec3& normal, const glm::dvec3& b, const glm::dvec3& t) {
    constexpr double width = 0.2;  // how far light strays along the grooves, of which none is quite straight
    Xyz seen;
    for (const Lamp& lamp : lamps) {
        const Lit lit = lit_at(normal, lamp);
        const double facing = glm::dot(normal, lit.towards);
        if (facing <= 0.0) continue;
        const glm::dvec3 sum = lit.towards + eye;
        const double w = glm::dot(b, sum) / width;
        // Light that only grazes the ball fades, so that arcs do not end at an edge.
        const double arc = lit.light * std::min(facing / 0.25, 1.0) * std::exp(-0.5 * w * w);
        seen = seen + arc * colour_at(table, 0.5 * std::abs(glm::dot(t, sum)));
    }
    return seen;
}

Xyz grooved_shade(const SphereTable& table, const glm::dvec3& normal) {
    const double facing = std::max(glm::dot(normal, lit_at(normal, lamps.front()).towards), 0.0);
    const double body = table.brightest * (0.045 * facing * facing + 0.006 * (1.0 + glm::dot(normal, up)));
    const Xyz seen = xyz_from_chromaticity(d65_chromaticity, body);
    const glm::dvec3 along = glm::cross(groove_axis, normal);
    if (glm::dot(along, along) < 1e-9) return seen;
    const glm::dvec3 b = glm::normalize(along);
    return seen + arcs(table, normal, b, glm::cross(b, normal));
}

Xyz scattered_shade(const SphereTable& table, const glm::dvec3& normal) {
    const Lit lit = lit_at(normal, lamps.front());
    const double in = std::max(glm::dot(normal, lit.towards), 0.0);
    const double out = std::max(glm::dot(normal, eye), 0.0);
    const double share = in + out > 0.0 ? 2.0 * in / (in + out) : 0.0;
    return (lit.light * share) * colour_at(table, 0.5 - 0.5 * glm::dot(lit.towards, eye));
}

double brightest_component(Xyz colour) {
    const Rgb rgb = linear_rec709(colour);
    return std::max({rgb.r, rgb.g, rgb.b});
}

// Falls with the square of the distance, so that it is flat behind the ball.
Xyz wall(double x, double y, int width, int height) {
    const double across = 2.0 * x / width - 1.0;
    const double down = 2.0 * y / height - 1.0;
    const double distance_squared = 0.5 * (across * across + down * down);
    return xyz_from_chromaticity(d65_chromaticity, wall_luminance * (1.0 - corner_fade * distance_squared));
}

}  // namespace

SphereTable sphere_table(const Job& job) {
    const Quantity quantity = quantity_of(job.material.mechanism);
    Job fine = job;
    fine.x = default_axis(quantity);
    fine.y.reset();
    fine.width = table_size;
    fine.height = 1;
    fine.sampling = choose_sampling(fine, {0.1, 1.0, 0.1, 0.0}).sampling;
    SphereTable table{bake(fine), quantity, 0.0};
    for (const Xyz& colour : table.colours) table.brightest = std::max(table.brightest, colour.y);
    return table;
}

Xyz sphere_shade(const SphereTable& table, double x, double y) {
    const glm::dvec3 normal{x, y, std::sqrt(std::max(0.0, 1.0 - x * x - y * y))};
    switch (table.quantity) {
        case Quantity::grating_u:
            return grooved_shade(table, normal);
        case Quantity::cos_scatter:
            return scattered_shade(table, normal);
        case Quantity::incidence:
            break;
    }
    return glossy_shade(table, normal);
}

Xyz sphere_coat(double x, double y) {
    const double cos_theta = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    const double fresnel = 0.04 + 0.96 * std::pow(1.0 - cos_theta, 5.0);  // Schlick 1994, n = 1.5
    return xyz_from_chromaticity(d65_chromaticity, fresnel * Ball::coat * 0.5 * (1.0 + y));
}

double sphere_exposure(const SphereTable& table) {
    constexpr int steps = 100;
    double brightest = 0.0;
    for (int j = -steps; j <= steps; ++j) {
        for (int i = -steps; i <= steps; ++i) {
            const double x = static_cast<double>(i) / steps;
            const double y = static_cast<double>(j) / steps;
            if (x * x + y * y > 1.0) continue;
            brightest = std::max(brightest, brightest_component(sphere_shade(table, x, y)));
        }
    }
    // First orders are so much brighter than all others that they may glare.
    const double glare = table.quantity == Quantity::grating_u ? 2.5 : 1.0;
    return brightest > 0.0 ? glare * sphere_brightest / brightest : 1.0;
}

Image<Xyz> draw_ball(const SphereTable& table, double exposure, const Ball& ball, int width, int height) {
    Image<Xyz> image(width, height);
    const auto sample = [&](double x, double y) {
        const double across = (x - ball.centre_x) / ball.radius;
        const double upwards = (ball.centre_y - y) / ball.radius;
        if (across * across + upwards * upwards > 1.0) return wall(x, y, width, height);
        return exposure * sphere_shade(table, across, upwards) + sphere_coat(across, upwards);
    };
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const double x = column + 0.5;
            const double y = row + 0.5;
            const bool is_rim = std::abs(std::hypot(x - ball.centre_x, y - ball.centre_y) - ball.radius) < 0.75;
            const int samples = is_rim ? rim_samples : 1;
            Xyz sum;
            for (int j = 0; j < samples; ++j) {
                for (int i = 0; i < samples; ++i) {
                    sum = sum + sample(column + (i + 0.5) / samples, row + (j + 0.5) / samples);
                }
            }
            image.at(column, row) = (1.0 / (samples * samples)) * sum;
        }
    }
    return image;
}

}  // namespace nacre
