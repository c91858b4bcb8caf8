#pragma once

#include "nacre/base/least_squares.h"

namespace nacre {

/// Levenberg's and Marquardt's method, by Ceres' solver for small dense problems; differences stand for derivatives.
LeastSquaresSolver least_squares_solver();

}  // namespace nacre
