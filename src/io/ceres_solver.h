#pragma once

#include "nacre/base/least_squares.h"

namespace nacre {

/// The method of Levenberg and Marquardt, by the solver of Ceres for small dense problems, with finite differences as
/// derivatives.
LeastSquaresSolver least_squares_solver();

}  // namespace nacre
