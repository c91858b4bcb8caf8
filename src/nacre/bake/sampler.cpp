#include "nacre/bake/sampler.h"

#include <cstddef>

namespace nacre {
namespace {

using Prepared = std::variant<PaletteCurve, LayeredColour>;

// One row per mechanism: what answers for it at many angles.
struct Prepare {
    const Mechanism& mechanism;
    const SpectralSampling& sampling;
    Prepared operator()(const Palette& palette) const { return PaletteCurve(palette); }
    Prepared operator()(const Film&) const { return LayeredColour(mechanism, sampling); }
    Prepared operator()(const Stack&) const { return LayeredColour(mechanism, sampling); }
};

bool is_parameter(const Axis& axis) {
    return !axis.is_angle();
}

}  // namespace

Mechanism mechanism_at(const Job& job, double x, double y) {
    Mechanism mechanism = job.material.mechanism;
    if (is_parameter(job.x)) job.x.parameter.set(mechanism, job.x.parameter_value(x));
    if (job.y && is_parameter(*job.y)) job.y->parameter.set(mechanism, job.y->parameter_value(y));
    return mechanism;
}

Incidence incidence_at(const Job& job, double x, double y) {
    if (job.x.is_angle()) return job.x.kind->incidence(x);
    if (job.y && job.y->is_angle()) return job.y->kind->incidence(y);
    return Incidence::from_degrees(job.angle_deg);
}

Sampler::Sampler(const Job& job)
    : job_(job),
      mechanism_(mechanism_at(job, 0.0, 0.0)),
      sampling_(job.sampling.is_decided() ? job.sampling : default_sampling(job)),
      prepared_(std::visit(Prepare{mechanism_, sampling_}, mechanism_)) {}

void Sampler::set_parameters(double x, double y) {
    const bool x_moves = is_parameter(job_.x) && last_x_ != x;
    const bool y_moves = job_.y && is_parameter(*job_.y) && last_y_ != y;
    if (!x_moves && !y_moves) return;
    if (x_moves) job_.x.parameter.set(mechanism_, job_.x.parameter_value(x));    // planning sees to it that the
    if (y_moves) job_.y->parameter.set(mechanism_, job_.y->parameter_value(y));  // axes set different numbers
    last_x_ = x;
    last_y_ = y;
    auto* curve = std::get_if<PaletteCurve>(&prepared_);
    if (curve != nullptr) {
        curve->reset(std::get<Palette>(mechanism_));
    } else {
        prepared_ = std::visit(Prepare{mechanism_, sampling_}, mechanism_);
    }
}

Xyz Sampler::colour_of(const Lobe& lobe) {
    const Light& light = *job_.light;
    if (light.settings.wavelengths) {
        ++work_.spectra;
        work_.samples += static_cast<std::uint64_t>(light.grid.count);
        Xyz sum;
        for (int node = 0; node < light.grid.count; ++node) {
            const double r = lobe_reflectance(lobe, light.grid.wavelength_nm(node));
            if (r == 0.0) continue;
            const auto i = static_cast<std::size_t>(node);
            sum.x += r * light.grid_weights.x[i];
            sum.y += r * light.grid_weights.y[i];
            sum.z += r * light.grid_weights.z[i];
        }
        return sum;
    }
    if (job_.integral == Integral::fast) {
        ++work_.fast_integrals;
        return lobe_to_xyz_fast(light.weights, light.moments, lobe.peak_nm, lobe.width_nm, lobe.height);
    }
    ++work_.exact_integrals;
    return lobe_to_xyz(light.weights, lobe.peak_nm, lobe.width_nm, lobe.height);
}

const Incidence& Sampler::incidence(double x, double y) {
    const double coordinate = job_.x.is_angle() ? x : job_.y && job_.y->is_angle() ? y : 0.0;
    if (last_angle_ != coordinate) {
        incidence_ = incidence_at(job_, x, y);
        last_angle_ = coordinate;
    }
    return incidence_;
}

Lobe Sampler::lobe_at(double x, double y) {
    set_parameters(x, y);
    return std::get<PaletteCurve>(prepared_).at(incidence(x, y));
}

Xyz Sampler::colour_of(LayeredColour& colour, const Incidence& incidence) {
    ++work_.spectra;
    work_.samples += colour.samples(incidence);
    return colour.at(incidence);
}

Xyz Sampler::at(double x, double y) {
    set_parameters(x, y);
    const Incidence& here = incidence(x, y);
    const auto* curve = std::get_if<PaletteCurve>(&prepared_);
    const Xyz seen =
        curve != nullptr ? colour_of(curve->at(here)) : colour_of(std::get<LayeredColour>(prepared_), here);
    return adapt(job_.light->adaptation, seen);
}

}  // namespace nacre
