#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "nacre/accuracy/choose_effects.h"
#include "nacre/lut/job.h"
#include "nacre/material/effects.h"
#include "nacre/shade/spectral_sampling.h"
#include "nacre/shade/work.h"

namespace nacre {

/// What was chosen, and the errors that were found, CIEDE2000 at the scale of the brightest probe.
struct ChosenSampling {
    SpectralSampling sampling;
    std::vector<EffectChoice> effects;  ///< of the material, in the enumeration's order
    EffectSet without;                  ///< of these, what is left out
    double error = 0.0;                 ///< of the nodes
    double spread_error = 0.0;          ///< of the number of samples of uneven thicknesses
    double quadrature_error = 0.0;      ///< of base, radii and slices together
    double effects_error = 0.0;         ///< of what is left out, together
    Work work;                          ///< that choosing took
};

/// What a choice may err by, CIEDE2000.
struct SamplingTolerance {
    double nodes = 1e-3;
    double spread = 0.1;
    double quadrature = 1e-3;  ///< each
    double effects = 0.0;      ///< of all that are left out; 0: none is
};

/// What a choice starts from.
struct SamplingRequest {
    SamplingCounts counts{};             ///< what the caller requests; 0: to be chosen
    SamplingCounts least{};              ///< of those that are chosen
    std::shared_ptr<NodeMaker> nodes{};  ///< of the job's light, to be shared; null: an own one
    bool judges_effects = true;  ///< false: what the job does without is left out, and nobody asks what it changes
};

/// The fewest nodes that keep colours within the tolerance at probes all over the job's axes (twice and three times
/// that in the two bands next to grazing; between probes they may err by half as much again), and likewise the fewest
/// points of every other sum.
///
/// The light's own `wavelengths` are taken if the scene requests them; job.without is left out, and what that changes
/// is an error like any other. A job of thousands of layers may need more than a search should take: then the search
/// ends with what it has, and tells its error.
/// @param after_step  called every few colours; what it throws ends the choice
ChosenSampling choose_sampling(const Job& job, const SamplingTolerance& tolerance, const SamplingRequest& request = {},
                               const std::function<void()>& after_step = {});

/// The same job without `wavelengths`: its spectra are integrated, and its other sums keep their counts. A job without
/// `wavelengths` is returned as it is.
Job integrated_job(Job job, const SamplingTolerance& tolerance);

/// Good for anything that is looked at: CIEDE2000 0.001, and 0.1 for the mean of uneven layers; every effect.
SpectralSampling default_sampling(const Job& job);

}  // namespace nacre
