#pragma once

#include "nacre/colour/colour_types.h"

namespace nacre {

/// For sums of many weighted colours.
inline void add(Xyz& sum, double factor, const Xyz& colour) {
    sum.x += factor * colour.x;
    sum.y += factor * colour.y;
    sum.z += factor * colour.z;
}

inline Xyz scaled(const Xyz& colour, double factor) {
    return {factor * colour.x, factor * colour.y, factor * colour.z};
}

}  // namespace nacre
