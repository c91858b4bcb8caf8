#pragma once

#include <vector>

#include "nacre/material/mechanism.h"

namespace nacre {

/// Angles at which a mechanism's colour has a kink: picks and where a clamp begins; critical angles, where the
/// reflectance is a square root; measured angles. Degrees, in no order.
std::vector<double> kinks_deg(const Mechanism& mechanism);

/// Those of layers: the critical angles. @pre is_layered(mechanism)
std::vector<double> layered_kinks_deg(const Mechanism& mechanism);

}  // namespace nacre
