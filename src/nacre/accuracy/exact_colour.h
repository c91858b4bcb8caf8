#pragma once

#include <memory>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/lut/job.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"

namespace nacre {

/// Colours of single mechanisms at single geometries under one light, before adaptation.
///
/// Palettes, gratings and measured spectra are integrated in closed form. Layers and spheres are sampled at nodes whose
/// number is doubled until two counts agree to CIEDE2000 1e-4, the colour shown so that it has Y = 1. Directions from a
/// base, radii and slices err by CIEDE2000 0.001, and uneven thicknesses have the samples of spectra.h, or err by 0.05
/// if the surface is tilted, too. If the light samples, its `wavelengths` are summed instead.
/// Not to be asked by two threads at once: nodes are kept for the next colour.
class ExactColours {
public:
    /// @param light  has to outlive this
    explicit ExactColours(const Light& light) : light_(light), nodes_(std::make_shared<NodeMaker>(light.weights)) {}

    Xyz at(const Mechanism& mechanism, const Geometry& geometry);

private:
    Xyz converged(const Mechanism& mechanism, const Geometry& geometry);

    const Light& light_;
    std::shared_ptr<NodeMaker> nodes_;
};

/// One of them.
Xyz reflectance_xyz(const Mechanism& mechanism, const Geometry& geometry, const Light& light);

/// The value that texel-centre sampling at (x, y) stands for: what bake() samples, in closed form unless the light
/// samples. Coordinates in [0, 1].
Xyz exact_xyz(const Job& job, double x, double y = 0.0);

}  // namespace nacre
