#pragma once

#include "pipeline/baked_lut.h"
#include "pipeline/decide.h"
#include "pipeline/execution.h"

namespace nacre {

/// Bakes the LUT that was decided.
///
/// If it errs by more than was predicted it is decided again with more care, up to three times, and the best is kept:
/// then `decided` is that choice. Not so of a pair, which must stay one: that was measured when it was decided.
/// @pre decided.failure is empty
/// @throws Error if the space or the format cannot hold the colours
BakedLut bake_within_bound(DecidedLut& decided, const Execution& execution);

}  // namespace nacre
