#include "nacre/base/gauss_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace nacre {
namespace {

// How many roots of the Hermite polynomial of that degree lie below x: the negative pivots of its Jacobi matrix less x
// (Sylvester's law of inertia), whose diagonal is 0 and whose off-diagonals are the roots of 1, 2, ...
int roots_below(double x, int degree) {
    int below = 0;
    double pivot = -x;
    for (int i = 1; i <= degree; ++i) {
        if (i > 1) pivot = -x - (i - 1) / (pivot == 0.0 ? 1e-300 : pivot);
        if (pivot < 0.0) ++below;
    }
    return below;
}

// Christoffel's number: one over the sum of squares of the orthonormal polynomials. Where that overflows it is 0.
double normal_weight(double x, int count) {
    double before = 0.0;
    double last = 1.0;
    double sum = 1.0;
    for (int degree = 1; degree < count; ++degree) {
        const double next = (x * last - std::sqrt(degree - 1.0) * before) / std::sqrt(degree);
        before = last;
        last = next;
        if (!std::isfinite(last)) return 0.0;
        sum += last * last;
    }
    return 1.0 / sum;
}

// Some roots of a Legendre polynomial by Newton's method, side by side: one alone waits for a division at every degree.
struct Roots {
    static constexpr std::size_t lanes = 8;
    std::array<double, lanes> x{};
    std::array<double, lanes> slope{};
    std::array<bool, lanes> is_found{};

    // Returns whether there is more to do for the first `used`.
    bool step(int count, std::size_t used) {
        std::array<double, lanes> before{};
        std::array<double, lanes> last{};
        last.fill(1.0);
        for (int degree = 1; degree <= count; ++degree) {
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const double next = ((2 * degree - 1) * x[lane] * last[lane] - (degree - 1) * before[lane]) / degree;
                before[lane] = last[lane];
                last[lane] = next;
            }
        }
        bool is_more = false;
        for (std::size_t lane = 0; lane < used; ++lane) {
            if (is_found[lane]) continue;
            slope[lane] = count * (before[lane] - x[lane] * last[lane]) / ((1.0 - x[lane]) * (1.0 + x[lane]));
            const double change = last[lane] / slope[lane];
            x[lane] -= change;
            is_found[lane] = !(std::abs(change) > 1e-15);
            is_more = is_more || !is_found[lane];
        }
        return is_more;
    }
};

}  // namespace

std::vector<GaussPoint> gauss_legendre(int count) {
    assert(count >= 1);
    std::vector<GaussPoint> points(static_cast<std::size_t>(count));
    const int half = (count + 1) / 2;
    for (int first = 0; first < half; first += static_cast<int>(Roots::lanes)) {
        Roots roots;
        // Tricomi's estimate, from which Newton's method needs two to four steps.
        for (std::size_t lane = 0; lane < Roots::lanes; ++lane)
            roots.x[lane] = std::cos(std::numbers::pi * (first + static_cast<double>(lane) + 0.75) / (count + 0.5));
        const int lanes = std::min(half - first, static_cast<int>(Roots::lanes));
        for (int step = 0; step < 10 && roots.step(count, static_cast<std::size_t>(lanes)); ++step) {
        }
        for (int lane = 0; lane < lanes; ++lane) {
            const int i = first + lane;
            const double slope = roots.slope[static_cast<std::size_t>(lane)];
            const double x = 2 * i + 1 == count ? 0.0 : roots.x[static_cast<std::size_t>(lane)];
            const double weight = 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope);
            points[static_cast<std::size_t>(i)] = {-x, weight};
            points[static_cast<std::size_t>(count - 1 - i)] = {x, weight};
        }
    }
    return points;
}

std::vector<GaussPoint> unit_gauss_legendre(int count) {
    std::vector<GaussPoint> points = gauss_legendre(count);
    for (GaussPoint& point : points) point = {0.5 + 0.5 * point.at, 0.5 * point.weight};
    return points;
}

std::vector<GaussPoint> gauss_normal(int count) {
    assert(count >= 1);
    std::vector<GaussPoint> points(static_cast<std::size_t>(count));
    for (int i = count / 2; i < count; ++i) {
        double left = 0.0;
        double right = 2.0 * std::sqrt(count) + 1.0;  // beyond the largest root
        for (int halving = 0; halving < 64; ++halving) {
            const double middle = 0.5 * (left + right);
            (roots_below(middle, count) <= i ? left : right) = middle;
        }
        const double x = 2 * i + 1 == count ? 0.0 : left;
        const double weight = normal_weight(x, count);
        points[static_cast<std::size_t>(i)] = {x, weight};
        points[static_cast<std::size_t>(count - 1 - i)] = {-x, weight};
    }
    return points;
}

std::vector<GaussPoint> normal_points(int count) {
    constexpr int most_of_gauss = 16;  // from there on even steps are better for light on spheres of any size
    constexpr double end = 6.0;
    if (count <= most_of_gauss) return gauss_normal(count);
    std::vector<GaussPoint> points;
    double total = 0.0;
    for (int i = 0; i < count; ++i) {
        const double at = end * (2 * i + 1 - count) / count;
        points.push_back({at, std::exp(-0.5 * at * at)});
        total += points.back().weight;
    }
    for (GaussPoint& point : points) point.weight /= total;
    return points;
}

double normal_above(double share) {
    double z = std::sqrt(-2.0 * std::log(share));
    for (int i = 0; i < 50; ++i) {
        const double excess = 0.5 * std::erfc(z / std::numbers::sqrt2) - share;
        const double density = std::exp(-0.5 * z * z) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
        const double step = excess / density;
        z += std::clamp(step, -0.5, 0.5);
        if (std::abs(step) < 1e-14) break;
    }
    return z;
}

}  // namespace nacre
