#include "nacre/accuracy/probes.h"

#include <algorithm>
#include <utility>

#include "nacre/colour/difference.h"
#include "nacre/shade/prepared_colour.h"

namespace nacre {
namespace {

constexpr std::size_t band_count = band_least_cos_theta.size();

// Square roots of the cosines at which each band is probed: about even on the default axis (empirical).
constexpr std::array<std::array<double, 6>, band_count> probe_sqrt_cos{{{1.0, 0.92, 0.82, 0.72, 0.63, 0.56},
                                                                        {0.53, 0.47, 0.4, 0.34, 0.28, 0.23},
                                                                        {0.21, 0.17, 0.14, 0.11, 0.09, 0.07},
                                                                        {0.06, 0.045, 0.03, 0.02, 0.01, 0.005}}};
std::vector<Geometry> incidences_of(std::size_t band) {
    std::vector<Geometry> geometries;
    for (const double s : probe_sqrt_cos[band]) geometries.emplace_back(Incidence::from_sqrt_cos(s));
    return geometries;
}

// Other quantities know the first band only; so does a fixed geometry, but for an angle of incidence in another one.
// Facets are seen at all angles, wherever the surface is seen from.
std::vector<Geometry> geometries_of(const Job& job, std::size_t band) {
    const Quantity quantity = quantity_of(job.material.mechanism);
    const bool has_facets = effects_in(job).minus(job.without).has_any(facet_effects);
    if (!job.has_angle() && !has_facets) {
        const bool is_its_band = quantity == Quantity::incidence && band == band_of(job.fixed.incidence);
        return band == 0 || is_its_band ? std::vector<Geometry>{job.fixed} : std::vector<Geometry>{};
    }
    if (quantity == Quantity::incidence) return incidences_of(band);
    if (band > 0) return {};
    constexpr int count = 17;
    const AxisKind& kind = default_axis_kind(quantity);
    std::vector<Geometry> geometries;
    for (int i = 0; i < count; ++i) geometries.push_back(kind.geometry(coordinate_of_texel(i, count)));
    return geometries;
}

std::vector<Probe> probes_of(const Job& job, std::size_t band) {
    const std::vector<Geometry> geometries = geometries_of(job, band);
    if (geometries.empty()) return {};
    const bool x_moves = !job.x.is_angle();
    const bool y_moves = job.y && !job.y->is_angle();
    const int along = x_moves ? (y_moves ? 5 : 9) : 1;
    const int across = y_moves ? (x_moves ? 5 : 9) : 1;
    std::vector<Probe> probes;
    for (int i = 0; i < along * across; ++i) {
        const double x = coordinate_of_texel(i % along, along);
        const double y = coordinate_of_texel(i / along, across);
        probes.push_back({simulated_at(job, x, y), mechanism_at(job, x, y), geometries});
    }
    return probes;
}

}  // namespace

Probes make_probes(const Job& job, std::function<void()> after_step, std::shared_ptr<NodeMaker> nodes) {
    if (nodes == nullptr) nodes = std::make_shared<NodeMaker>(job.light->weights);
    Probes probes{job, {}, std::move(after_step), std::move(nodes)};
    for (std::size_t band = 0; band < band_count; ++band) probes.bands[band] = probes_of(job, band);
    return probes;
}

bool is_effort_spent(const ProbeTally& tally, double per_sample) {
    return per_sample * static_cast<double>(tally.work.samples) >= most_probe_effort;
}

Colours colours_at(const Probes& probes, std::size_t band, const SpectralSampling& sampling, EffectSet without,
                   ProbeTally& tally) {
    const Light& light = *probes.job.light;
    without.insert(facet_effects);
    Colours colours;
    for (const Probe& probe : probes.bands[band]) {
        Mechanism mechanism = probe.simulated;
        remove(without, mechanism, light.settings.first_nm);
        PreparedColour prepared = prepare_colour(mechanism, sampling, light);
        for (const Geometry& geometry : probe.geometries) {
            colours.push_back(adapt(light.adaptation, colour_at(prepared, geometry, tally.work)));
            if (probes.after_step) probes.after_step();
        }
    }
    return colours;
}

double largest_difference(const Colours& one, const Colours& other, ProbeTally& tally) {
    for (const Xyz& colour : other) tally.brightest = std::max(tally.brightest, colour.y);
    const double scale = display_scale(tally.brightest);
    double largest = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) largest = std::max(largest, difference_at(one[i], other[i], scale));
    return largest;
}

SpectralSampling with_nodes(SpectralSampling sampling, const std::shared_ptr<const SpectralNodes>& nodes) {
    sampling.nodes.fill(nodes);
    return sampling;
}

}  // namespace nacre
