#pragma once

#include "nacre/accuracy/probes.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {

/// A number of points of a sum, and what it errs by: CIEDE2000 at the scale of the brightest probe.
struct ChosenCount {
    int count = 0;
    double error = 0.0;
};

// The fewest points of each sum that keep colours within a tolerance at the probes. `sampling` is what was chosen so
// far; `requested` is what the scene requests, whose error is found all the same; 0: nothing.

/// Radii of scattering spheres. @pre the job has Effect::size_spread
ChosenCount choose_radii(const Probes& probes, const SpectralSampling& sampling, double tolerance, int requested,
                         ProbeTally& tally);

/// Slices of a crystal's plane. @pre the mechanism has slices
ChosenCount choose_slices(const Probes& probes, const SpectralSampling& sampling, double tolerance, int requested,
                          ProbeTally& tally);

/// Directions of light from a base below layers. @param without  effects that the job does without
/// @pre the job has Effect::base and layers
ChosenCount choose_base_directions(const Probes& probes, const SpectralSampling& sampling, EffectSet without,
                                   double tolerance, int requested, ProbeTally& tally);

/// Samples of uneven thicknesses. @param without  effects that the job does without
/// @pre the job has Effect::thickness_spread
ChosenCount choose_thickness_samples(const Probes& probes, const SpectralSampling& sampling, EffectSet without,
                                     double tolerance, int requested, ProbeTally& tally);

}  // namespace nacre
