#pragma once

#include <string>
#include <vector>

#include "nacre/accuracy/choose_effects.h"
#include "nacre/accuracy/error_split.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/fetch.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/shade/work.h"

namespace nacre {

/// A LUT with nothing left open.
struct ChosenLut {
    PlannedLut lut;                     ///< size, format and sampling decided
    ErrorSplit predicted;               ///< by the bake's own code, looked for at all coordinates
    std::vector<EffectChoice> effects;  ///< those of the material, and what became of each
    std::vector<LutPoint> worst;        ///< where it errs most, the worst first: measure() goes there
    bool is_reached = true;             ///< whether the request is met
    std::string limiting_factor;  ///< if not, what stands in the way and what would help: "half costs 0.07: use float"
    Work work;                    ///< what deciding took
};

/// Chooses the cheapest LUT that errs by no more than the request allows: the fewest bytes; of equals the one in half,
/// which every engine reads. Sizes are powers of two up to largest_lut_size; in 2D, up to Effort::most_texels() in all.
///
/// Every candidate is baked and held against the model between its texels until one fits; those too small fail at once,
/// because the place where the last one failed is tried first. If none fits, the result is the best there is (in 2D, of
/// those up to a million texels).
///
/// An effect whose contribution at probes stays below its part of `share_of_effects` of the bound is left out, if the
/// request allows it.
/// @throws Error if the encoding has no inverse to XYZ and the request is binding
/// @param after_step  called every few hundred points; what it throws ends the search
ChosenLut choose_lut(const PlannedLut& lut, const Encoding& encoding, const AfterRow& after_step = {});

}  // namespace nacre
