#pragma once

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/lut/job.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"

namespace nacre {

/// Colour of a mechanism at one angle under a light, before adaptation; the exact integral of a palette, and nodes that
/// are good for CIEDE2000 0.001 of anything else, unless the light samples.
Xyz reflectance_xyz(const Mechanism& mechanism, const Geometry& geometry, const Light& light);

/// The value that texel-centre sampling at (x, y) stands for: what bake() samples, in closed form unless the light
/// samples. Coordinates in [0, 1].
Xyz exact_xyz(const Job& job, double x, double y = 0.0);

}  // namespace nacre
