#include "nacre/accuracy/model_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/accuracy/scan.h"
#include "nacre/accuracy/trial.h"
#include "nacre/bake/sampler.h"

namespace nacre {
namespace {

constexpr int degree_count = 10;
// Where a panel is tried: between nodes, in the middle and towards the ends, where polynomials fail first.
constexpr std::array tried_at{-0.97, -0.55, 0.07, 0.62, 0.96};
// Narrower intervals than this are taken as they are: something bends there that no landmark tells of.
constexpr double narrowest = 1e-4;

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

std::vector<Xyz> interpolate(Sampler& sampler, double from, double to) {
    std::array<Xyz, degree_count> values;
    for (int j = 0; j < degree_count; ++j) {
        const double t = std::cos(std::numbers::pi * (j + 0.5) / degree_count);
        values[static_cast<std::size_t>(j)] = sampler.at(std::lerp(from, to, 0.5 + 0.5 * t));
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

// Landmarks, and the edges of the bands in which the sampling changes by a trifle.
std::vector<double> borders_of(const Job& job) {
    std::vector<double> borders = landmarks(job, 0.0);
    for (const double cos_theta : band_least_cos_theta) {
        if (job.x.is_angle()) borders.push_back(job.x.kind->coordinate(cos_theta));
    }
    constexpr int even = 8;
    for (int i = 0; i <= even; ++i) borders.push_back(static_cast<double>(i) / even);
    std::sort(borders.begin(), borders.end());
    borders.erase(std::unique(borders.begin(), borders.end(), [](double a, double b) { return b - a < narrowest; }),
                  borders.end());
    borders.front() = 0.0;
    borders.back() = 1.0;
    return borders;
}

}  // namespace

ModelCurve::ModelCurve(const Job& job, double tolerance, double scale, const AfterRow& after_step) {
    Sampler sampler(job);
    const std::vector<double> borders = borders_of(job);
    std::vector<double> ends(borders.rbegin(), borders.rend() - 1);  // still to come, the next one last
    double from = 0.0;
    while (!ends.empty()) {
        const double to = ends.back();
        std::vector<Xyz> coefficients = interpolate(sampler, from, to);
        const bool agrees = std::all_of(tried_at.begin(), tried_at.end(), [&](double t) {
            const Xyz meant = sampler.at(std::lerp(from, to, 0.5 + 0.5 * t));
            return difference_at(value_at(coefficients, t), meant, scale) <= tolerance;
        });
        if (after_step) after_step();
        if (!agrees && to - from > narrowest) {
            ends.push_back(0.5 * (from + to));
            continue;
        }
        panels_.push_back({to, std::move(coefficients)});
        from = to;
        ends.pop_back();
    }
    work_ = sampler.work();
}

Xyz ModelCurve::at(double x) const {
    const auto panel = std::lower_bound(panels_.begin(), panels_.end() - 1, x,
                                        [](const Panel& candidate, double value) { return candidate.to < value; });
    const double from = panel == panels_.begin() ? 0.0 : (panel - 1)->to;
    return value_at(panel->coefficients, 2.0 * (x - from) / (panel->to - from) - 1.0);
}

}  // namespace nacre
