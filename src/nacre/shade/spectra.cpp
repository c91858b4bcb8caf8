#include "nacre/shade/spectra.h"

#include <optional>

#include "nacre/shade/facets.h"
#include "nacre/shade/layered_colour.h"
#include "nacre/shade/shading.h"

namespace nacre {
std::vector<Response> responses_at(const Mechanism& mechanism, const Geometry& geometry,
                                   std::span<const double> wavelengths_nm) {
    if (wavelengths_nm.empty()) return {};
    const Relief& relief = mechanism.effects.relief;
    if (relief.is_plane()) return shading_of(mechanism).responses(mechanism, geometry, wavelengths_nm);
    // Facet by facet: a spectrum is needed once, so no curve is prepared.
    constexpr int thickness_samples_of_facets = 256;
    std::optional<LayeredSpectra> layers;
    if (is_layered(mechanism)) layers.emplace(mechanism, wavelengths_nm, thickness_samples_of_facets);
    std::vector<Response> mean(wavelengths_nm.size());
    FacetPoints points;
    points.intervals = facet_intervals(mechanism);
    for (const Facet& facet : seen_facets(relief, geometry.incidence, points)) {
        const Incidence incidence = Incidence::from_cos(facet.cos_theta);
        const auto responses =
            layers ? layers->at(incidence) : shading_of(mechanism).responses(mechanism, incidence, wavelengths_nm);
        for (std::size_t i = 0; i < mean.size(); ++i) add(mean[i], facet.share, responses[i]);
    }
    return mean;
}

std::shared_ptr<const IndexCurve> unknown_at(const Mechanism& mechanism, double wavelength_nm) {
    std::shared_ptr<const IndexCurve> unknown;
    for_each_index(mechanism, [&](const Index& index, IndexRole) {
        if (unknown || index.is_constant() || index.curve->holds_outside) return;
        if (wavelength_nm < index.curve->first_nm || wavelength_nm > index.curve->last_nm) unknown = index.curve;
    });
    return unknown;
}

Response response_at(const Mechanism& mechanism, const Geometry& geometry, double wavelength_nm) {
    return responses_at(mechanism, geometry, {&wavelength_nm, 1}).front();
}

Spectrum observed_spectrum(const Mechanism& mechanism, const Geometry& geometry, const WavelengthGrid& grid) {
    std::vector<double> wavelengths_nm;
    for (int node = 0; node < grid.count; ++node) wavelengths_nm.push_back(grid.wavelength_nm(node));
    Spectrum spectrum{grid, {}};
    for (const Response& response : responses_at(mechanism, geometry, wavelengths_nm))
        spectrum.value.push_back(observed_of(response, mechanism.effects.observed, mechanism.effects.polarisation));
    return spectrum;
}

}  // namespace nacre
