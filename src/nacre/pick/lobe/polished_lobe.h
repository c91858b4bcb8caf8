#pragma once

#include "nacre/base/least_squares.h"
#include "nacre/colour/difference.h"
#include "nacre/pick/lobe/lobe_colours.h"
#include "nacre/pick/lobe/nearest_downhill.h"

namespace nacre {

/// The lobe with its square by exact colours rather than by fast ones. What lies so near to the opposite hue, where
/// CIEDE2000 jumps, that rounding decides on which side is judged by the worse.
DimmedLobe judged_exactly(const LobeColours& colours, const Lab& target, DimmedLobe lobe);

/// Whether exact colours bear out what a walk said of its end, to a hundredth of the difference.
inline bool is_kept(const DimmedLobe& promised, const DimmedLobe& exact) {
    constexpr double most = 1.02, rounding = 1e-4;
    return exact.square <= most * promised.square + rounding;
}

/// Where least squares with exact colours lead from a lobe. What they come near they reach to as many digits as they
/// have, and they follow a flat, bent valley to its end, where nearest_downhill() comes to rest. Some 20 microseconds.
/// @return never further than `start`; its square by exact colours
DimmedLobe polished_lobe(const LobeColours& colours, const LeastSquaresSolver& solve, const Lab& target,
                         const DimmedLobe& start);

}  // namespace nacre
