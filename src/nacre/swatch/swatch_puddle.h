#pragma once

#include "nacre/swatch/lit_picture.h"
#include "nacre/swatch/lit_table.h"

namespace nacre {

/// A puddle on asphalt under an overcast sky, seen by somebody who stands beside it:
///
///     XYZ = m(n.v) * sky(r)  +  what of the ground shines through
///
/// The second axis of the material runs from the edge of the puddle, its first value, to the middle, in bands that
/// wind as a film that flows does.
/// @pre the material depends on the angle of incidence
Seen look_at_puddle(const LitTable& table, const Ray& ray);

Camera puddle_camera();

}  // namespace nacre
