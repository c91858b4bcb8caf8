#include "nacre/pick/lobe/quadratic.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nacre {
namespace {

using Vector = Quadratic::Vector;

Vector slope_at(const Quadratic& quadratic, const Vector& v) {
    Vector slope = quadratic.gradient;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) slope[i] += quadratic.curvature[i][j] * v[j];
    }
    return slope;
}

// The step to the least point with some variables fixed; more and more curvature until there is one.
Vector free_step(const Quadratic& quadratic, const Vector& slope, const std::array<bool, 3>& is_fixed) {
    std::array<Vector, 3> matrix = quadratic.curvature;
    Vector right{};
    double largest = 1e-12;
    for (std::size_t i = 0; i < 3; ++i) {
        right[i] = is_fixed[i] ? 0.0 : -slope[i];
        for (std::size_t j = 0; j < 3; ++j) {
            largest = std::max(largest, std::abs(matrix[i][j]));
            if (is_fixed[i] || is_fixed[j]) matrix[i][j] = i == j ? 1.0 : 0.0;
        }
    }
    Vector step{};
    if (solve_positive(matrix, right, step)) return step;
    // Just enough to make it one: the step is long, and the box cuts it.
    const auto with = [&](double added) {
        std::array<Vector, 3> bowl = matrix;
        for (std::size_t i = 0; i < 3; ++i) bowl[i][i] += added;
        return bowl;
    };
    double too_little = 0.0;
    double enough = 1e-4 * largest;
    while (enough < 8.0 * largest && !solve_positive(with(enough), right, step)) {
        too_little = enough;
        enough *= 4.0;
    }
    constexpr int halvings = 5;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (too_little + enough);
        Vector longer{};
        if (solve_positive(with(middle), right, longer)) {
            enough = middle;
            step = longer;
        } else {
            too_little = middle;
        }
    }
    return step;
}

}  // namespace

bool solve_positive(const std::array<Vector, 3>& matrix, const Vector& right, Vector& result) {
    constexpr double least = 1e-9;  // of what it is made of, so that it is no rounding
    const double a = matrix[0][0], b = matrix[1][1], c = matrix[2][2];
    const double d = matrix[1][0], e = matrix[2][0], f = matrix[2][1];
    // Sylvester: positive where the leading minors are.
    const double minor = a * b - d * d;
    if (!(a > 0.0 && c > 0.0 && minor > least * a * b)) return false;
    const double ef = d * f - b * e, df = d * e - a * f;
    const double determinant = c * minor + e * ef + f * df;
    if (!(determinant > least * c * minor)) return false;
    // The inverse by its cofactors: one division, where Cholesky's method waits for six.
    const double per = 1.0 / determinant;
    const double de = e * f - c * d, bc = b * c - f * f, ac = a * c - e * e;
    const auto [x, y, z] = right;
    result = {per * (bc * x + de * y + ef * z), per * (de * x + ac * y + df * z), per * (ef * x + df * y + minor * z)};
    return true;
}

double Quadratic::at(const Vector& v) const {
    double value = constant;
    const Vector slope = slope_at(*this, v);
    for (std::size_t i = 0; i < 3; ++i) value += 0.5 * v[i] * (gradient[i] + slope[i]);
    return value;
}

Vector least_in_box(const Quadratic& quadratic, const Vector& start, const Vector& low, const Vector& high) {
    Vector here = start;
    std::array<bool, 3> is_fixed{};
    const Vector first_slope = slope_at(quadratic, start);
    for (std::size_t i = 0; i < 3; ++i)
        is_fixed[i] = (start[i] <= low[i] && first_slope[i] > 0.0) || (start[i] >= high[i] && first_slope[i] < 0.0);
    for (int round = 0; round < 3; ++round) {
        const Vector step = free_step(quadratic, slope_at(quadratic, here), is_fixed);
        // As far as the first side that is in the way.
        double share = 1.0;
        std::size_t hit = 3;
        for (std::size_t i = 0; i < 3; ++i) {
            const double room = step[i] > 0.0 ? high[i] - here[i] : low[i] - here[i];
            if (step[i] == 0.0 || std::abs(room) >= share * std::abs(step[i])) continue;
            share = room / step[i];
            hit = i;
        }
        for (std::size_t i = 0; i < 3; ++i) here[i] = std::clamp(here[i] + share * step[i], low[i], high[i]);
        if (hit == 3) break;
        is_fixed[hit] = true;
    }
    return here;
}

}  // namespace nacre
