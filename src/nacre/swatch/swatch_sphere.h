#pragma once

#include "nacre/swatch/lit_picture.h"
#include "nacre/swatch/lit_table.h"

namespace nacre {

/// A ball of radius 1 around (0, 0, 0), in the studio.
///
/// With n the normal, v the direction of the eye, r = 2 (n.v) n - v, m the colours that the material mirrors and s what
/// its base scatters:
///
///     XYZ = m(n.v) * studio(r) + s(n.v) * irradiance(n) / pi
///
/// The second axis of the material runs from the upper pole, its first value, along the surface to the lower one.
/// Facets blur what is mirrored.
/// Gratings and scattering layers are lit by lamps nearby, because what they show depends on two directions:
///
///     grating     light / distance^2 * g(w) * C(u)  +  body,   u = |t.(l + v)|, w = b.(l + v), g a Gaussian
///     scattering  light / distance^2 * n.l / (n.l + n.v) * 2 C(-l.v)  +  room * C(0)   (Lommel and Seeliger)
///
/// with l towards the lamp from each point, b along the grooves, which are circles around an axis that leans towards
/// the eye, t across them; body is the metal, which mirrors the studio. A grating has three lamps, for more arcs;
/// scattering a large one, at the edge of whose light n.l fades smoothly, and the room: irradiance / pi, as if all of
/// it came from the side.
///
/// Of a transmittance t it is no mirror: a checkerboard is seen through its front, t(n.v) times as bright.
Seen look_at_ball(const LitTable& table, const Ray& ray);

/// A hollow ball with thin walls, such as a soap bubble: both walls mirror the studio, and what they do not reflect
/// shines through. With m of two walls that take nothing, between which light goes to and fro, (1 - m) / (1 + m) goes
/// through; taken for X, Y and Z alike. What shines through is shown as it is at exposure 0. Of a transmittance t it is
/// a checkerboard that shines through, t^2 / (1 - m^2) times as bright.
/// @pre the material depends on the angle of incidence
Seen look_at_bubble(const LitTable& table, const Ray& ray);

/// In front of the ball, a little above.
Camera ball_camera();

/// A lamp, and what arrives of it.
struct Lamp {
    glm::dvec3 at{};
    double power = 1.0;
};
struct Lit {
    glm::dvec3 towards{};  ///< the lamp, length 1
    double light = 0.0;    ///< power at the distance of (0, 0, 0)
};
Lit lit_at(const glm::dvec3& point, const Lamp& lamp);

/// What grooves show of a lamp at a point.
/// @param towards_eye  length 1
/// @param along_grooves,across_grooves  of length 1, in the surface
/// @param straying  how far light leaves the plane across the grooves, of which none is quite straight
Xyz grooves_seen(const LitTable& table, const Lit& lit, const glm::dvec3& towards_eye, const glm::dvec3& along_grooves,
                 const glm::dvec3& across_grooves, double straying, double along);

}  // namespace nacre
