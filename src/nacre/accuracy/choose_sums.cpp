// How many points the sums of a colour have: radii, slices, directions from a base, samples of uneven thicknesses.
//
// All are found in the same way: counts are tried in a rising list until the next two agree with one. In: the probes of
// a job, what was chosen so far, and a tolerance. When each is asked, and why:
//   - Radii and slices come before the nodes of spectra, because they change what a spectrum looks like. Their colours
//     are taken at a fixed number of nodes: what nodes miss of a fringe they miss of all counts alike.
//   - Directions from a base and samples of thicknesses come last, when the effects are known that are left out: they
//     are the most expensive, and each needs the final nodes.
// Only the first band is compared, for thicknesses the second too: the other two are next to grazing, where every face
// is a mirror and nothing of these sums is seen.
//
// The lists rise by a third to a half, as far as memory and time let a LUT be baked. The constants are empirical, set
// by the 300 random scenes of tests/cli/effects_accuracy_test.cpp where nothing else is said.
#include "nacre/accuracy/choose_sums.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <span>

#include "nacre/shade/layered_colour.h"

namespace nacre {
namespace {

constexpr std::array direction_counts{3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
constexpr std::array slice_counts{8, 12, 16, 20, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512};
constexpr std::array radius_counts{4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512};

// The mean over many uneven layers errs by 1 / sqrt(count), so that the next two counts of the list err nearly as much,
// and the difference to them is less than the error. The factor is empirical.
constexpr double error_per_difference_of_slow_means = 1.5;

// A count that a scene gives beyond this is taken without a check, which would need three times as many.
constexpr int beyond_doubt = 512;

using ColoursOfCount = std::function<Colours(int count)>;

double larger_difference(const Colours& one, const Colours& next, const Colours& best, ProbeTally& tally) {
    const double of_one = largest_difference(one, best, tally);
    return std::max(of_one, largest_difference(next, best, tally));
}

// The first of a list that the next two agree with; the last but two, if none does or the effort is spent.
ChosenCount first_that_agrees(std::span<const int> list, double tolerance, double per_sample,
                              const ColoursOfCount& colours_of, ProbeTally& tally) {
    std::vector<Colours> attempts;
    for (std::size_t i = 0;; ++i) {
        attempts.push_back(colours_of(list[i]));
        if (i < 2) continue;
        const double error = larger_difference(attempts[i - 2], attempts[i - 1], attempts[i], tally);
        const bool may_go_on = i + 1 < list.size() && !is_effort_spent(tally, per_sample);
        if (error <= tolerance || !may_go_on) return {list[i - 2], error};
    }
}

// @param requested  compared with twice and three times as many
ChosenCount choose_count(std::span<const int> list, int requested, double tolerance, double per_sample,
                         const ColoursOfCount& colours_of, ProbeTally& tally) {
    if (requested > beyond_doubt) return {requested, 0.0};
    if (requested == 0) return first_that_agrees(list, tolerance, per_sample, colours_of, tally);
    const Colours taken = colours_of(requested);
    const double of_twice = largest_difference(taken, colours_of(2 * requested), tally);
    return {requested, std::max(of_twice, largest_difference(taken, colours_of(3 * requested), tally))};
}

}  // namespace

ChosenCount choose_radii(const Probes& probes, const SpectralSampling& sampling, double tolerance, int requested,
                         ProbeTally& tally) {
    constexpr int enough_nodes = 16;  // a mean over radii is smooth in wavelength
    const Mechanism& mechanism = probes.job.material.mechanism;
    const SpectralSampling probed = with_nodes(sampling, probes.nodes->of(enough_nodes));
    const auto colours_of = [&](int radii) {
        SpectralSampling tried = probed;
        tried.radii = radii;
        return colours_at(probes, 0, tried, {}, tally);
    };
    return choose_count(radius_counts, requested, tolerance, effort_per_sample(mechanism), colours_of, tally);
}

ChosenCount choose_slices(const Probes& probes, const SpectralSampling& sampling, double tolerance, int requested,
                          ProbeTally& tally) {
    // Two per fringe: what is missed of a fringe is missed of all slices alike.
    constexpr double fewest_nodes = 64.0;
    constexpr double most_nodes_of_probe = 4096.0;
    const Job& job = probes.job;
    const double fringes = fringe_count(probes.bands.front().front().simulated, job.light->settings);
    const int nodes = static_cast<int>(std::clamp(2.0 * fringes, fewest_nodes, most_nodes_of_probe));
    const SpectralSampling probed = with_nodes(sampling, probes.nodes->of(nodes));
    const auto colours_of = [&](int slices) {
        SpectralSampling tried = probed;
        tried.slices = slices;
        return colours_at(probes, 0, tried, {}, tally);
    };
    const double per_sample = effort_per_sample(job.material.mechanism, slice_counts.back());
    return choose_count(slice_counts, requested, tolerance, per_sample, colours_of, tally);
}

ChosenCount choose_base_directions(const Probes& probes, const SpectralSampling& sampling, EffectSet without,
                                   double tolerance, int requested, ProbeTally& tally) {
    const auto colours_of = [&](int directions) {
        SpectralSampling tried = sampling;
        tried.base_directions = directions;
        return colours_at(probes, 0, tried, without, tally);
    };
    const double per_sample = effort_per_sample(probes.job.material.mechanism, sampling.slices);
    return choose_count(direction_counts, requested, tolerance, per_sample, colours_of, tally);
}

ChosenCount choose_thickness_samples(const Probes& probes, const SpectralSampling& sampling, EffectSet without,
                                     double tolerance, int requested, ProbeTally& tally) {
    std::map<int, Colours> known;
    const auto colours_of = [&](int samples) {
        Colours& all = known[samples];
        if (!all.empty()) return all;
        SpectralSampling tried = sampling;
        tried.thickness_samples = samples;
        all = colours_at(probes, 0, tried, without, tally);
        const Colours oblique = colours_at(probes, 1, tried, without, tally);
        all.insert(all.end(), oblique.begin(), oblique.end());
        return all;
    };
    const ThicknessSampleCounts counts = thickness_sample_counts(probes.bands.front().front().simulated);
    const double factor = counts.converge_fast ? 1.0 : error_per_difference_of_slow_means;
    const double per_sample = effort_per_sample(probes.job.material.mechanism, sampling.slices);
    const int count = requested > 0
                          ? requested
                          : first_that_agrees(counts.list, tolerance / factor, per_sample, colours_of, tally).count;
    // The error is part of what a file says it reached, and has to be the same for a count that was found and for the
    // same count where it is given: judged at the brightness of these colours alone.
    ProbeTally own;
    const Colours taken = colours_of(count);
    return {count, factor * largest_difference(taken, colours_of(2 * count), own)};
}

}  // namespace nacre
