#pragma once

#include <cstddef>
#include <vector>

#include "nacre/lut/job.h"

namespace nacre {

/// Layers of a job's film or stack whose fringes are too fine for eye and light: taking them as incoherent changes
/// colours by no more than `tolerance`, measured against every fringe at angles up to 60 degrees. Beyond, fringes are
/// sharper, but none is coarser. Nodes of the layer system; none if a parameter is an axis, for a thickness may then be
/// any.
std::vector<std::size_t> thick_layers(const Job& job, double tolerance);

}  // namespace nacre
