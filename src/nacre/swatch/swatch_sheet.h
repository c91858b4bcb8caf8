#pragma once

#include <cstddef>

#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch_outside.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// Small strips or spheres side by side, each above its label: the pictures that draw_swatch() draws, without their
/// axes. Of more than `most_sheet_pictures` the first are shown.
/// @pre there is a label for each of the jobs
Swatch draw_sheet(const PlannedSwatch& planned, const LutSpace& space);

inline constexpr std::size_t most_sheet_pictures = 60;

}  // namespace nacre
