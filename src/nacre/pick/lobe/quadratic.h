#pragma once

#include <array>

namespace nacre {

/// constant + gradient . v + v . curvature v / 2, of three variables.
struct Quadratic {
    using Vector = std::array<double, 3>;
    double constant = 0.0;
    Vector gradient{};
    std::array<Vector, 3> curvature{};  ///< symmetric

    double at(const Vector& v) const;
};

/// Solves matrix * result = right.
/// @param matrix  symmetric @return false if it is not positive definite: then the result means nothing
bool solve_positive(const std::array<Quadratic::Vector, 3>& matrix, const Quadratic::Vector& right,
                    Quadratic::Vector& result);

/// Where the quadratic is least in a box, or nearly: variables that would leave the box stay at its sides, one after
/// the other; where it is no bowl, it is made one by as much curvature as that takes.
/// @param start,low,high  low <= start <= high; what comes back is never higher than start
Quadratic::Vector least_in_box(const Quadratic& quadratic, const Quadratic::Vector& start, const Quadratic::Vector& low,
                               const Quadratic::Vector& high);

}  // namespace nacre
