#pragma once

#include <vector>

#include "nacre/accuracy/choose_effects.h"
#include "pipeline/decide.h"
#include "pipeline/execution.h"

namespace nacre {

/// One effect of a LUT, and what it has in the time that the texels take.
struct EffectShare {
    EffectChoice choice;
    double time_share = 0.0;  ///< of a simulated one: what they would save without it, in [0, 1]; of one that is
                              ///< left out: what it would add, over the time with it
};

/// The material's effects, simulated ones first, and of these the slowest first: found by timing a few of the LUT's
/// texels with and without each, see plan_seconds.h. The texels of a tilted surface are timed with the curve of
/// facets' colours, which deciding has made.
std::vector<EffectShare> effect_shares(const DecidedLut& lut, const Execution& execution);

}  // namespace nacre
