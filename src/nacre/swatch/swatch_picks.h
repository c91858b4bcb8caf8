#pragma once

#include <cstddef>

#include "nacre/scene/plan.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch_outside.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// Every pick that is a colour beside what the material shows there, CIEDE2000 under each pair, and the strip over all
/// angles below. Patches and strip follow one rule: colours that the display has are shown exactly, others are cut off
/// at what it has, and what lies outside the space of the LUTs is marked in both. A strip that is brighter than white
/// is darkened; picked colours never are. Of more than `most_pairs` picks the first are shown.
/// @pre the job's material has picks that are colours
Swatch draw_picks(const PlannedSwatch& planned, const LutSpace& space = {});

inline constexpr std::size_t most_pairs = 12;

}  // namespace nacre
