#pragma once

#include "nacre/colour/colour_types.h"

namespace nacre {

/// CIEDE2000 of two XYZ under D65, both shown so that a luminance of `brightest` becomes 1; 0 if that is black.
double distance_at(const Xyz& one, const Xyz& other, double brightest);

}  // namespace nacre
