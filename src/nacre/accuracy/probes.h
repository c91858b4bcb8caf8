#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/lut/job.h"
#include "nacre/material/effects.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/shade/spectral_sampling.h"
#include "nacre/shade/work.h"

namespace nacre {

/// A material at one point of the job's parameter axes, and the geometries at which it is probed.
struct Probe {
    Mechanism simulated;  ///< without the effects that the job does without
    Mechanism named;      ///< with every effect that the scene names
    std::vector<Geometry> geometries;
};

/// Where a job's colours are compared while its sampling is chosen. Nothing in it changes meanwhile.
struct Probes {
    const Job& job;  ///< has to outlive the probes
    /// By bands of angles. Bands that no texel is in are empty; the first never is, because its colours say how bright
    /// the material is.
    std::array<std::vector<Probe>, band_least_cos_theta.size()> bands;
    std::function<void()> after_step;  ///< called after every colour; what it throws ends the choice
    std::shared_ptr<NodeMaker> nodes;  ///< of the job's light
};

/// Even points of the parameter axes (nine, or five by five), times six angles per band of incidence, or 17 even points
/// of another quantity. In the band next to grazing there are 24 more: fringes there hit the nodes or miss them, and it
/// takes many angles to meet a bad one.
/// @param nodes  of the job's light, to be shared; null: an own one
Probes make_probes(const Job& job, std::function<void()> after_step, std::shared_ptr<NodeMaker> nodes = {});

/// What probing took so far, and the luminance of the brightest colour that was compared. Both only grow.
struct ProbeTally {
    Work work;
    double brightest = 0.0;
};

/// Effort limit of one choice, in single-film reflectances: about five seconds of the machine in configs/accuracy.md.
inline constexpr double most_probe_effort = 5e8;

/// Whether that is spent. @param per_sample  effort_per_sample() of what is probed
bool is_effort_spent(const ProbeTally& tally, double per_sample);

using Colours = std::vector<Xyz>;

/// Colours of a band's probes without facets: XYZ relative to D65.
/// @param without  effects that are left out besides those of the job
Colours colours_at(const Probes& probes, std::size_t band, const SpectralSampling& sampling, EffectSet without,
                   ProbeTally& tally);

/// The largest CIEDE2000 between colours at the same probes, shown so that the brightest colour of `other`, or of any
/// comparison before, has Y = 1. The first band is compared first, so that the others are judged at its brightness.
double largest_difference(const Colours& one, const Colours& other, ProbeTally& tally);

/// A sampling with as many nodes in all bands.
SpectralSampling with_nodes(SpectralSampling sampling, const std::shared_ptr<const SpectralNodes>& nodes);

}  // namespace nacre
