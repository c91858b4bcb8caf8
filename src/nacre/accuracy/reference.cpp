#include "nacre/accuracy/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/bake/bake.h"
#include "nacre/bake/layered_colour.h"
#include "nacre/bake/sampler.h"
#include "nacre/colour/cie_tables.h"

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

// Of all systems, by the solver or by its simple twin.
std::vector<double> mean_reflectances(const std::vector<LayerSystem>& systems, const Incidence& incidence,
                                      const std::vector<double>& wavelengths_nm, bool by_twin) {
    std::vector<double> mean(wavelengths_nm.size());
    std::vector<Response> responses(wavelengths_nm.size());
    for (const LayerSystem& system : systems) {
        if (by_twin) {
            for (std::size_t i = 0; i < responses.size(); ++i)
                responses[i] = multilayer_response(system, incidence, wavelengths_nm[i]);
        } else {
            MultilayerSolver(system, wavelengths_nm).responses(incidence, responses);
        }
        for (std::size_t i = 0; i < responses.size(); ++i)
            mean[i] += responses[i].reflectance() / static_cast<double>(systems.size());
    }
    return mean;
}

}  // namespace

Reference::Reference(const Job& job) : job_(job) {
    const LightSettings& light = job.light->settings;
    Xyz white;
    for (int nm = light.first_nm; nm <= light.last_nm; ++nm) {
        const auto& bars = colour_matching(light.observer, nm);
        const double power = light.power.at(nm);
        weights_.push_back({power * bars[0], power * bars[1], power * bars[2]});
        const double share = nm == light.first_nm || nm == light.last_nm ? 0.5 : 1.0;  // trapezia
        white = plus(white, share, weights_.back());
    }
    for (Xyz& weight : weights_) weight = plus({}, 1.0 / white.y, weight);
    white = plus({}, 1.0 / white.y, white);
    adaptation_ = adaptation_matrix(light.adaptation, white, xyz_from_chromaticity(d65_chromaticity));
}

Xyz Reference::weight_at(double nm) const {
    const double position = nm - job_.light->settings.first_nm;
    const auto cell = std::min(static_cast<std::size_t>(position), weights_.size() - 2);
    const double along = position - static_cast<double>(cell);
    return plus(plus({}, 1.0 - along, weights_[cell]), along, weights_[cell + 1]);
}

Xyz Reference::integral(const Lobe& lobe) const {
    const LightSettings& light = job_.light->settings;
    const double from_nm = std::max(lobe.peak_nm - 0.5 * lobe.width_nm, static_cast<double>(light.first_nm));
    const double to_nm = std::min(lobe.peak_nm + 0.5 * lobe.width_nm, static_cast<double>(light.last_nm));
    if (!(from_nm < to_nm)) return {};
    // The cosine of a narrow band bends within a nanometre.
    const double longest_nm = std::min(1.0, 0.125 * (to_nm - from_nm));
    Xyz sum;
    for (double left = from_nm; left < to_nm;) {
        const double right = std::min({std::floor(left) + 1.0, to_nm, left + longest_nm});
        if (!(right > left)) break;  // the rest is narrower than a double resolves
        for (const QuadratureNode& node : quadrature) {
            const double nm = left + node.at * (right - left);
            sum = plus(sum, node.share * (right - left) * lobe_reflectance(lobe, nm), weight_at(nm));
        }
        left = right;
    }
    return sum;
}

Xyz Reference::layered(const Mechanism& mechanism, const Incidence& incidence) const {
    const LightSettings& light = job_.light->settings;
    const std::vector<LayerSystem> systems = layer_systems(mechanism, job_.sampling.realisations);
    const double range_per_nm = 1.0 / light.first_nm - 1.0 / light.last_nm;
    const double path_nm = fringe_count(mechanism, light) / range_per_nm;
    // Towards grazing light every face is a mirror, and fringes become sharp.
    const double phase_step = longest_phase * std::clamp(4.0 * incidence.cos_theta, 0.02, 1.0);
    Xyz sum;
    std::vector<double> wavelengths_nm;
    std::vector<double> shares;
    for (int nm = light.first_nm; nm < light.last_nm; ++nm) {
        const double phase = 2.0 * std::numbers::pi * path_nm / (static_cast<double>(nm) * nm);
        const int parts = std::max(1, static_cast<int>(std::ceil(phase / phase_step)));
        for (int part = 0; part < parts; ++part) {
            for (const QuadratureNode& node : smooth_quadrature) {
                wavelengths_nm.push_back(nm + (part + node.at) / parts);
                shares.push_back(node.share / parts);
            }
        }
        constexpr std::size_t enough = 1024;
        if (wavelengths_nm.size() < enough && nm + 1 < light.last_nm) continue;
        // Fringes by the million are for the fast road.
        const bool is_plain = systems.size() == 1 && parts < 16 && expanded_layers(systems.front()) <= most_twin_layers;
        const std::vector<double> reflectances = mean_reflectances(systems, incidence, wavelengths_nm, is_plain);
        for (std::size_t i = 0; i < reflectances.size(); ++i)
            sum = plus(sum, shares[i] * reflectances[i], weight_at(wavelengths_nm[i]));
        wavelengths_nm.clear();
        shares.clear();
    }
    return sum;
}

Xyz Reference::at(double x, double y) const {
    const Mechanism mechanism = mechanism_at(job_, x, y);
    const Incidence incidence = incidence_at(job_, x, y);
    const auto* palette = std::get_if<Palette>(&mechanism);
    const Xyz seen = palette != nullptr ? integral(palette_lobe(*palette, incidence)) : layered(mechanism, incidence);
    return adapt(adaptation_, seen);
}

}  // namespace nacre
