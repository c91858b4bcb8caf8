#pragma once

#include <string>
#include <vector>

#include "nacre/pick/picked_colour.h"

namespace nacre {

/// One pick that is not met, and what is to be said of it.
struct MissedPick {
    PickedColour picked;
    std::string text;  ///< miss_text(), and where it stands for others, how many
};

/// Of the picks that are not met, those that are worth a line: all, or of many the worst alone, which says how many
/// more there are.
std::vector<MissedPick> missed_picks(const std::vector<PickedColour>& picks);

}  // namespace nacre
