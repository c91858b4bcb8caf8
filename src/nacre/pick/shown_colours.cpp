#include "nacre/pick/shown_colours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/crystal.h"
#include "nacre/optics/grating.h"
#include "nacre/shade/prepared_colour.h"
#include "nacre/shade/work.h"

namespace nacre {
namespace {

struct SamplingRule {
    double nodes_per_fringe;  // Chebyshev nodes need pi before their error falls
    int fewest_nodes;
    int most_nodes;
    double nm_per_slice;  // of a crystal's planes
    int fewest_slices;
    int samples;       // of uneven layers
    int nm_per_piece;  // of a grating's colour
};
constexpr SamplingRule rule_of(SearchDetail detail) {
    switch (detail) {
        case SearchDetail::table:
            return {2.0, 16, 64, 25.0, 8, 4, 20};
        case SearchDetail::refinement:
            return {3.5, 32, 1024, 12.0, 16, 8, 5};
        case SearchDetail::report:
            return {8.0, 128, 1 << 17, 4.0, 64, 64, 1};
    }
    return {};
}

// Nodes come in eights, and in few numbers, because making them takes as long as thousands of colours.
int rounded_up(int count) {
    int step = 8;
    while (count > 8 * step) step *= 2;
    return (count + step - 1) / step * step;
}

// Slices come in fours.
int slices_of(const Crystal& crystal, const SamplingRule& rule) {
    constexpr double most_slices = 512.0;
    const double wanted = std::min(plane_spacing_nm(crystal) / rule.nm_per_slice, most_slices);
    return std::max(rule.fewest_slices, (static_cast<int>(wanted) + 3) / 4 * 4);
}

// Of a grating's pieces, so that a deep profile is not cut up further; 1: as for a bake.
int nm_per_piece(const Grating& grating, const LightSettings& light, const SamplingRule& rule) {
    const double depth_nm = grating.profile == GratingProfile::given ? 0.0 : grating.depth_nm;
    int nm = rule.nm_per_piece;
    while (nm > 1 && nm * profile_phase_per_nm(depth_nm, light.first_nm) > most_coarse_phase_change) nm /= 2;
    return nm;
}

// A layer of metal, whose n is smaller than its k, is a mirror: with another one below, its resonances are far narrower
// than fringes.
bool has_mirrors(const Mechanism& mechanism, const LightSettings& light) {
    bool has = false;
    for_each_index(mechanism, [&](const Index& index, IndexRole role) {
        const RefractiveIndex n = index.at(0.5 * (light.first_nm + light.last_nm));
        has = has || (role == IndexRole::layer && n.real() < n.imag());
    });
    return has;
}

}  // namespace

ShownColours::ShownColours(const Light& light, std::vector<Geometry> places)
    : light_(light), places_(std::move(places)), nodes_(light.weights) {
    if (light.settings.wavelengths)
        grid_nodes_ = std::make_shared<const SpectralNodes>(make_spectral_nodes(light.grid_weights, light.grid));
}

SearchSampling ShownColours::sampling_for(const Mechanism& mechanism, SearchDetail detail, int times) {
    SearchSampling sampling;
    const SamplingRule rule = rule_of(detail);
    if (const auto* grating = std::get_if<Grating>(&mechanism)) {
        const int nm = nm_per_piece(*grating, light_.settings, rule);
        if (nm == 1) return sampling;
        auto& pieces = pieces_[nm];
        if (!pieces) pieces = std::make_shared<const GratingPieces>(grating_pieces(light_.weights, nm, 0.0));
        sampling.pieces = pieces;
    }
    if (!samples_spectra(mechanism)) return sampling;
    SpectralSampling& spectra = sampling.spectra;
    if (const auto* crystal = std::get_if<Crystal>(&mechanism)) spectra.slices = slices_of(*crystal, rule);
    if (is_irregular(mechanism)) spectra.thickness_samples = rule.samples;
    // Empirical: with fewer, 2 of 200 cavities of silver and silica become others, which are off by 0.4.
    constexpr int times_of_mirrors = 4;
    if (detail != SearchDetail::report && has_mirrors(mechanism, light_.settings)) times *= times_of_mirrors;
    const double wanted =
        times * (rule.fewest_nodes + rule.nodes_per_fringe * fringe_count(mechanism, light_.settings));
    const int count = std::min(rule.most_nodes, rounded_up(static_cast<int>(std::min(wanted, 1e6))));
    spectra.nodes.fill(grid_nodes_ != nullptr ? grid_nodes_ : nodes_.of(count));
    return sampling;
}

void ShownColours::at(const Mechanism& mechanism, const SearchSampling& sampling, std::span<Xyz> shown) const {
    const auto* grating = std::get_if<Grating>(&mechanism);
    PreparedColour prepared = grating != nullptr && sampling.pieces
                                  ? GratingColour(*grating, light_, sampling.pieces)
                                  : prepare_colour(mechanism, sampling.spectra, light_);
    Work work;
    for (std::size_t i = 0; i < places_.size(); ++i)
        shown[i] = adapt(light_.adaptation, colour_at(prepared, places_[i], work));
}

}  // namespace nacre
