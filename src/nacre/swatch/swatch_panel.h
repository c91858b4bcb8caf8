#pragma once

#include "nacre/lut/job.h"
#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// The effort limit of a picture, in reflectances of a film: a few seconds.
inline constexpr double most_panel_effort = 3e9;

/// Bakes the job at the area's size, whatever its own is. A job without y fills all rows alike.
/// @param most_effort  a panel that would take more is baked smaller and enlarged
Panel bake_panel(const Job& job, const PlotArea& area, double most_effort = most_panel_effort);

}  // namespace nacre
