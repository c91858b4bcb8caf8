#pragma once

#include <vector>

#include "nacre/accuracy/probes.h"
#include "nacre/material/effects.h"

namespace nacre {

/// What was found out about an effect that the material has.
struct EffectChoice {
    Effect effect = Effect::dispersion;
    bool is_simulated = true;
    bool is_given = false;      ///< whether the scene says to do without
    bool is_measured = false;   ///< whether its contribution was looked for
    double contribution = 0.0;  ///< what leaving it out changes, CIEDE2000 at the scale of the brightest probe
    double share = 0.0;         ///< of the budget, up to which it is left out
    friend bool operator==(const EffectChoice&, const EffectChoice&) = default;
};

struct ChosenEffects {
    std::vector<EffectChoice> effects;  ///< of the material, in the enumeration's order
    EffectSet without;                  ///< of these, what is left out
    double error = 0.0;                 ///< of what is left out, together
};

/// Leaves out whatever changes no probe by more than its share of the budget, and finds what the effects change that
/// the scene does without.
///
/// @param sampling   its nodes, slices and radii are chosen
/// @param tolerance  CIEDE2000 of all that are left out; 0: nothing is left out but what the scene says
ChosenEffects choose_effects(const Probes& probes, const SpectralSampling& sampling, double tolerance,
                             ProbeTally& tally);

}  // namespace nacre
