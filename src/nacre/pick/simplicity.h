#pragma once

#include "nacre/material/mechanism.h"

namespace nacre {

/// How much there is to make of a mechanism: layers, planes or grooves first, then nanometres. Smaller is simpler; only
/// mechanisms of one kind compare.
double complexity_of(const Mechanism& mechanism);

}  // namespace nacre
