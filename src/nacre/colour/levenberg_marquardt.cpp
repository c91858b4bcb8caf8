#include "nacre/colour/levenberg_marquardt.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nacre/colour/quadratic.h"

namespace nacre {
namespace {

using Vector = LeastSquares::Vector;

double square_sum(const Vector& v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

}  // namespace

// What the normal equations are made of; a variable that stands at a bound and would go beyond it is left out.
LeastSquares::Normal LeastSquares::normal_at(const Vector& here, const Vector& residual) const {
    constexpr double difference = 1e-3;
    std::array<Vector, 3> slopes{};  // of the residuals, by each variable
    for (std::size_t i = 0; i < 3; ++i) {
        const double side = here[i] + difference > high[i] ? -difference : difference;
        Vector there = here;
        there[i] += side;
        const Vector moved = residuals(there);
        for (std::size_t k = 0; k < 3; ++k) slopes[i][k] = (moved[k] - residual[k]) / side;
    }
    const auto product = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    Normal normal;
    std::array<bool, 3> is_stuck{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double gradient = product(slopes[i], residual);
        is_stuck[i] = (here[i] <= low[i] && gradient > 0.0) || (here[i] >= high[i] && gradient < 0.0);
        if (!is_stuck[i]) normal.gradient[i] = gradient;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const bool is_left_out = is_stuck[i] || is_stuck[j];
            normal.matrix[i][j] = is_left_out ? (i == j ? 1.0 : 0.0) : product(slopes[i], slopes[j]);
        }
    }
    return normal;
}

Vector LeastSquares::from(const Vector& start, double enough) const {
    constexpr int most_steps = 60, most_attempts = 6;
    constexpr double longest = 3.0;
    Vector here = start;
    Vector residual = residuals(here);
    double error = square_sum(residual);
    double damping = 1e-3;
    for (int step = 0; step < most_steps && error > enough; ++step) {
        const Normal normal = normal_at(here, residual);
        const double before = error;
        for (int attempt = 0; attempt < most_attempts && error == before; ++attempt) {
            auto damped = normal.matrix;
            for (std::size_t i = 0; i < 3; ++i) damped[i][i] += damping * (normal.matrix[i][i] + 1e-3);
            Vector move{};
            const bool is_solved = solve_positive(damped, normal.gradient, move);
            Vector there{};
            for (std::size_t i = 0; i < 3; ++i)
                there[i] = std::clamp(here[i] - std::clamp(move[i], -longest, longest), low[i], high[i]);
            const Vector there_residual = is_solved ? residuals(there) : residual;
            if (square_sum(there_residual) < error) {
                here = there;
                residual = there_residual;
                error = square_sum(residual);
                damping = std::max(0.2 * damping, 1e-9);
            } else {
                damping *= 8.0;
            }
        }
        if (before - error < 1e-4 * before) break;
    }
    return here;
}

}  // namespace nacre
