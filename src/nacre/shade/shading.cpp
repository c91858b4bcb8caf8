#include "nacre/shade/shading.h"

#include <algorithm>
#include <array>
#include <variant>

#include "nacre/optics/grating.h"
#include "nacre/optics/layered.h"
#include "nacre/optics/palette.h"
#include "nacre/optics/scatter.h"
#include "nacre/shade/kinks.h"
#include "nacre/shade/spectra.h"

namespace nacre {
namespace {

using Wavelengths = std::span<const double>;

std::vector<double> no_kinks(const Mechanism&) {
    return {};
}

// Responses of what says nothing of polarisation and lets nothing through.
template <typename Reflectance>
std::vector<Response> unpolarised(Wavelengths wavelengths_nm, const Reflectance& reflectance) {
    std::vector<Response> responses;
    for (const double nm : wavelengths_nm) {
        const double r = reflectance(nm);
        responses.push_back({r, r, 0.0, 0.0});
    }
    return responses;
}

// ---- palette

PreparedColour prepare_palette(const Mechanism& mechanism, const SpectralSampling&, const Light& light) {
    return PaletteColour(std::get<Palette>(mechanism), light);
}

std::vector<Response> palette_responses(const Mechanism& mechanism, const Geometry& geometry, Wavelengths nm) {
    const Lobe lobe = palette_lobe(std::get<Palette>(mechanism), geometry.incidence);
    return unpolarised(nm, [&](double wavelength_nm) { return lobe_reflectance(lobe, wavelength_nm); });
}

std::vector<double> palette_kinks(const Mechanism& mechanism) {
    return palette_bends_deg(std::get<Palette>(mechanism));
}

// ---- film, stack, crystal

PreparedColour prepare_layers(const Mechanism& mechanism, const SpectralSampling& sampling, const Light&) {
    return LayeredColour(mechanism, sampling);
}

std::vector<Response> layered_responses(const Mechanism& mechanism, const Geometry& geometry, Wavelengths nm) {
    return LayeredSpectra(mechanism, nm, spectrum_thickness_samples).at(geometry.incidence);
}

LayerSystem film_layers(const Mechanism& mechanism, int) {
    return layer_system(std::get<Film>(mechanism));
}
LayerSystem stack_layers(const Mechanism& mechanism, int) {
    return layer_system(std::get<Stack>(mechanism));
}
LayerSystem crystal_layers(const Mechanism& mechanism, int slices) {
    return layer_system(std::get<Crystal>(mechanism), slices);
}

// ---- grating

PreparedColour prepare_grating(const Mechanism& mechanism, const SpectralSampling&, const Light& light) {
    return GratingColour(std::get<Grating>(mechanism), light);
}

std::vector<Response> grating_responses(const Mechanism& mechanism, const Geometry& geometry, Wavelengths nm) {
    const auto& grating = std::get<Grating>(mechanism);
    const std::vector<int> orders = counted_orders(grating, *std::min_element(nm.begin(), nm.end()));
    return unpolarised(
        nm, [&](double wavelength_nm) { return grating_density(grating, orders, geometry.grating_u, wavelength_nm); });
}

// ---- scatter

PreparedColour prepare_scatter(const Mechanism& mechanism, const SpectralSampling& sampling, const Light&) {
    return ScatterColour(mechanism, sampling);
}

std::vector<Response> scatter_responses(const Mechanism& mechanism, const Geometry& geometry, Wavelengths nm) {
    const auto& scatter = std::get<Scatter>(mechanism);
    const ScatterSolver solver(scatter, nm, scatter.radius_spread > 0.0 ? spectrum_sizes : 1);
    std::vector<double> s(nm.size());
    std::vector<double> p(nm.size());
    solver.seen(geometry.cos_scatter, Polarisation::s, s);
    solver.seen(geometry.cos_scatter, Polarisation::p, p);
    std::vector<Response> responses;
    for (std::size_t i = 0; i < s.size(); ++i) responses.push_back({s[i], p[i], 0.0, 0.0});
    return responses;
}

// ---- measured

PreparedColour prepare_measured(const Mechanism& mechanism, const SpectralSampling&, const Light& light) {
    return MeasuredColour(std::get<MeasuredSpectra>(mechanism), light);
}

std::vector<Response> measured_responses(const Mechanism& mechanism, const Geometry& geometry, Wavelengths nm) {
    const auto& spectra = std::get<MeasuredSpectra>(mechanism);
    return unpolarised(nm, [&](double wavelength_nm) {
        return measured_reflectance(spectra, geometry.incidence.theta_deg, wavelength_nm);
    });
}

std::vector<double> measured_kinks(const Mechanism& mechanism) {
    return std::get<MeasuredSpectra>(mechanism).angle_deg;
}

constexpr std::array<ShadingRow, std::variant_size_v<MechanismModel>> rows{{
    {false, prepare_palette, palette_responses, palette_kinks, nullptr},
    {true, prepare_layers, layered_responses, layered_kinks_deg, film_layers},
    {true, prepare_layers, layered_responses, layered_kinks_deg, stack_layers},
    {false, prepare_grating, grating_responses, no_kinks, nullptr},
    {true, prepare_layers, layered_responses, layered_kinks_deg, crystal_layers},
    {true, prepare_scatter, scatter_responses, no_kinks, nullptr},
    {false, prepare_measured, measured_responses, measured_kinks, nullptr},
}};

static_assert(rows.back().prepare != nullptr, "shade/shading.cpp: one row per mechanism");

}  // namespace

const ShadingRow& shading_of(const Mechanism& mechanism) {
    return rows[mechanism.index()];
}

}  // namespace nacre
