#pragma once

#include <array>

namespace nacre {

enum class Observer { cie1931_2deg, cie1964_10deg };

/// { x_bar, y_bar, z_bar } of the observer at a whole nanometre.
/// @param nm  in [360, 830]
const std::array<double, 3>& colour_matching(Observer observer, int nm);

}  // namespace nacre
