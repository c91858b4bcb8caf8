#include "nacre/lut/axis.h"

#include <cmath>

#include "nacre/material/geometry.h"

namespace nacre {

double Axis::parameter_value(double coordinate) const {
    return std::lerp(from, to, coordinate);
}

Axis default_axis(Quantity quantity) {
    Axis axis;
    axis.kind = &default_axis_kind(quantity);
    return axis;
}

}  // namespace nacre
