#pragma once

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/job.h"
#include "nacre/material/geometry.h"
#include "nacre/scene/plan.h"

namespace nacre {

/// A ball in front of a dark wall, seen from far away along -z; y points up, x right.
///
/// With n the normal, v the direction of the eye, l that of a large soft light, h the half vector of v and l, and
/// C(cos) the colour that the material has at that angle:
///
///     XYZ = exposure * ( light * f(n.l)^2 * C(n.h)  +  surround * (1 + n.up) / 2 * C(n.v) )  +  coat
///     f(c) = max(c + wrap, 0) / (1 + wrap)
///     coat = fresnel(n.v) * 0.18 * (1 + n.up) / 2, white
///
/// The first term is the form in which a shader uses the LUT for one light (the paper's figures 15 and 16), with a soft
/// edge of the shade. The second is a sky that each point mirrors at its own angle, so that the colours go on to the
/// rim and into the shade. The third, a faint gloss of the same sky, keeps a ball round whose material is black at
/// grazing angles; it does not take part in the exposure.
/// Gratings and scattering layers are lit by lamps nearby, because what they show depends on two directions:
///
///     grating     light / distance^2 * g(w) * C(u)  +  body,   u = |t.(l + v)|, w = b.(l + v), g a Gaussian
///     scattering  light / distance^2 * n.l / (n.l + n.v) * 2 C(-l.v)      (Lommel and Seeliger)
///
/// with l towards the lamp from each point, b along the grooves, which are circles around an axis that leans towards
/// the eye, t across them; body is the dull grey of the metal, without which only a few arcs in the dark would be
/// visible. A grating has three lamps, for more arcs; scattering one.
struct Ball {
    double centre_x = 0.0;  ///< pixels
    double centre_y = 0.0;
    double radius = 1.0;

    static constexpr double light = 1.0;
    static constexpr double wrap = 0.35;
    static constexpr double surround = 0.2;
    static constexpr double coat = 0.18;
};

/// Colours over the default axis of what they depend on, finely enough for linear interpolation.
struct SphereTable {
    Image<Xyz> colours;
    Quantity quantity = Quantity::incidence;
    double brightest = 1.0;  ///< luminance
};
SphereTable sphere_table(const Job& job);

/// What the unexposed formula gives at a point of the ball.
/// @param x,y  in units of the radius, y up
/// @pre x^2 + y^2 <= 1
Xyz sphere_shade(const SphereTable& table, double x, double y);

/// The gloss: neutral, the same for all materials.
Xyz sphere_coat(double x, double y);

/// The factor that makes the brightest component of the ball, in linear Rec.709, `sphere_brightest`; 1 for a black
/// ball. Of gratings 2.5 times that: their first orders glare.
double sphere_exposure(const SphereTable& table);
inline constexpr double sphere_brightest = 0.92;

/// The whole picture: the ball with a smooth rim (4 x 4 samples where a pixel is both ball and wall), and the wall, a
/// neutral dark grey that fades towards the corners.
Image<Xyz> draw_ball(const SphereTable& table, double exposure, const Ball& ball, int width, int height);

}  // namespace nacre
