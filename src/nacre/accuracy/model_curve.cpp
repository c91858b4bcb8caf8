#include "nacre/accuracy/model_curve.h"

#include <functional>
#include <utility>

#include "nacre/accuracy/scan.h"
#include "nacre/colour/difference.h"
#include "nacre/lut/sampler.h"

namespace nacre {
namespace {

// Breakpoints, and the edges of the bands in which the sampling changes by a trifle.
std::vector<double> borders_of(const Job& job) {
    std::vector<double> borders = breakpoints(job, 0.0);
    if (job.x.is_angle() && job.x.kind->quantity == Quantity::incidence) {
        for (const double cos_theta : band_least_cos_theta) borders.push_back(job.x.kind->coordinate(cos_theta));
    }
    return curve_borders(std::move(borders));
}

XyzCurve::Difference in_units_of(double tolerance, double scale) {
    return [=](const Xyz& one, const Xyz& other) { return difference_at(one, other, scale) / tolerance; };
}

}  // namespace

ModelCurve::ModelCurve(const Job& job, double tolerance, double scale, const AfterRow& after_step) {
    Sampler sampler(job);
    curve_ =
        XyzCurve([&](double x) { return sampler.at(x); }, borders_of(job), in_units_of(tolerance, scale), after_step);
    work_ = sampler.work();
}

std::optional<ModelCurve> ModelCurve::within(double most_colours, const Job& job, double tolerance, double scale,
                                             const AfterRow& after_step) {
    Sampler sampler(job);
    std::optional<XyzCurve> curve = XyzCurve::within(
        most_colours, [&](double x) { return sampler.at(x); }, borders_of(job), in_units_of(tolerance, scale),
        after_step);
    if (!curve) return std::nullopt;
    ModelCurve result;
    result.curve_ = std::move(*curve);
    result.work_ = sampler.work();
    return result;
}

}  // namespace nacre
