#pragma once

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

/// Coordinates on a LUT's axes, each in [0, 1].
struct LutPoint {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const LutPoint&, const LutPoint&) = default;
};

/// What a shader gets for a point: linear filter, clamped, texel i at i / (N - 1). Computed in double; graphics cards
/// weigh neighbours with 8 bits, which is their own error.
Rgb fetch(const Image<Rgb>& lut, LutPoint point);

}  // namespace nacre
