#pragma once

#include <string>
#include <vector>

#include "nacre/material/mechanism.h"

namespace nacre {

/// Where the palette asks for what no surface can do, from one angle to the end of the axis.
struct ClampedRange {
    double from_deg = 0.0;
    double to_deg = 0.0;
    std::string caption;
};

/// None for what is no palette.
std::vector<ClampedRange> clamped_ranges(const Material& material);

}  // namespace nacre
