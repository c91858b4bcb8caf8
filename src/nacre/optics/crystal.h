#pragma once

#include "nacre/optics/layer_system.h"

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

/// The crystal as layers: a group of thin slices, whose permittivity is the mean over the plane at that height,
/// repeated once per plane.
/// @param slices  of a period, >= 2
LayerSystem layer_system(const Crystal& crystal, int slices);

}  // namespace nacre
