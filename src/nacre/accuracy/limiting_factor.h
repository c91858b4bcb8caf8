#pragma once

#include <optional>
#include <string>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/measure.h"
#include "nacre/lut/fetch.h"

namespace nacre {

/// What a search came to know about why a bound cannot be kept.
struct SearchEnd {
    double lost_by_space = 0.0;      ///< CIEDE2000 that colours lose on their way into the colour space and back
    bool is_effort_spent = false;    ///< whether it ended because it took too long
    int most_texels = 0;             ///< that it would have tried
    std::optional<LutPoint> jump{};  ///< where no size helps, because the colour jumps
};

/// What stands in the way of a bound, and what would help: "half costs 0.07: use float".
std::string limiting_factor(const ChosenLut& chosen, const SearchEnd& end);

/// The same of a LUT that was baked and measured, and errs by more than was predicted.
std::string limiting_factor(const ChosenLut& chosen, const Measured& measured);

}  // namespace nacre
