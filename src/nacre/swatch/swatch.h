#pragma once

#include <cstddef>

#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch_outside.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// Lays the picture out and bakes what it shows, at the picture's own resolution: the sizes of the jobs do not matter.
///
/// Angles, widths and heights grow upwards and to the right, but a LUT's angle runs as its axis does. A palette of more
/// than `most_palette_panels` picks shows the first of them, and says so.
/// @param space  of the scene's LUTs: a strip, and a LUT with two axes, shows where it leaves that
/// @pre swatch.jobs is not empty, and for plane and palette they are those of swatch_jobs()
Swatch draw_swatch(const PlannedSwatch& swatch, const LutSpace& space = {});

inline constexpr std::size_t most_palette_panels = 12;

}  // namespace nacre
