#include "nacre/shade/spectral_sampling.h"

#include <algorithm>
#include <cmath>

#include "nacre/shade/layered_colour.h"
#include "nacre/shade/shading.h"

namespace nacre {

std::size_t band_of(const Incidence& incidence) {
    std::size_t band = 0;
    while (incidence.cos_theta < band_least_cos_theta[band]) ++band;
    return band;
}

SamplingCounts SpectralSampling::counts() const {
    SamplingCounts counts{{}, thickness_samples, base_directions, radii, slices};
    for (std::size_t band = 0; band < nodes.size(); ++band) counts.nodes[band] = nodes[band] ? nodes[band]->count : 0;
    return counts;
}

bool samples_spectra(const Mechanism& mechanism) {
    return shading_of(mechanism).samples_spectra;
}

namespace {

double optical_path_nm(const LayerSystem& system, double wavelength_nm, std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        const LayerNode& node = system.nodes[i];
        const auto members = static_cast<std::size_t>(node.count);
        if (node.repeat > 0) {
            sum += node.repeat * optical_path_nm(system, wavelength_nm, i + 1, i + 1 + members);
        } else if (!node.is_incoherent) {
            sum += node.thickness_nm * system.index_at(node.medium, wavelength_nm).real();
        }
        i += members;
    }
    return sum;
}

}  // namespace

double fringe_count(const LayerSystem& system, const LightSettings& light) {
    double path_nm = 0.0;
    for (const int nm : {light.first_nm, (light.first_nm + light.last_nm) / 2, light.last_nm})
        path_nm = std::max(path_nm, optical_path_nm(system, nm, 0, system.nodes.size()));
    return 2.0 * path_nm * (1.0 / light.first_nm - 1.0 / light.last_nm);
}

double fringe_count(const Mechanism& mechanism, const LightSettings& light) {
    return is_layered(mechanism) ? fringe_count(even_system(mechanism), light) : 0.0;
}

int facet_intervals(const Mechanism& mechanism) {
    // Palettes and measured spectra have kinks at their angles, and cost next to nothing.
    constexpr int of_closed_forms = 64;
    constexpr int of_smooth_layers = 8;
    // Of the phase between two reflections a part changes with the angle, in all by at most this many turns per fringe
    // of the visible range, where blue has twice the order of red.
    constexpr double per_fringe = 2.0;
    constexpr int most = 1024;
    if (!samples_spectra(mechanism)) return of_closed_forms;
    const double fringes = fringe_count(mechanism, LightSettings{});
    return std::min(of_smooth_layers + static_cast<int>(per_fringe * fringes), most);
}

namespace {

// Layers that a solver goes through: a group once, and its matrix as often as its number of repeats has bits.
double solved_layers(const LayerSystem& system) {
    double layers = 0.0;
    for (const LayerNode& node : system.nodes) layers += node.repeat > 0 ? 2.0 * std::log2(node.repeat) : 1.0;
    return layers;
}

}  // namespace

double effort_per_sample(const Mechanism& mechanism, int slices) {
    constexpr double of_a_layer = 0.25;
    constexpr double of_a_line = 4.0;  // a grating's, within one nanometre
    // Two samples are requested of random thicknesses, because then no layer repeats.
    if (is_layered(mechanism))
        return 1.0 + of_a_layer * solved_layers(layer_ensemble(mechanism, 2, {}, slices).systems.front());
    return std::holds_alternative<Grating>(mechanism) ? of_a_line : 1.0;
}

}  // namespace nacre
