#pragma once

#include <vector>

#include "nacre/material/mechanism.h"

namespace nacre {

/// Angles at which a mechanism's colour bends sharply: picks and where a clamp begins; critical angles, where the
/// reflectance is a square root; measured angles. Degrees, in no order.
std::vector<double> bends_deg(const Mechanism& mechanism);

}  // namespace nacre
