// How many wavelengths a spectrum is sampled at.
//
// In: the probes of a job, a sampling whose slices and radii are chosen (fewer of them would change what a spectrum
// looks like), and a tolerance. Then, in this order:
//   1. A scene that requests its `wavelengths` gets these, and every fringe as they sample it.
//   2. A layer whose fringes are fine beside everything else in the spectrum becomes incoherent, if thick_layers() sees
//      that this changes nothing that counts: it would need thousands of nodes.
//   3. Band after band, from normal incidence to grazing, nodes start at two per fringe (Nyquist) and grow by a quarter
//      to a third until the next two counts agree with a count. A band never has fewer than the one before it, because
//      fringes become sharper towards grazing. The first band comes first for another reason too: its colours say how
//      bright the material is, and all differences are judged at that brightness.
//   4. Counts that the scene asks for take their place; their error is the difference to those that were found.
//
// Uneven layers are represented by a few of their samples: the mean over more of them is smoother still.
//
// The constants were set by the 200 random scenes of tests/cli/layered_accuracy_test.cpp and the 300 of
// tests/cli/effects_accuracy_test.cpp, which compare whole LUTs with dense sums; they are empirical where nothing else
// is said.
#include "nacre/accuracy/choose_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/accuracy/thick_layers.h"
#include "nacre/shade/layered_colour.h"

namespace nacre {
namespace {

// Empirical: no spectrum that a scene can name was sampled well by fewer.
constexpr int fewest_nodes = 16;

// The next count that is worth trying: steps of a third or a quarter.
int next_count(int count) {
    int power = fewest_nodes;
    while (2 * power <= count) power *= 2;
    for (const int quarters : {5, 6, 8}) {
        if (power * quarters / 4 > count) return power * quarters / 4;
    }
    return 2 * power;
}

// In the third band, fringes that are too sharp for any grid reflect everything but a trace: beyond 64 nodes per fringe
// nothing is gained (empirical). In the last there are so few texels that nodes do not cost.
int most_nodes_of(std::size_t band, double fringes) {
    if (band != 2) return most_nodes;
    constexpr double per_fringe = 64.0;
    constexpr int at_least = 16384;
    return std::min(most_nodes, std::max(at_least, static_cast<int>(per_fringe * fringes)));
}

double most_fringes_in(const Probes& probes, std::size_t band, const SpectralSampling& sampling) {
    double fringes = 0.0;
    for (const Probe& probe : probes.bands[band]) {
        if (!is_layered(probe.simulated)) break;
        const LayerSystem system = even_system(probe.simulated, sampling.incoherent_layers, sampling.slices);
        fringes = std::max(fringes, fringe_count(system, probes.job.light->settings));
    }
    return fringes;
}

bool is_uneven_everywhere(const Probes& probes) {
    const std::vector<Probe>& band = probes.bands.front();
    return std::all_of(band.begin(), band.end(), [](const Probe& probe) { return is_irregular(probe.simulated); });
}

struct NodesOfBand {
    std::shared_ptr<const SpectralNodes> nodes;
    double error = 0.0;
};

// The first count that the next two agree with; the last but two, if the effort is spent or there are no more.
NodesOfBand choose_band(const Probes& probes, std::size_t band, const SpectralSampling& sampling, int fewest,
                        double tolerance, ProbeTally& tally) {
    struct Attempt {
        std::shared_ptr<const SpectralNodes> nodes;
        Colours colours;
    };
    const double share = seen_share_of_band(probes, band);
    const double fringes = most_fringes_in(probes, band, sampling);
    const double per_sample = effort_per_sample(probes.job.material.mechanism, sampling.slices);
    int count = fewest;
    while (count < 2.0 * fringes && count < most_nodes) count = next_count(count);
    std::vector<Attempt> attempts;
    for (;; count = next_count(count)) {
        const auto nodes = probes.nodes->of(count);
        attempts.push_back({nodes, colours_at(probes, band, with_nodes(sampling, nodes), {}, tally)});
        if (attempts.size() < 3) continue;
        const Attempt& candidate = attempts[attempts.size() - 3];
        const Attempt& next = attempts[attempts.size() - 2];
        const Colours& best = attempts.back().colours;
        const double error = share * std::max(largest_difference(candidate.colours, best, tally),
                                              largest_difference(next.colours, best, tally));
        const bool may_go_on = count < most_nodes_of(band, fringes) && !is_effort_spent(tally, per_sample);
        if (error <= tolerance || !may_go_on) return {candidate.nodes, error};
    }
}

ChosenNodes nodes_of_grid(const Light& light) {
    ChosenNodes chosen;
    chosen.nodes.fill(std::make_shared<const SpectralNodes>(make_spectral_nodes(light.grid_weights, light.grid)));
    return chosen;
}

ChosenNodes requested_nodes(const Probes& probes, const ChosenNodes& good, const SpectralSampling& sampling,
                            const NodeCounts& requested, ProbeTally& tally) {
    ChosenNodes taken = good;
    taken.error = 0.0;
    for (std::size_t band = 0; band < probes.bands.size(); ++band) {
        const Colours meant = colours_at(probes, band, with_nodes(sampling, good.nodes[band]), {}, tally);
        taken.nodes[band] = probes.nodes->of(requested[band]);
        const Colours seen = colours_at(probes, band, with_nodes(sampling, taken.nodes[band]), {}, tally);
        taken.error = std::max(taken.error, seen_share_of_band(probes, band) * largest_difference(seen, meant, tally));
    }
    return taken;
}

}  // namespace

double seen_share_of_band(const Probes& probes, std::size_t band) {
    constexpr double least = 1e-3;  // so that a band is never ignored
    double least_slope = std::numeric_limits<double>::infinity();
    for (const Probe& probe : probes.bands[band]) {
        const Relief& relief = probe.simulated.effects.relief;
        const double of_tilt = std::sin(relief.tilt_deg * std::numbers::pi / 180.0);
        least_slope = std::min(least_slope, std::max(of_tilt, relief.roughness * relief.roughness));
    }
    if (band == 0 || !(least_slope > 0.0)) return 1.0;
    const double share = band_least_cos_theta[band - 1] / least_slope;
    return std::clamp(share * share, least, 1.0);
}

ChosenNodes choose_nodes(const Probes& probes, SpectralSampling sampling, double tolerance, const NodeCounts& requested,
                         const NodeCounts& fewest, ProbeTally& tally) {
    const Job& job = probes.job;
    if (job.light->settings.wavelengths) return nodes_of_grid(*job.light);
    ChosenNodes chosen;
    if (is_layered(job.material.mechanism)) chosen.incoherent_layers = thick_layers(job, tolerance);
    sampling.incoherent_layers = chosen.incoherent_layers;
    if (is_uneven_everywhere(probes)) sampling.thickness_samples = few_thickness_samples;
    int least = fewest_nodes;
    for (std::size_t band = 0; band < probes.bands.size(); ++band) {
        if (probes.bands[band].empty()) {
            chosen.nodes[band] = chosen.nodes.front();
            continue;
        }
        least = std::max(least, fewest[band]);
        NodesOfBand found = choose_band(probes, band, sampling, least, tolerances_of_band[band] * tolerance, tally);
        least = found.nodes->count;
        chosen.error = std::max(chosen.error, found.error);
        chosen.nodes[band] = std::move(found.nodes);
    }
    return requested.front() > 0 ? requested_nodes(probes, chosen, sampling, requested, tally) : chosen;
}

}  // namespace nacre
