#include "nacre/bake/layered_colour.h"

#include <utility>

#include "nacre/optics/irregular.h"

namespace nacre {
namespace {

struct Regular {
    LayerSystem operator()(const Palette&) const { return {}; }
    LayerSystem operator()(const Film& film) const { return layer_system(film); }
    LayerSystem operator()(const Stack& stack) const { return layer_system(stack); }
};

struct Spread {
    double operator()(const Palette&) const { return 0.0; }
    double operator()(const Film& film) const { return film.thickness_spread_nm; }
    double operator()(const Stack& stack) const { return stack.thickness_spread_nm; }
};

}  // namespace

bool needs_sampling(const Mechanism& mechanism) {
    return !std::holds_alternative<Palette>(mechanism);
}

bool is_irregular(const Mechanism& mechanism) {
    return std::visit(Spread{}, mechanism) > 0.0;
}

std::vector<LayerSystem> layer_systems(const Mechanism& mechanism, int realisations,
                                       std::span<const std::size_t> blurred) {
    LayerSystem regular = std::visit(Regular{}, mechanism);
    for (const std::size_t node : blurred) regular.nodes[node].is_incoherent = true;
    const double spread_nm = std::visit(Spread{}, mechanism);
    if (spread_nm == 0.0 || realisations < 2) return {std::move(regular)};
    return irregular_systems(regular, spread_nm, realisations);
}

LayeredColour::LayeredColour(const Mechanism& mechanism, SpectralSampling sampling)
    : sampling_(std::move(sampling)), systems_(layer_systems(mechanism, sampling_.realisations, sampling_.blurred)) {}

Xyz LayeredColour::at(const Incidence& incidence) {
    const std::size_t band = band_of(incidence);
    const SpectralNodes& nodes = *sampling_.nodes[band];
    if (solvers_[band].empty()) {
        for (const LayerSystem& system : systems_) solvers_[band].emplace_back(system, nodes.wavelength_nm);
    }
    Xyz sum;
    for (const MultilayerSolver& solver : solvers_[band]) {
        const auto [x, y, z] =
            solver.weighted_reflectances(incidence, {nodes.x.data(), nodes.y.data(), nodes.z.data()});
        sum = {sum.x + x, sum.y + y, sum.z + z};
    }
    const double share = 1.0 / static_cast<double>(systems_.size());
    return {share * sum.x, share * sum.y, share * sum.z};
}

std::uint64_t LayeredColour::samples(const Incidence& incidence) const {
    return static_cast<std::uint64_t>(sampling_.nodes[band_of(incidence)]->count) * systems_.size();
}

std::vector<Response> layered_responses(const Mechanism& mechanism, const Incidence& incidence,
                                        std::span<const double> wavelengths_nm, int realisations) {
    std::vector<Response> mean(wavelengths_nm.size());
    std::vector<Response> one(wavelengths_nm.size());
    const std::vector<LayerSystem> systems = layer_systems(mechanism, realisations);
    const double share = 1.0 / static_cast<double>(systems.size());
    for (const LayerSystem& system : systems) {
        MultilayerSolver(system, wavelengths_nm).responses(incidence, one);
        for (std::size_t i = 0; i < one.size(); ++i) {
            mean[i].reflectance_s += share * one[i].reflectance_s;
            mean[i].reflectance_p += share * one[i].reflectance_p;
            mean[i].transmittance_s += share * one[i].transmittance_s;
            mean[i].transmittance_p += share * one[i].transmittance_p;
        }
    }
    return mean;
}

}  // namespace nacre
