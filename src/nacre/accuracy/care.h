#pragma once

#include "nacre/shade/spectral_sampling.h"

namespace nacre {

/// How much more careful than usual a choice is: what a LUT that errs by more than it was predicted to is chosen with.
struct Care {
    SamplingCounts least{};        ///< points of each sum that is chosen; 0: as few as do
    double share_of_texels = 1.0;  ///< of the error that texels may have otherwise
    double share_of_curve = 1.0;   ///< likewise, that the curve of a survey may have
};

}  // namespace nacre
