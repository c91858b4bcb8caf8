#include "nacre/accuracy/model_curve.h"

#include "nacre/accuracy/scan.h"
#include "nacre/accuracy/trial.h"
#include "nacre/lut/sampler.h"

namespace nacre {
namespace {

// Landmarks, and the edges of the bands in which the sampling changes by a trifle.
std::vector<double> borders_of(const Job& job) {
    std::vector<double> borders = landmarks(job, 0.0);
    if (job.x.is_angle() && job.x.kind->quantity == Quantity::incidence) {
        for (const double cos_theta : band_least_cos_theta) borders.push_back(job.x.kind->coordinate(cos_theta));
    }
    return curve_borders(std::move(borders));
}

}  // namespace

ModelCurve::ModelCurve(const Job& job, double tolerance, double scale, const AfterRow& after_step) {
    Sampler sampler(job);
    curve_ = XyzCurve([&](double x) { return sampler.at(x); }, borders_of(job),
                      [&](const Xyz& one, const Xyz& other) { return difference_at(one, other, scale) <= tolerance; },
                      after_step);
    work_ = sampler.work();
}

}  // namespace nacre
