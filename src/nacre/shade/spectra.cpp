#include "nacre/shade/spectra.h"

#include <algorithm>
#include <optional>

#include "nacre/material/effects.h"
#include "nacre/optics/scatter.h"
#include "nacre/shade/layered_colour.h"
#include "nacre/shade/tilt.h"

namespace nacre {
namespace {

// One row per mechanism: what becomes of light at some wavelengths; all but tilt.
struct ResponsesAt {
    const Mechanism& mechanism;
    const Geometry& geometry;
    std::span<const double> wavelengths_nm;

    std::vector<Response> operator()(const Palette& palette) const {
        const Lobe lobe = palette_lobe(palette, geometry.incidence);
        return unpolarised([&](double nm) { return lobe_reflectance(lobe, nm); });
    }
    std::vector<Response> operator()(const Film&) const { return layered(); }
    std::vector<Response> operator()(const Stack&) const { return layered(); }
    std::vector<Response> operator()(const Grating& grating) const {
        const double least_nm = *std::min_element(wavelengths_nm.begin(), wavelengths_nm.end());
        const std::vector<int> orders = counted_orders(grating, least_nm);
        return unpolarised([&](double nm) { return grating_density(grating, orders, geometry.grating_u, nm); });
    }
    std::vector<Response> operator()(const Crystal&) const { return layered(); }
    std::vector<Response> operator()(const Scatter& scatter) const {
        const ScatterSolver solver(scatter, wavelengths_nm, scatter.radius_spread > 0.0 ? spectrum_sizes : 1);
        std::vector<double> s(wavelengths_nm.size());
        std::vector<double> p(wavelengths_nm.size());
        solver.seen(geometry.cos_scatter, Polarisation::s, s);
        solver.seen(geometry.cos_scatter, Polarisation::p, p);
        std::vector<Response> responses;
        for (std::size_t i = 0; i < s.size(); ++i) responses.push_back({s[i], p[i], 0.0, 0.0});
        return responses;
    }
    std::vector<Response> operator()(const MeasuredSpectra& spectra) const {
        return unpolarised([&](double nm) { return measured_reflectance(spectra, geometry.incidence.theta_deg, nm); });
    }

    std::vector<Response> layered() const {
        return LayeredSpectra(mechanism, wavelengths_nm, spectrum_realisations).at(geometry.incidence);
    }
    template <typename Reflectance>
    std::vector<Response> unpolarised(const Reflectance& reflectance) const {
        std::vector<Response> responses;
        for (const double nm : wavelengths_nm) {
            const double r = reflectance(nm);
            responses.push_back({r, r, 0.0, 0.0});
        }
        return responses;
    }
};

std::vector<Response> flat_responses(const Mechanism& mechanism, const Geometry& geometry,
                                     std::span<const double> wavelengths_nm) {
    return std::visit(ResponsesAt{mechanism, geometry, wavelengths_nm}, static_cast<const MechanismModel&>(mechanism));
}

}  // namespace

std::vector<Response> responses_at(const Mechanism& mechanism, const Geometry& geometry,
                                   std::span<const double> wavelengths_nm) {
    if (wavelengths_nm.empty()) return {};
    const double tilt_deg = mechanism.effects.tilt_deg;
    if (tilt_deg == 0.0) return flat_responses(mechanism, geometry, wavelengths_nm);
    // Facet by facet: a spectrum is asked for once, and wants no curve.
    constexpr int realisations_of_facets = 256;
    std::optional<LayeredSpectra> layers;
    if (is_layered(mechanism)) layers.emplace(mechanism, wavelengths_nm, realisations_of_facets);
    std::vector<Response> mean(wavelengths_nm.size());
    for (const Facet& facet : visible_facets(tilt_deg, geometry.incidence)) {
        const Incidence incidence = Incidence::from_cos(facet.cos_theta);
        const auto responses = layers ? layers->at(incidence) : flat_responses(mechanism, incidence, wavelengths_nm);
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

Spectrum reflectance(const Mechanism& mechanism, const Geometry& geometry, const WavelengthGrid& grid) {
    std::vector<double> wavelengths_nm;
    for (int node = 0; node < grid.count; ++node) wavelengths_nm.push_back(grid.wavelength_nm(node));
    Spectrum spectrum{grid, {}};
    for (const Response& response : responses_at(mechanism, geometry, wavelengths_nm))
        spectrum.value.push_back(reflectance_of(response, mechanism.effects.polarisation));
    return spectrum;
}

}  // namespace nacre
