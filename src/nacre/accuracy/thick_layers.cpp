// Which layers are so thick that their fringes are not seen.
//
// In: a job whose axes leave its material as it is. Candidates are the layers with the finest fringes, one after the
// other, as long as each is fine beside all that is left. They are taken all together, if colours at four angles do not
// change by more than the tolerance when these layers become incoherent; else none is. That holds for the light that is
// reflected and for that which is transmitted, whichever is asked for, so that both go together.
#include "nacre/accuracy/thick_layers.h"

#include <algorithm>
#include <cmath>

#include "nacre/colour/difference.h"
#include "nacre/lut/job.h"
#include "nacre/shade/layered_colour.h"

namespace nacre {
namespace {

// Fringes that may be too fine to be seen: of some 16 micrometres of glass (empirical).
constexpr double fine_fringes = 75.0;
// So much finer than all others together that no two of them beat (empirical).
constexpr double finer_than_others = 3.0;

// Only in such a layer do fringes stay fine at every angle: in a thinner medium the wave comes to run along the layer,
// and near the critical angle fringes are as coarse as one likes.
bool is_denser_than_incident(const LayerSystem& system, int medium, const LightSettings& light) {
    constexpr double clearly = 1.05;
    for (const int nm : {light.first_nm, (light.first_nm + light.last_nm) / 2, light.last_nm}) {
        const double n0 = system.index_at(system.incident, nm).real();
        if (system.index_at(medium, nm).real() < clearly * n0) return false;
    }
    return true;
}

// The finest, then the finest of what is left, as long as each is fine beside all the others.
std::vector<std::size_t> candidates(LayerSystem system, const LightSettings& light) {
    std::vector<std::size_t> thick;
    for (;;) {
        std::size_t thickest = 0;
        double most = 0.0;
        for (std::size_t i = 0; i < system.nodes.size(); i += 1 + static_cast<std::size_t>(system.nodes[i].count)) {
            const LayerNode& node = system.nodes[i];
            // Only a layer that is thick enough is worth the sum over all of its wavelengths.
            if (node.repeat > 0 || node.is_incoherent || node.thickness_nm < 1000.0) continue;
            if (!is_denser_than_incident(system, node.medium, light)) continue;
            LayerSystem alone = system;
            alone.nodes = {node};
            const double fringes = fringe_count(alone, light);
            if (fringes <= most) continue;
            most = fringes;
            thickest = i;
        }
        if (most < fine_fringes || most < finer_than_others * (fringe_count(system, light) - most)) return thick;
        thick.push_back(thickest);
        system.nodes[thickest].is_incoherent = true;
    }
}

// Up to the tolerance, at four angles. What is black shows nothing.
bool show_the_same(const Mechanism& mechanism, const SpectralSampling& one, const SpectralSampling& other,
                   const Light& light, double tolerance) {
    LayeredColour sharp(mechanism, one);
    LayeredColour incoherent(mechanism, other);
    std::vector<Xyz> seen;
    std::vector<Xyz> meant;
    double brightest = 0.0;
    for (const double angle_deg : {0.0, 25.0, 45.0, 60.0}) {
        const Incidence incidence = Incidence::from_degrees(angle_deg);
        seen.push_back(adapt(light.adaptation, incoherent.at(incidence)));
        meant.push_back(adapt(light.adaptation, sharp.at(incidence)));
        brightest = std::max(brightest, meant.back().y);
    }
    if (!(brightest > black_luminance)) return true;
    const double scale = display_scale(brightest);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (difference_at(seen[i], meant[i], scale) > tolerance) return false;
    }
    return true;
}

}  // namespace

std::vector<std::size_t> thick_layers(const Job& job, double tolerance) {
    if (job.moves_material()) return {};
    const Mechanism& mechanism = job.material.mechanism;
    const Light& light = *job.light;
    const LayerSystem system = even_system(mechanism);
    std::vector<std::size_t> thick = candidates(system, light.settings);
    if (thick.empty()) return {};

    LayerSystem without = system;
    for (const std::size_t node : thick) without.nodes[node].is_incoherent = true;
    constexpr double nodes_per_fringe = 8.0;
    constexpr int fewest = 128;
    const auto sampling = [&](const LayerSystem& layers, const std::vector<std::size_t>& incoherent) {
        const int count = std::max(fewest, static_cast<int>(nodes_per_fringe * fringe_count(layers, light.settings)));
        SpectralSampling result;
        result.nodes.fill(std::make_shared<const SpectralNodes>(make_spectral_nodes(light.weights, count)));
        result.incoherent_layers = incoherent;
        return result;
    };
    const SpectralSampling sharp = sampling(system, {}), incoherent = sampling(without, thick);
    for (const Observed observed : {Observed::reflectance, Observed::transmittance}) {
        Mechanism seen = mechanism;
        seen.effects.observed = observed;
        if (observed == Observed::transmittance && seen.effects.base) break;
        if (!show_the_same(seen, sharp, incoherent, light, tolerance)) return {};
    }
    return thick;
}

}  // namespace nacre
