#pragma once

#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch_outside.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// What a LUT looks like, in one picture: at the left the object that suits its material (object_of()), at the right
/// its strip with all marks of draw_strip(), or the plane of its two axes.
///
/// Smaller and with less effort than the pictures that show one of them, because it is drawn beside every LUT.
Swatch draw_preview(const PlannedSwatch& planned, const LutSpace& space);

}  // namespace nacre
