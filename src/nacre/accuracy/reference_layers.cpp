// Colours of layers by an independent method: reflectances by the confirmed solver, into Reference::integral().
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <variant>

#include "nacre/accuracy/confirmed_layers.h"
#include "nacre/accuracy/reference.h"
#include "nacre/base/gauss_points.h"
#include "nacre/optics/reversed.h"
#include "nacre/shade/layered_colour.h"

namespace nacre {
namespace {

using std::numbers::pi;

}  // namespace

// What was prepared for the layers of a material.
struct Reference::Layers {
    Mechanism mechanism;
    ConfirmedLayers layers;
    std::vector<double> base_factors{};  // at even steps; none: no diffuse base
    bool is_smooth;                      // the mean of so many that no fringes are left
    double fringes;                      // over the light's range
    int cells = 0;                       // to begin with
};

namespace {

// Layers with more samples of uneven thicknesses than a bake has where it left that out, and with finer slices in any
// case: what those err by falls with the fourth power of their number.
LayerEnsemble fine_ensemble(const Mechanism& mechanism, const SpectralSampling& sampling) {
    constexpr int enough_samples = 256;
    constexpr int finer_slices = 2;
    const int samples = sampling.thickness_samples > 1 ? sampling.thickness_samples : enough_samples;
    return layer_ensemble(mechanism, samples, {}, finer_slices * sampling.slices);
}

LayerEnsemble seen_from_below(const LayerEnsemble& ensemble) {
    LayerEnsemble from_below{{}, ensemble.shares};
    for (const LayerSystem& system : ensemble.systems) from_below.systems.push_back(reversed(system));
    return from_below;
}

// What of the light that passes the layers a base sends back through them. Light comes to it evenly from all
// directions, which are taken by Gauss's rule in an angle u: cos^2 = from + (to - from) sin^2 u, with borders at
// grazing, at the critical angle and at the normal. In u nothing bends like a root at any of them.
std::vector<double> factors_of(const Base& base, ConfirmedLayers& below, const std::vector<double>& nm, int points) {
    constexpr double any_nm = 550.0;
    const LayerSystem& system = below.ensemble().systems.front();
    const double ratio =
        system.index_at(system.substrate, any_nm).real() / system.index_at(system.incident, any_nm).real();
    const double critical = ratio < 1.0 ? (1.0 - ratio) * (1.0 + ratio) : 0.0;
    std::vector<double> reflected(nm.size());
    std::vector<double> passed(nm.size());
    for (const auto& [from, to] : {std::pair{0.0, critical}, {critical, 1.0}}) {
        if (from == to) continue;
        for (const GaussPoint& point : unit_gauss_legendre(points)) {
            const double u = 0.5 * pi * point.at;
            const double weight = point.weight * 0.5 * pi * (to - from) * std::sin(2.0 * u);
            const double cos_squared = std::lerp(from, to, std::sin(u) * std::sin(u));
            const std::vector<Response> responses = below.at(Incidence::from_cos(std::sqrt(cos_squared)), nm);
            for (std::size_t i = 0; i < nm.size(); ++i) {
                reflected[i] += weight * responses[i].reflectance();
                passed[i] += weight * responses[i].transmittance();
            }
        }
    }
    std::vector<double> factors(nm.size());
    for (std::size_t i = 0; i < nm.size(); ++i) {
        const double rho = diffuse_reflectance(base, nm[i]);
        factors[i] = std::min(rho * passed[i] / std::max(1.0 - rho * reflected[i], 1e-15), 1.0);
    }
    return factors;
}

// A parabola over every two steps. @param share  of the way from the first value to the last
double value_at(const std::vector<double>& values, double share) {
    const double position = share * static_cast<double>(values.size() - 1);
    const std::size_t middle = 2 * std::min(static_cast<std::size_t>(0.5 * position), values.size() / 2 - 1) + 1;
    const double t = position - static_cast<double>(middle);
    return 0.5 * t * (t - 1.0) * values[middle - 1] + (1.0 - t) * (1.0 + t) * values[middle] +
           0.5 * t * (t + 1.0) * values[middle + 1];
}

}  // namespace

// With twice as many directions until the base's own colour agrees.
std::vector<double> Reference::base_factors(const Base& base, const LayerEnsemble& layers) const {
    constexpr int most_directions = 512;
    constexpr int most_cells = 1 << 18;
    ConfirmedLayers below(seen_from_below(layers));
    std::vector<double> factors;
    int cells = 0;
    Xyz half;
    for (int points = 8;; points *= 2) {
        const auto spectrum = [&](const std::vector<double>& nm) { return factors_of(base, below, nm, points); };
        const Xyz all = integral(4.0, cells, spectrum, most_cells, &factors);
        if (points >= most_directions || (points > 8 && !(doubt(all, half) > 1.0))) return factors;
        half = all;
    }
}

Xyz Reference::layered(const Mechanism& mechanism, const Incidence& incidence) const {
    constexpr std::size_t samples_of_smooth_mean = 32;
    if (!layers_ || !(layers_->mechanism == mechanism)) {
        ConfirmedLayers layers(fine_ensemble(mechanism, job_.sampling));
        const bool is_smooth = layers.ensemble().systems.size() >= samples_of_smooth_mean;
        layers_ = std::make_shared<Layers>(
            Layers{mechanism, std::move(layers), {}, is_smooth, fringe_count(mechanism, job_.light->settings)});
        const auto& base = mechanism.effects.base;
        if (base && !std::holds_alternative<MetalBase>(*base))
            layers_->base_factors = base_factors(*base, layers_->layers.ensemble());
    }
    // Towards grazing every face is a mirror, and what is left of fringes are lines: coarse steps may miss them all. Of
    // uneven layers there are too many for that.
    if (layers_->layers.ensemble().systems.size() == 1 && incidence.cos_theta > 0.0) {
        const double least_steps = 2.0 * pi * layers_->fringes / std::clamp(4.0 * incidence.cos_theta, 0.02, 1.0);
        layers_->cells = std::max(layers_->cells, static_cast<int>(least_steps));
    }
    const Observed observed = mechanism.effects.observed;
    const Polarisation polarisation = mechanism.effects.polarisation;
    const std::vector<double>& factors = layers_->base_factors;
    return integral(layers_->is_smooth ? 2.0 : 1.0, layers_->cells, [&](const std::vector<double>& nm) {
        const std::vector<Response> responses = layers_->layers.at(incidence, nm);
        std::vector<double> seen(nm.size());
        for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = observed_of(responses[i], observed, polarisation);
        const LightSettings& light = job_.light->settings;
        for (std::size_t i = 0; i < seen.size() && !factors.empty(); ++i)
            seen[i] += value_at(factors, (nm[i] - light.first_nm) / (light.last_nm - light.first_nm)) *
                       transmittance_of(responses[i], polarisation);
        return seen;
    });
}

}  // namespace nacre
