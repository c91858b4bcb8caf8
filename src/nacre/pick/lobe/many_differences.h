#pragma once

#include <cstddef>

#include "nacre/colour/difference.h"

namespace nacre {

/// Colours as many_differences() takes them: cube roots of X, Y and Z over white's, and of a factor that all three are
/// dimmed by, because a factor leaves a cube root as a factor. Single precision.
struct RootColours {
    /// What SIMD registers may read past the last colour, and write past the last result.
    static constexpr std::size_t padding = 16;

    const float* x = nullptr;
    const float* y = nullptr;
    const float* z = nullptr;
    const float* factor = nullptr;
    std::size_t count = 0;  ///< the padding not counted
};

/// Squares of CIEDE2000 between one colour and many: SIMD (Highway), without a branch.
///
/// Accuracy: 1e-3 of the difference, or 1e-4; hues that are opposite to within rounding may be met from either side.
/// @param squares  receives one for every colour, and something for the padding
void many_differences(const Lab& target, const RootColours& colours, float* squares, double side = 0.0);

/// Cube roots in place, to single precision: SIMD. @param values  any finite ones
/// @param count  as for RootColours, padding may be read and written
void cube_roots(float* values, std::size_t count);

}  // namespace nacre
