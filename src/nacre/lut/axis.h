#pragma once

#include <string>

#include "nacre/lut/axis_kinds.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"

namespace nacre {

/// One axis of a LUT: the angle, in one of its forms, or a number of the material that runs from one value to another.
struct Axis {
    const AxisKind* kind = nullptr;  ///< the angle; null: a parameter
    Parameter parameter;             ///< only if kind is null
    double from = 0.0;               ///< the parameter's value at the first texel
    double to = 1.0;                 ///< and at the last

    bool is_angle() const { return kind != nullptr; }
    /// @param coordinate  in [0, 1]; gives exactly `from` at 0 and `to` at 1
    double parameter_value(double coordinate) const;
};

/// The default x axis of LUTs of mechanisms that depend on that quantity.
Axis default_axis(Quantity quantity = Quantity::incidence);

}  // namespace nacre
