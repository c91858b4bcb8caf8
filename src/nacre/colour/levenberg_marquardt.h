#pragma once

#include <array>
#include <functional>

namespace nacre {

/// Least sum of squares of three residuals over three variables in a box (Levenberg and Marquardt's method).
struct LeastSquares {
    using Vector = std::array<double, 3>;

    std::function<Vector(const Vector&)> residuals;  ///< wherever low <= variables <= high
    Vector low{};
    Vector high{};

    /// Where it ends, from a start in the box: at a sum of squares of `enough`, or where there is no way down.
    /// Variables count about alike; slopes are differences over a thousandth of one.
    Vector from(const Vector& start, double enough) const;

private:
    struct Normal {
        std::array<Vector, 3> matrix{};
        Vector gradient{};
    };
    Normal normal_at(const Vector& here, const Vector& residual) const;
};

}  // namespace nacre
