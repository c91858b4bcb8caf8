#pragma once

#include "nacre/lut/job.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_outside.h"
#include "nacre/swatch/swatch_panel.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// A LUT with its axes, even in degrees unless the swatch wants another axis; below it, a second scale says where the
/// texels of the LUT are.
///
/// A transmittance lies over a checkerboard, whose light squares show the LUT as it is.
///
/// Without a fixed exposure, gratings and scattering layers whose brightest component is above white are darkened until
/// it is white. The picture says its exposure unless it is 0.
Swatch draw_strip(const PlannedSwatch& planned, const LutSpace& space);

/// What draw_strip() draws but the title: the colours in `area`, with axes, scales and marks.
///
/// The picture becomes as high as this needs. @pre it is as wide as the area and what stands beside it
void draw_strip_in(Swatch& swatch, const PlannedSwatch& planned, const PlotArea& area, const LutSpace& space,
                   double most_effort = most_panel_effort);

/// The same job with its angle (to the normal) even in what the swatch wants.
Job shown_job(const PlannedSwatch& planned);

}  // namespace nacre
