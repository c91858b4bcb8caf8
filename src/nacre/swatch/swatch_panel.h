#pragma once

#include "nacre/lut/job.h"
#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// Bakes the job at the area's size, whatever its own is. A job without y fills all rows alike.
Panel bake_panel(const Job& job, const PlotArea& area);

}  // namespace nacre
