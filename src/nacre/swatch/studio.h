#pragma once

#include <glm/vec3.hpp>

namespace nacre {

/// A half line: where it starts, and its direction, of length 1. y points up.
struct Ray {
    glm::dvec3 from{};
    glm::dvec3 way{};
};

/// The surroundings of the objects in pictures: a grey room with a floor at y = -1, on which a ball of radius 1 around
/// (0, 0, 0) lies, a large soft light overhead, one at the upper left and strips at both sides, all neutral.
///
/// Everything in it is a formula, so that a ray costs little and nothing is sampled at random. Luminances are relative
/// to the brightest light: a perfect mirror shows that as white.
///
///     studio = mix(floor, wall + lights; ramp(way.y)),   lights = sum of luminance * box(u) * box(w)
///     ramp: from 0 to 1 around 0; box: ramp(. + half) - ramp(. - half)
///
/// with (u, w) where the ray meets the plane of a light far away. A blur makes ramps wider.
/// @param ray       what is looked along; its start counts for the floor only
/// @param blur_rad  standard deviation of the directions that a rough surface mirrors there, >= 0
double studio_luminance(const Ray& ray, double blur_rad);

/// What a white matte surface with this normal shows in the studio: the irradiance over pi, lights and floor seen as
/// wholes.
double studio_irradiance(const glm::dvec3& normal);

/// A checkerboard behind an object that one sees through, upright and across the view: the luminance of its squares.
double checkerboard(const Ray& ray);
inline constexpr double light_square = 0.3, dark_square = 0.1;

/// The overcast sky of CIE S 011 (Moon and Spencer 1942): L = (1 + 2 sin(elevation)) / 3 of the zenith's.
double overcast_sky(const glm::dvec3& way);

}  // namespace nacre
