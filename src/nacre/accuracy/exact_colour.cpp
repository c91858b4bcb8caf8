#include "nacre/accuracy/exact_colour.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "nacre/accuracy/choose_sums.h"
#include "nacre/accuracy/mechanism_traits.h"
#include "nacre/accuracy/probes.h"
#include "nacre/colour/difference.h"
#include "nacre/material/effects.h"
#include "nacre/shade/facets.h"
#include "nacre/shade/layered_colour.h"
#include "nacre/shade/prepared_colour.h"
#include "nacre/shade/spectra.h"

namespace nacre {
namespace {

// Layers may have resonances that are as sharp as nothing else in the spectrum: these nodes are 0.6 nm apart. They cost
// a film 4 microseconds.
constexpr int fewest_of_layers = 768;
// Means over thicknesses or radii are smooth, and so is what spheres scatter.
constexpr int fewest_of_means = 64;
constexpr double nodes_per_fringe = 2.0;  // Nyquist

// CIEDE2000. Uneven thicknesses have as many samples as a spectrum has (spectra.h), but for tilted facets.
constexpr double agreement = 1e-4;
constexpr double tolerance_of_sums = 1e-3;
constexpr double tolerance_of_tilted_thicknesses = 0.05;

int first_count(const Mechanism& mechanism, const LightSettings& light) {
    const bool is_smooth = !is_layered(mechanism) || is_irregular(mechanism);
    const int resolved = static_cast<int>(nodes_per_fringe * fringe_count(mechanism, light));
    return std::clamp(resolved, is_smooth ? fewest_of_means : fewest_of_layers, most_nodes / 2);
}

// Palettes and measured spectra have kinks at their angles, and cost next to nothing.
constexpr FacetPoints facets_of_closed_forms{32, 48};

// Of rough surfaces some facets lean by any angle.
constexpr double lean_of_rough_facets_deg = 45.0;

std::vector<Geometry> probed_geometries(const Mechanism& mechanism, const Geometry& geometry) {
    std::vector<Geometry> probed{geometry};
    const Relief& relief = mechanism.effects.relief;
    if (relief.is_plane()) return probed;
    const double lean_deg = relief.roughness > 0.0 ? lean_of_rough_facets_deg : relief.tilt_deg;
    for (const double theta_deg : {geometry.incidence.theta_deg - lean_deg, geometry.incidence.theta_deg + lean_deg})
        probed.emplace_back(Incidence::from_degrees(std::clamp(std::abs(theta_deg), 0.0, 90.0)));
    return probed;
}

// As many points of each sum as the colour at this geometry needs.
// @param count  of nodes that resolve the spectrum
SpectralSampling sums_at(const Job& job, const Geometry& geometry, int count, const std::shared_ptr<NodeMaker>& nodes,
                         ProbeTally& tally) {
    const Mechanism& mechanism = job.material.mechanism;
    const EffectSet effects = effects_in(job);
    Probes probes{job, {}, {}, nodes};
    probes.bands.front().push_back({mechanism, mechanism, probed_geometries(mechanism, geometry)});
    SpectralSampling sums;
    if (effects.has(Effect::size_spread)) sums.radii = choose_radii(probes, sums, tolerance_of_sums, 0, tally).count;
    if (traits_of(mechanism).has_slices) sums.slices = choose_slices(probes, sums, tolerance_of_sums, 0, tally).count;
    if (!is_layered(mechanism)) return sums;
    sums = with_nodes(sums, nodes->of(count));
    if (effects.has(Effect::base))
        sums.base_directions = choose_base_directions(probes, sums, {}, tolerance_of_sums, 0, tally).count;
    if (!is_irregular(mechanism)) return sums;
    sums.thickness_samples =
        mechanism.effects.relief.is_plane()
            ? spectrum_thickness_samples
            : choose_thickness_samples(probes, sums, {}, tolerance_of_tilted_thicknesses, 0, tally).count;
    return sums;
}

// @param work  what it takes is added
Xyz mean_of_facets(const Mechanism& mechanism, const Geometry& geometry, const SpectralSampling& sampling,
                   const Light& light, Work& work) {
    PreparedColour prepared = prepare_colour(mechanism, sampling, light);
    if (mechanism.effects.relief.is_plane()) return colour_at(prepared, geometry, work);
    Xyz mean;
    FacetPoints points = samples_spectra(mechanism) ? FacetPoints{} : facets_of_closed_forms;
    points.intervals = facet_intervals(mechanism);
    for (const Facet& facet : seen_facets(mechanism.effects.relief, geometry.incidence, points)) {
        const Xyz seen = colour_at(prepared, Incidence::from_cos(facet.cos_theta), work);
        mean = {mean.x + facet.share * seen.x, mean.y + facet.share * seen.y, mean.z + facet.share * seen.z};
    }
    return mean;
}

bool agree(const Xyz& one, const Xyz& other, const Light& light) {
    const Xyz first = adapt(light.adaptation, one);
    const Xyz second = adapt(light.adaptation, other);
    const double luminance = std::max(first.y, second.y);
    return !(luminance > black_luminance) || difference_at(first, second, display_scale(luminance)) <= agreement;
}

}  // namespace

// The second of the first two counts that agree, or the last that memory and effort allow.
Xyz ExactColours::converged(const Mechanism& mechanism, const Geometry& geometry) {
    Job job;
    job.material.mechanism = mechanism;
    job.light = {std::shared_ptr<const Light>(), &light_};  // lent for as long as this function runs
    int count = first_count(mechanism, light_.settings);
    ProbeTally tally;
    const SpectralSampling sums = sums_at(job, geometry, count, nodes_, tally);
    const double per_sample = effort_per_sample(mechanism, sums.slices);
    const auto colour_of = [&](int nodes_count) {
        return mean_of_facets(mechanism, geometry, with_nodes(sums, nodes_->of(nodes_count)), light_, tally.work);
    };
    Xyz before = colour_of(count);
    for (;;) {
        count *= 2;
        const Xyz colour = colour_of(count);
        if (agree(before, colour, light_) || 2 * count > most_nodes || is_effort_spent(tally, per_sample))
            return colour;
        before = colour;
    }
}

Xyz ExactColours::at(const Mechanism& mechanism, const Geometry& geometry) {
    if (light_.settings.wavelengths)
        return to_xyz(light_.grid_weights, observed_spectrum(mechanism, geometry, light_.grid));
    if (samples_spectra(mechanism)) return converged(mechanism, geometry);
    Work ignored;
    return mean_of_facets(mechanism, geometry, {}, light_, ignored);
}

Xyz reflectance_xyz(const Mechanism& mechanism, const Geometry& geometry, const Light& light) {
    return ExactColours(light).at(mechanism, geometry);
}

Xyz exact_xyz(const Job& job, double x, double y) {
    const Xyz seen = reflectance_xyz(mechanism_at(job, x, y), geometry_at(job, x, y), *job.light);
    return adapt(job.light->adaptation, seen);
}

}  // namespace nacre
