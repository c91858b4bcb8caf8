#pragma once

#include <memory>
#include <optional>
#include <string>

#include "nacre/colour/light.h"
#include "nacre/lut/axis.h"
#include "nacre/material/effects.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {

/// One image of XYZ: everything that bake() needs, with all names resolved and all defaults chosen.
struct Job {
    Material material;
    std::shared_ptr<const Light> light;
    Axis x = default_axis();
    std::optional<Axis> y;
    int width = 256;
    int height = 1;             ///< 1 without y
    Geometry fixed;             ///< where neither axis is the angle
    SpectralSampling sampling;  ///< of everything that is no closed form
    EffectSet without;          ///< effects of the material that are not simulated

    /// Whether an axis is the angle; else all texels are seen under `fixed`.
    bool has_angle() const { return x.is_angle() || (y && y->is_angle()); }
    /// Whether an axis is a number of the material, so that its mechanism differs from texel to texel.
    bool moves_material() const { return !x.is_angle() || (y && !y->is_angle()); }
};

/// The material as it is at one point of the parameter axes, with all that the scene says.
Mechanism mechanism_at(const Job& job, double x, double y);

/// The same without the effects that the job does without.
Mechanism simulated_at(const Job& job, double x, double y);

/// Where light and eye are at one point of the axes.
Geometry geometry_at(const Job& job, double x, double y);

/// The effects that the job's material has anywhere on the axes.
EffectSet effects_in(const Job& job);

/// "256 x 1".
std::string size_text(const Job& job);

/// How the job's spectra become XYZ: "exact", "48 nodes", "48 nodes x 256", "471 wavelengths".
std::string integration_text(const Job& job);

}  // namespace nacre
