#pragma once

#include <functional>
#include <span>

namespace nacre {

/// A sum of squares that is to become small.
struct LeastSquares {
    int parameters = 0;
    int residuals = 0;
    /// Fills `residuals`. Any finite parameters are allowed; so are all residuals that are finite.
    std::function<void(std::span<const double> parameters, std::span<double> residuals)> evaluate;
};

/// Moves the parameters towards a minimum near by, in so many steps at most. The core brings none along: a front end
/// hands in a library's.
using LeastSquaresSolver =
    std::function<void(const LeastSquares& problem, std::span<double> parameters, int most_steps)>;

}  // namespace nacre
