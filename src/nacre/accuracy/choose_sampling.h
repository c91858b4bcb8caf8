#pragma once

#include <functional>
#include <vector>

#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/material/effects.h"
#include "nacre/shade/spectral_sampling.h"
#include "nacre/shade/work.h"

namespace nacre {

/// What was found out about an effect that the material has.
struct EffectChoice {
    Effect effect = Effect::dispersion;
    bool is_simulated = true;
    bool is_given = false;      ///< whether the scene says to do without
    bool is_measured = false;   ///< whether anybody looked
    double contribution = 0.0;  ///< what leaving it out changes, CIEDE2000 at the scale of the brightest probe
    double share = 0.0;         ///< of the budget, up to which it is left out
    friend bool operator==(const EffectChoice&, const EffectChoice&) = default;
};

/// What was chosen, and what it was seen to err by, CIEDE2000 at the scale of the brightest probe.
struct ChosenSampling {
    SpectralSampling sampling;
    std::vector<EffectChoice> effects;  ///< of the material, in the enumeration's order
    EffectSet without;                  ///< of these, what is left out
    double error = 0.0;                 ///< of the nodes
    double spread_error = 0.0;          ///< of how many realisations uneven layers have
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

/// What a caller insists on; 0: to be chosen.
struct SamplingWish {
    NodeCounts nodes{};
    int realisations = 0;
    QuadratureWish points;
};

/// The fewest nodes that keep colours within the tolerance at probes all over the job's axes (twice and three times
/// that in the two bands next to grazing; between probes they may err by half as much again), and likewise the fewest
/// points of every other sum.
///
/// First a layer whose fringes are fine beside everything else in the spectrum is taken as incoherent, if that is seen
/// to change nothing that counts. Nodes start at two per fringe, and grow until more of them change nothing that
/// counts. Then every effect is left out for once: whatever changes no probe by more than its part of `effects` is left
/// out for good. Then come realisations, radii and directions below a base. The light's own `wavelengths` are
/// taken if the scene insists on them; job.without is left out, and what that changes is an error like any other.
/// Thousands of layers may want more than a search should take: then it ends with what it has, and tells its error.
/// @param after_step  called every few colours; what it throws ends the choice
ChosenSampling choose_sampling(const Job& job, const SamplingTolerance& tolerance, const SamplingWish& wish = {},
                               const std::function<void()>& after_step = {});

/// Good for anything that is looked at: CIEDE2000 0.001, and 0.1 for the mean of uneven layers; every effect.
SpectralSampling default_sampling(const Job& job);

}  // namespace nacre
