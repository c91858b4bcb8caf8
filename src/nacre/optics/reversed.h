#pragma once

#include "nacre/optics/layer_system.h"

namespace nacre {

/// The same layers for light that comes from below: what was the substrate is the incident medium.
LayerSystem reversed(const LayerSystem& system);

}  // namespace nacre
