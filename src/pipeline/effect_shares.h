#pragma once

#include <vector>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/choose_sampling.h"
#include "pipeline/execution.h"

namespace nacre {

/// One effect of a LUT, and what it has in the time that a bake takes.
struct EffectShare {
    EffectChoice choice;
    double time_share = 0.0;  ///< of a simulated one: what the bake would save without it, in [0, 1]; of one that is
                              ///< left out: what it would add, over the time with it
};

/// The material's effects, simulated ones first, and of these the slowest first: found by baking a piece of the LUT
/// with and without each.
std::vector<EffectShare> effect_shares(const ChosenLut& lut, const Execution& execution);

}  // namespace nacre
