// Colours by an independent method: plain quadrature over wavelength, for everything that is not one mechanism's own
// (reference_mechanisms.cpp has those), and for layers.
//
// In: a job, whose scene is taken as it is: every effect, no nodes, no grid. The rules are Gauss-Legendre within parts
// of nanometres that are small against a fringe. Where nothing else is said, the constants are empirical;
// tests/nacre/accuracy/reference_test.cpp compares colours with higher precision.
#include "nacre/accuracy/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/colour/lamp_weights.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/job.h"
#include "nacre/lut/sampler.h"
#include "nacre/optics/reversed.h"
#include "nacre/shade/layered_colour.h"

namespace nacre {
namespace {

// Gauss-Legendre with three nodes on [0, 1] (Abramowitz & Stegun, table 25.4).
struct QuadratureNode {
    double at;
    double share;
};
constexpr std::array<QuadratureNode, 3> quadrature{
    {{0.5 - 0.387298334620741689, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.5 + 0.387298334620741689, 5.0 / 18.0}}};

// For spectra without bends two nodes do.
constexpr std::array<QuadratureNode, 2> smooth_quadrature{
    {{0.5 - 0.288675134594812882, 0.5}, {0.5 + 0.288675134594812882, 0.5}}};

// Radians of the longest round trip through all layers between which a spectrum is that smooth.
constexpr double longest_phase = 0.5;

Xyz plus(const Xyz& sum, double factor, const Xyz& term) {
    return {sum.x + factor * term.x, sum.y + factor * term.y, sum.z + factor * term.z};
}

std::vector<Response> mean_responses(const LayerEnsemble& ensemble, const Incidence& incidence,
                                     const std::vector<double>& wavelengths_nm, bool by_twin) {
    std::vector<Response> mean(wavelengths_nm.size());
    std::vector<Response> responses(wavelengths_nm.size());
    for (std::size_t member = 0; member < ensemble.systems.size(); ++member) {
        const LayerSystem& system = ensemble.systems[member];
        if (by_twin) {
            for (std::size_t i = 0; i < responses.size(); ++i)
                responses[i] = multilayer_response(system, incidence, wavelengths_nm[i]);
        } else {
            MultilayerSolver(system, wavelengths_nm).responses(incidence, responses);
        }
        for (std::size_t i = 0; i < responses.size(); ++i) add(mean[i], ensemble.shares[member], responses[i]);
    }
    return mean;
}

bool has_diffuse_base(const Mechanism& mechanism) {
    return mechanism.effects.base && !std::holds_alternative<MetalBase>(*mechanism.effects.base);
}

// A base's factors are looked up on a grid of so many steps per nanometre.
constexpr int base_steps = 2;

}  // namespace

Reference::Reference(const Job& job) : job_(job) {
    const LightSettings& light = job.light->settings;
    has_fine_lines_ = has_fine_lines(light.power, light.first_nm, light.last_nm);
    Xyz white;
    for (int nm = light.first_nm; nm <= light.last_nm; ++nm) {
        const auto& bars = colour_matching(light.observer, nm);
        const double power = has_fine_lines_ ? 1.0 : light.power.at(nm);
        weights_.push_back({power * bars[0], power * bars[1], power * bars[2]});
        kinks_nm_.push_back(nm);
        const double share = nm == light.first_nm || nm == light.last_nm ? 0.5 : 1.0;  // trapezia
        white = plus(white, share, weights_.back());
    }
    if (has_fine_lines_) {
        for (const double nm : light.power.wavelength_nm) {
            if (nm > light.first_nm && nm < light.last_nm) kinks_nm_.push_back(nm);
        }
        std::sort(kinks_nm_.begin(), kinks_nm_.end());
        white = {};
        for (std::size_t i = 1; i < kinks_nm_.size(); ++i) {
            const double length_nm = kinks_nm_[i] - kinks_nm_[i - 1];
            for (const QuadratureNode& node : smooth_quadrature)
                white = plus(white, node.share * length_nm, weight_at(kinks_nm_[i - 1] + node.at * length_nm));
        }
    }
    for (Xyz& weight : weights_) weight = plus({}, 1.0 / white.y, weight);
    white = plus({}, 1.0 / white.y, white);
    adaptation_ = adaptation_matrix(light.adaptation, white, d65_white);
}

Xyz Reference::weight_at(double nm) const {
    const double position = nm - job_.light->settings.first_nm;
    const auto cell = std::min(static_cast<std::size_t>(position), weights_.size() - 2);
    const double along = position - static_cast<double>(cell);
    const Xyz weight = plus(plus({}, 1.0 - along, weights_[cell]), along, weights_[cell + 1]);
    return has_fine_lines_ ? plus({}, job_.light->settings.power.at(nm), weight) : weight;
}

// @pre nm is less than the last one
double Reference::next_kink(double nm) const {
    return has_fine_lines_ ? *std::upper_bound(kinks_nm_.begin(), kinks_nm_.end(), nm) : std::floor(nm) + 1.0;
}

Xyz Reference::integral(const Lobe& lobe) const {
    const LightSettings& light = job_.light->settings;
    const double first_nm = light.first_nm;
    const double last_nm = light.last_nm;
    Xyz sum;
    const auto add = [&](double from_nm, double to_nm) {
        from_nm = std::max(from_nm, first_nm);
        to_nm = std::min(to_nm, last_nm);
        // The cosine of a narrow band bends within a nanometre.
        const double longest_nm = std::min(1.0, 0.125 * (to_nm - from_nm));
        for (double left = from_nm; left < to_nm;) {
            const double right = std::min({next_kink(left), to_nm, left + longest_nm});
            if (!(right > left)) break;  // the rest is narrower than a double resolves
            for (const QuadratureNode& node : quadrature) {
                const double nm = left + node.at * (right - left);
                sum = plus(sum, node.share * (right - left) * lobe_reflectance(lobe, nm), weight_at(nm));
            }
            left = right;
        }
    };
    // Piece by piece, because the slope jumps where a shoulder begins and ends.
    const double half_nm = 0.5 * lobe.width_nm;
    const double half_plateau_nm = lobe.flatness * half_nm;
    if (lobe.floor != 0.0) add(first_nm, lobe.peak_nm - half_nm);
    if (lobe.flatness == 0.0) {
        add(lobe.peak_nm - half_nm, lobe.peak_nm + half_nm);
    } else {
        add(lobe.peak_nm - half_nm, lobe.peak_nm - half_plateau_nm);
        add(lobe.peak_nm - half_plateau_nm, lobe.peak_nm + half_plateau_nm);
        add(lobe.peak_nm + half_plateau_nm, lobe.peak_nm + half_nm);
    }
    if (lobe.floor != 0.0) add(lobe.peak_nm + half_nm, last_nm);
    return sum;
}

// Evenly from all directions below: by the midpoint rule in the square of their cosine, graded towards the critical
// angle, where reflection bends like a root.
const std::vector<double>& Reference::base_table(const Mechanism& mechanism, const LayerEnsemble& ensemble) const {
    if (base_ && base_->first == mechanism) return base_->second;
    const LightSettings& light = job_.light->settings;
    std::vector<double> wavelengths_nm;
    for (int step = 0; step <= base_steps * (light.last_nm - light.first_nm); ++step)
        wavelengths_nm.push_back(light.first_nm + static_cast<double>(step) / base_steps);
    constexpr int directions = 48;
    LayerEnsemble from_below{{}, ensemble.shares};
    for (const LayerSystem& system : ensemble.systems) from_below.systems.push_back(reversed(system));
    const LayerSystem& first = from_below.systems.front();
    const double ratio = first.index_at(first.substrate, 550.0).real() / first.index_at(first.incident, 550.0).real();
    const double critical = ratio < 1.0 ? (1.0 - ratio) * (1.0 + ratio) : 0.0;
    std::vector<double> reflected(wavelengths_nm.size());
    std::vector<double> passed(wavelengths_nm.size());
    const bool by_twin = ensemble.systems.size() == 1 && expanded_layers(first) <= 8.0;
    const auto add = [&](double begin, double end) {
        for (int i = 0; i < directions && begin != end; ++i) {
            // Quadratic steps away from `begin`.
            const double t = (i + 0.5) / directions;
            const double weight = std::abs(end - begin) * 2.0 * t / directions;
            const Incidence incidence = Incidence::from_cos(std::sqrt(std::lerp(begin, end, t * t)));
            const auto responses = mean_responses(from_below, incidence, wavelengths_nm, by_twin);
            for (std::size_t k = 0; k < responses.size(); ++k) {
                reflected[k] += weight * responses[k].reflectance();
                passed[k] += weight * responses[k].transmittance();
            }
        }
    };
    add(critical, 0.0);
    add(critical, 1.0);
    std::vector<double> factors(wavelengths_nm.size());
    for (std::size_t k = 0; k < factors.size(); ++k) {
        const double rho = diffuse_reflectance(*mechanism.effects.base, wavelengths_nm[k]);
        factors[k] = std::min(rho * passed[k] / std::max(1.0 - rho * reflected[k], 1e-15), 1.0);
    }
    base_.emplace(mechanism, std::move(factors));
    return base_->second;
}

namespace {

// Layers with more samples of uneven thicknesses and slices than a bake has where it left an effect out, and with finer
// slices in any case.
LayerEnsemble fine_ensemble(const Mechanism& mechanism, const SpectralSampling& sampling) {
    constexpr int finer_slices = 3;
    constexpr int enough_slices = 96;
    constexpr int enough_samples = 256;
    const int samples = sampling.thickness_samples > 1 ? sampling.thickness_samples : enough_samples;
    const int slices = std::max(sampling.slices, std::min(finer_slices * sampling.slices, enough_slices));
    return layer_ensemble(mechanism, samples, {}, slices);
}

// What is seen of layers at one wavelength. @param base  factors of a base below, base_steps per nanometre; null: none
double seen_reflectance(const Response& response, double from_first_nm, Polarisation polarisation,
                        const std::vector<double>* base) {
    const double reflectance = reflectance_of(response, polarisation);
    if (base == nullptr) return reflectance;
    const double position = base_steps * from_first_nm;
    const auto cell = std::min(static_cast<std::size_t>(position), base->size() - 2);
    const double factor = std::lerp((*base)[cell], (*base)[cell + 1], position - static_cast<double>(cell));
    return reflectance + factor * transmittance_of(response, polarisation);
}

// Radians of the round trip through all layers from one part of a nanometre to the next. Towards grazing every face is
// a mirror, and fringes become narrow; but of many layers and fringes the narrowest parts would be too many.
double phase_per_part(double fringes, double layers, double cos_theta) {
    const double finest = std::clamp(1e-4 * fringes * layers, 0.002, 0.02);
    return longest_phase * std::clamp(4.0 * cos_theta, finest, 1.0);
}

struct Waves {
    std::vector<double> nm;
    std::vector<double> length_nm;
};

// @param is_smooth  whether the spectrum has no fringes: then the middles of the parts do
void add_piece_of_light(double nm, double length_nm, int parts, bool is_smooth, Waves& waves) {
    for (int part = 0; part < parts; ++part) {
        if (is_smooth) {
            waves.nm.push_back(nm + length_nm * (part + 0.5) / parts);
            waves.length_nm.push_back(length_nm / parts);
            continue;
        }
        for (const QuadratureNode& node : smooth_quadrature) {
            waves.nm.push_back(nm + length_nm * (part + node.at) / parts);
            waves.length_nm.push_back(node.share * length_nm / parts);
        }
    }
}

}  // namespace

Xyz Reference::layered(const Mechanism& mechanism, const Incidence& incidence) const {
    constexpr std::size_t samples_of_smooth_mean = 32;
    constexpr std::size_t enough_at_once = 1024;
    constexpr int most_parts_of_scalar = 16;  // fringes by the million are for the solver
    const LightSettings& light = job_.light->settings;
    const LayerEnsemble ensemble = fine_ensemble(mechanism, job_.sampling);
    const std::vector<double>* base = has_diffuse_base(mechanism) ? &base_table(mechanism, ensemble) : nullptr;
    const double fringes = fringe_count(mechanism, light);
    const double layers = expanded_layers(ensemble.systems.front());
    const double path_nm = fringes / (1.0 / light.first_nm - 1.0 / light.last_nm);
    const double phase_step = phase_per_part(fringes, layers, incidence.cos_theta);
    const bool is_smooth = ensemble.systems.size() >= samples_of_smooth_mean && !has_fine_lines_;
    Xyz sum;
    Waves waves;
    for (double nm = light.first_nm, next_nm = 0.0; nm < light.last_nm; nm = next_nm) {
        next_nm = next_kink(nm);
        const double length_nm = next_nm - nm;
        const double phase = 2.0 * std::numbers::pi * path_nm / (nm * nm) * length_nm;
        const int parts = std::max(1, static_cast<int>(std::ceil(phase / phase_step)));
        add_piece_of_light(nm, length_nm, parts, is_smooth, waves);
        if (waves.nm.size() < enough_at_once && next_nm < light.last_nm) continue;
        const bool by_scalar =
            ensemble.systems.size() == 1 && parts < most_parts_of_scalar && layers <= most_scalar_layers;
        const std::vector<Response> responses = mean_responses(ensemble, incidence, waves.nm, by_scalar);
        for (std::size_t i = 0; i < responses.size(); ++i) {
            const double seen =
                seen_reflectance(responses[i], waves.nm[i] - light.first_nm, mechanism.effects.polarisation, base);
            sum = plus(sum, waves.length_nm[i] * seen, weight_at(waves.nm[i]));
        }
        waves = {};
    }
    return sum;
}

Xyz Reference::at(double x, double y) const {
    const Mechanism mechanism = mechanism_at(job_, x, y);
    const Geometry geometry = geometry_at(job_, x, y);
    const Xyz seen =
        mechanism.effects.tilt_deg > 0.0 ? tilted(mechanism, geometry.incidence) : flat(mechanism, geometry);
    return adapt(adaptation_, seen);
}

}  // namespace nacre
