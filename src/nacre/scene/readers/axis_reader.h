#pragma once

#include <string>
#include <string_view>

#include "nacre/lut/axis.h"
#include "nacre/scene/table.h"

namespace nacre {

/// Reads `x = "cos_theta"` or `x = { parameter = "height", from = 0, to = 1 }`.
/// @param key  "x" or "y"
Axis read_axis(const Table& lut, std::string_view key, const Value& value, const Mechanism& mechanism);

/// As a value in TOML; reads back as the same axis.
std::string axis_toml(const Axis& axis);

/// Throws Error if the parameter `name` is none of the mechanism's.
Axis parameter_axis(const Mechanism& mechanism, std::string_view name, double from, double to);

}  // namespace nacre
