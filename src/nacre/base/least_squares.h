#pragma once

#include <functional>
#include <span>

namespace nacre {

/// A sum of squares to minimise.
struct LeastSquares {
    int parameters = 0;
    int residuals = 0;
    /// Fills `residuals`. Any finite parameters are allowed; so are all residuals that are finite.
    std::function<void(std::span<const double> parameters, std::span<double> residuals)> evaluate;
};

/// Moves the parameters towards a local minimum, in a limited number of steps. The core has no solver of its own; the
/// front end passes one in.
using LeastSquaresSolver =
    std::function<void(const LeastSquares& problem, std::span<double> parameters, int most_steps)>;

}  // namespace nacre
