#pragma once

#include <string>
#include <vector>

#include "nacre/pick/picked_colour.h"

namespace nacre {

/// One pick that is not met, and its message.
struct UnmatchedPick {
    PickedColour picked;
    std::string text;  ///< unmatched_text(); if it represents others, with their number
};

/// The picks that are not met: all of them or, if there are many, only the worst one with the number of the others.
std::vector<UnmatchedPick> unmatched_picks(const std::vector<PickedColour>& picks);

}  // namespace nacre
