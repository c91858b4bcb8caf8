#include "nacre/colour/xyz_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace nacre {
namespace {

constexpr int degree_count = 10;
// Where a panel is tried: between nodes, in the middle and near the ends, where polynomials fail first.
constexpr std::array tried_at{-0.97, -0.55, 0.07, 0.62, 0.96};
// Narrower intervals are accepted as they are: the colour has a kink there that is not among the borders.
constexpr double narrowest = 1e-4;
static_assert(XyzCurve::colours_per_interval == degree_count + tried_at.size());

Xyz plus(const Xyz& sum, double factor, const Xyz& term) {
    return {sum.x + factor * term.x, sum.y + factor * term.y, sum.z + factor * term.z};
}

// Clenshaw's recurrence. @param t  in [-1, 1]
Xyz value_at(const std::vector<Xyz>& coefficients, double t) {
    Xyz one;
    Xyz two;
    for (std::size_t n = coefficients.size() - 1; n > 0; --n) {
        const Xyz next = plus(plus(coefficients[n], 2.0 * t, one), -1.0, two);
        two = one;
        one = next;
    }
    return plus(plus(coefficients[0], t, one), -1.0, two);
}

std::vector<Xyz> interpolate(const XyzCurve::Colour& colour, double from, double to) {
    std::array<Xyz, degree_count> values;
    for (int j = 0; j < degree_count; ++j) {
        const double t = std::cos(std::numbers::pi * (j + 0.5) / degree_count);
        values[static_cast<std::size_t>(j)] = colour(std::lerp(from, to, 0.5 + 0.5 * t));
    }
    std::vector<Xyz> coefficients(degree_count);
    for (int n = 0; n < degree_count; ++n) {
        for (int j = 0; j < degree_count; ++j) {
            const double share =
                (n == 0 ? 1.0 : 2.0) / degree_count * std::cos(std::numbers::pi * n * (j + 0.5) / degree_count);
            auto& coefficient = coefficients[static_cast<std::size_t>(n)];
            coefficient = plus(coefficient, share, values[static_cast<std::size_t>(j)]);
        }
    }
    return coefficients;
}

}  // namespace

XyzCurve::XyzCurve(const Colour& colour, const std::vector<double>& borders, const Agrees& agrees,
                   const std::function<void()>& after_step) {
    fit(std::numeric_limits<std::int64_t>::max(), colour, borders, agrees, after_step);
}

std::optional<XyzCurve> XyzCurve::within(std::int64_t most_intervals, const Colour& colour,
                                         const std::vector<double>& borders, const Agrees& agrees,
                                         const std::function<void()>& after_step) {
    XyzCurve curve;
    if (!curve.fit(most_intervals, colour, borders, agrees, after_step)) return std::nullopt;
    return curve;
}

bool XyzCurve::fit(std::int64_t most_intervals, const Colour& colour, const std::vector<double>& borders,
                   const Agrees& agrees, const std::function<void()>& after_step) {
    std::int64_t tried = 0;
    std::vector<double> ends(borders.rbegin(), borders.rend() - 1);  // still to come, the next one last
    double from = borders.front();
    while (!ends.empty()) {
        if (++tried > most_intervals) return false;
        const double to = ends.back();
        std::vector<Xyz> coefficients = interpolate(colour, from, to);
        const bool is_good = std::all_of(tried_at.begin(), tried_at.end(), [&](double t) {
            return agrees(value_at(coefficients, t), colour(std::lerp(from, to, 0.5 + 0.5 * t)));
        });
        if (after_step) after_step();
        if (!is_good && to - from > narrowest) {
            ends.push_back(0.5 * (from + to));
            continue;
        }
        panels_.push_back({to, std::move(coefficients)});
        from = to;
        ends.pop_back();
    }
    return true;
}

Xyz XyzCurve::at(double x) const {
    const auto panel = std::lower_bound(panels_.begin(), panels_.end() - 1, x,
                                        [](const Panel& candidate, double value) { return candidate.to < value; });
    const double from = panel == panels_.begin() ? 0.0 : (panel - 1)->to;
    return value_at(panel->coefficients, 2.0 * (x - from) / (panel->to - from) - 1.0);
}

std::vector<double> XyzCurve::borders() const {
    std::vector<double> borders{0.0};
    for (const Panel& panel : panels_) borders.push_back(panel.to);
    return borders;
}

std::vector<double> curve_borders(std::vector<double> borders) {
    constexpr int even = 8;
    for (int i = 0; i <= even; ++i) borders.push_back(static_cast<double>(i) / even);
    std::sort(borders.begin(), borders.end());
    borders.erase(std::unique(borders.begin(), borders.end(), [](double a, double b) { return b - a < narrowest; }),
                  borders.end());
    borders.front() = 0.0;
    borders.back() = 1.0;
    return borders;
}

}  // namespace nacre
