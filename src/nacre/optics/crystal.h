#pragma once

#include "nacre/optics/layer_system.h"
#include "nacre/optics/refractive_index.h"

namespace nacre {

/// An opal (spheres in a medium) or inverse opal (holes in one): planes (111) of a face-centred cubic packing, parallel
/// to the surface.
struct Crystal {
    Index incident;
    Index sphere;                ///< what the spheres, or holes, are of
    Index medium;                ///< what is between them
    double diameter_nm = 250.0;  ///< of the spheres, > 0
    double spacing_nm = 0.0;     ///< D, between planes; 0: sqrt(2/3) of the diameter, as in touching spheres
    int planes = 30;             ///< >= 1
    Index substrate;
    double thickness_spread_nm = 0.0;  ///< standard deviation of the planes' spacing from domain to domain

    friend bool operator==(const Crystal&, const Crystal&) = default;
};

/// The distance D between planes, nm.
double plane_spacing_nm(const Crystal& crystal);

/// The part of a plane at height z that is inside spheres: circles of all planes that reach there, over the area that a
/// sphere has to itself; at most 1. Its mean over a period of touching spheres is pi / sqrt(18).
/// @param z_nm  from the centres of a plane; the profile repeats with D
double sphere_share(const Crystal& crystal, double z_nm);

/// n_eff^2 of the Bragg-Snell law m wavelength = 2 D sqrt(n_eff^2 - sin^2 theta): the mean permittivity over a period.
RefractiveIndex effective_index(const Crystal& crystal, double wavelength_nm);

/// The crystal as layers: a group of thin slices of a period, repeated once per plane.
///
/// Each two slices have the mean of the permittivity over their heights, and its first moment: of a slope that is 4/3
/// of what each slice's own mean would give (where that leaves room). Then waves agree to the fourth order of the
/// slices' height rather than to the second, for s-polarised light, and nearly so for p: both have the first two terms
/// of Magnus's expansion, which are these moments (Blanes, Casas, Oteo & Ros 2009, Physics Reports 470, 151, section
/// 5).
/// @param slices  of a period; 4, 8, 12, ...
LayerSystem layer_system(const Crystal& crystal, int slices);

}  // namespace nacre
