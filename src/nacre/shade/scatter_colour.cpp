#include "nacre/shade/scatter_colour.h"

#include "nacre/material/effects.h"

namespace nacre {

ScatterColour::ScatterColour(const Mechanism& mechanism, const SpectralSampling& sampling)
    : nodes_(sampling.nodes.front()),
      solver_(scatter_solver(sampling.kept.get(), std::get<Scatter>(mechanism), nodes_,
                             std::get<Scatter>(mechanism).radius_spread > 0.0 ? sampling.radii : 1)),
      polarisation_(mechanism.effects.polarisation),
      is_spread_(std::get<Scatter>(mechanism).radius_spread > 0.0),
      absorbs_(row_of(Effect::absorption).is_in(mechanism, 0.0)),
      is_dispersive_(row_of(Effect::dispersion).is_in(mechanism, 0.0)),
      samples_(solver_->terms()) {}

Xyz ScatterColour::at(double cos_scatter, Work* work) const {
    std::vector<double> seen(nodes_->wavelength_nm.size());
    solver_->seen(cos_scatter, polarisation_, seen);
    Xyz sum;
    for (std::size_t i = 0; i < seen.size(); ++i)
        sum = {sum.x + seen[i] * nodes_->x[i], sum.y + seen[i] * nodes_->y[i], sum.z + seen[i] * nodes_->z[i]};
    if (work == nullptr) return sum;
    ++work->spectra;
    work->samples += samples_;
    if (polarisation_ == Polarisation::mean) ++work_of(work->effects, Effect::polarisation).polarisations;
    if (is_spread_) work_of(work->effects, Effect::size_spread).points += samples_;
    if (absorbs_) work_of(work->effects, Effect::absorption).layers += nodes_->wavelength_nm.size();
    if (is_dispersive_) work_of(work->effects, Effect::dispersion).layers += nodes_->wavelength_nm.size();
    return sum;
}

}  // namespace nacre
