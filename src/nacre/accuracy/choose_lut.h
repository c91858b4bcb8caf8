#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "nacre/accuracy/care.h"
#include "nacre/accuracy/choose_effects.h"
#include "nacre/accuracy/error_split.h"
#include "nacre/accuracy/model_curve.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/fetch.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/shade/work.h"

namespace nacre {

/// A LUT with nothing left open.
struct ChosenLut {
    PlannedLut lut;                           ///< size, format and sampling decided
    ErrorSplit predicted;                     ///< by the bake's own code, looked for at all coordinates
    std::vector<EffectChoice> effects;        ///< those of the material, and what became of each
    std::vector<LutPoint> worst;              ///< where it errs most, the worst first: measure() goes there
    double of_nodes = 0.0;                    ///< CIEDE2000 that twice as many nodes change of a texel at most
    double from_model = 0.0;                  ///< CIEDE2000 from the bake's own model at most, at all coordinates
    std::size_t model_points = 0;             ///< at so many points that was looked for
    std::shared_ptr<const ModelCurve> curve;  ///< the model's colours of a 1D LUT, where they are expensive; else null
    bool is_reached = true;                   ///< whether the request is met
    std::string limiting_factor;  ///< if not, what stands in the way and what would help: "half costs 0.07: use float"
    Work work;                    ///< what deciding took
};

/// Chooses the cheapest LUT that errs by no more than the request allows: the fewest bytes; of equals the one in half,
/// which every engine reads. Sizes are powers of two up to widest_lut_size; in 2D up to largest_lut_size, and
/// Effort::most_texels() in all.
///
/// Every candidate is baked and held against the model between its texels until one fits; those too small fail at once,
/// because the place where the last one failed is tried first. If none fits, the result is the best there is (in 2D, of
/// those up to a million texels).
///
/// An effect whose contribution at probes stays below its part of `share_of_effects` of the bound is left out, if the
/// request allows it.
/// @throws Error if the encoding has no inverse to XYZ and the request is binding
/// @param after_step  called every few hundred points; what it throws ends the search
/// @param care  how much more careful than usual the choice is
ChosenLut choose_lut(const PlannedLut& lut, const Encoding& encoding, const AfterRow& after_step = {}, Care care = {});

/// The care that the next choice takes if a LUT errs by more than its bound once it is baked: twice as many points of
/// each sum, and less left for texels by as much as the bound was missed.
/// @param care      with which it was chosen
/// @param measured  CIEDE2000 that it errs by
Care more_care(const Care& care, const ChosenLut& chosen, double measured);

}  // namespace nacre
