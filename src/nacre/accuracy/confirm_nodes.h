#pragma once

#include "nacre/accuracy/candidates.h"
#include "nacre/accuracy/survey.h"
#include "nacre/lut/bake.h"
#include "nacre/shade/spectral_sampling.h"
#include "nacre/shade/work.h"

namespace nacre {

struct ConfirmedNodes {
    NodeCounts counts;        ///< that texels need: those of the survey, or more
    double error = 0.0;       ///< CIEDE2000 that twice as many change of a texel; 0 where it was not looked for
    bool were_wrong = false;  ///< whether those of the survey err by more than usual, and so may what it led to
};

/// The nodes per band of angles that the texels of a LUT need: the survey's own, or so many times twice as many that
/// twice as many again change no texel by more than nodes may. Those that the scene gives stay.
///
/// Probes are few, and a resonance may lie between them. A LUT of many texels is looked at on every n-th line only.
/// @param most_error  CIEDE2000 that nodes may change of a texel, if that is less than usual
ConfirmedNodes confirm_nodes(const LutSurvey& survey, const Candidate& size, double most_error,
                             const AfterRow& after_step, Work& work);

}  // namespace nacre
