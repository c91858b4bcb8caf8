// How a material's colours are sampled, and which of its effects are simulated.
//
// In: a job (a material, a light, axes), what each part of the sampling may err by, and the numbers that the scene
// requests. Colours at probes all over the axes (probes.h) are compared in this order:
//   1. Radii of scattering spheres and slices of crystals, because they change what a spectrum looks like.
//   2. The nodes of spectra (choose_nodes.cpp).
//   3. Effects: each is left out for once, with these nodes (choose_effects.cpp).
//   4. Directions from a base and samples of uneven thicknesses (choose_sums.cpp), of those effects that are left.
//   5. Where no axis but tilt or roughness moves, the colours of a facet as a curve, which all LUTs of the search can
//   share.
// Each step returns its part; none changes what an earlier one chose. The tally of work and of the brightest colour
// goes through all of them: it only grows, a step that finds the effort spent ends with what it has, and all
// differences are judged at the brightness of the colours that were seen before.
#include "nacre/accuracy/choose_sampling.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "nacre/accuracy/choose_nodes.h"
#include "nacre/accuracy/choose_sums.h"
#include "nacre/accuracy/facet_contribution.h"
#include "nacre/accuracy/mechanism_traits.h"
#include "nacre/accuracy/probes.h"

namespace nacre {
namespace {

bool only_relief_moves(const Job& job) {
    const auto is_else = [](const Axis& axis) {
        return !axis.is_angle() && axis.parameter.name != "tilt_deg" && axis.parameter.name != "roughness";
    };
    return !is_else(job.x) && !(job.y && is_else(*job.y));
}

// Steps 1 and 2.
void choose_spectra(const Probes& probes, const SamplingTolerance& tolerance, const SamplingRequest& request,
                    bool has_size_spread, ChosenSampling& chosen, ProbeTally& tally) {
    const Mechanism& mechanism = probes.job.material.mechanism;
    SpectralSampling& sampling = chosen.sampling;
    if (has_size_spread) {
        const ChosenCount radii = choose_radii(probes, sampling, tolerance.quadrature, request.counts.radii, tally);
        sampling.radii = std::max(radii.count, request.least.radii);
        chosen.quadrature_error += radii.error;
    }
    if (traits_of(mechanism).has_slices) {
        const ChosenCount slices = choose_slices(probes, sampling, tolerance.quadrature, request.counts.slices, tally);
        sampling.slices = std::max(slices.count, request.least.slices);
        chosen.quadrature_error += slices.error;
    }
    if (!samples_spectra(mechanism)) return;
    ChosenNodes nodes =
        choose_nodes(probes, sampling, tolerance.nodes, request.counts.nodes, request.least.nodes, tally);
    sampling.nodes = std::move(nodes.nodes);
    sampling.incoherent_layers = std::move(nodes.incoherent_layers);
    chosen.error = nodes.error;
}

// Steps 4 and 5. @param left  effects that are simulated
void choose_means(const Probes& probes, const SamplingTolerance& tolerance, const SamplingRequest& request,
                  const EffectSet& left, ChosenSampling& chosen, ProbeTally& tally) {
    const Job& job = probes.job;
    SpectralSampling& sampling = chosen.sampling;
    if (!left.has(Effect::size_spread)) sampling.radii = 1;
    if (left.has(Effect::base) && is_layered(job.material.mechanism)) {
        const ChosenCount directions = choose_base_directions(probes, sampling, chosen.without, tolerance.quadrature,
                                                              request.counts.base_directions, tally);
        sampling.base_directions = std::max(directions.count, request.least.base_directions);
        chosen.quadrature_error += directions.error;
    }
    if (left.has(Effect::thickness_spread)) {
        const ChosenCount samples = choose_thickness_samples(probes, sampling, chosen.without, tolerance.spread,
                                                             request.counts.thickness_samples, tally);
        sampling.thickness_samples = samples.count;
        chosen.spread_error = samples.error;
    }
    if (left.has_any(facet_effects) && only_relief_moves(job)) {
        const Probe& probe = probes.bands.front().front();
        Mechanism facet = probe.simulated;
        const Relief relief = std::exchange(facet.effects.relief, {});
        FacetColours facets(facet_colours(probes, std::move(facet), sampling, chosen.without, tally));
        // For a mean it expands the curve once, which all LUTs of the search then share.
        if (relief.tilt_deg > 0.0)
            facets.mean(relief, probe.geometries.front().incidence, work_of(tally.work.effects, Effect::tilt).points);
        sampling.facets = std::make_shared<const FacetColours>(std::move(facets));
    }
}

}  // namespace

ChosenSampling choose_sampling(const Job& job, const SamplingTolerance& tolerance, const SamplingRequest& request,
                               const std::function<void()>& after_step) {
    const EffectSet named = effects_in(job);
    ChosenSampling chosen;
    chosen.without = job.without;
    chosen.sampling.kept = job.sampling.kept;
    if (!samples_spectra(job.material.mechanism) && named.is_empty()) return chosen;

    const Probes probes = make_probes(job, after_step, request.nodes);
    ProbeTally tally;
    const bool has_size_spread = named.has(Effect::size_spread) && !job.without.has(Effect::size_spread);
    choose_spectra(probes, tolerance, request, has_size_spread, chosen, tally);

    if (request.judges_effects) {
        ChosenEffects effects = choose_effects(probes, chosen.sampling, tolerance.effects, tally);
        chosen.effects = std::move(effects.effects);
        chosen.without = effects.without;
        chosen.effects_error = effects.error;
    }

    choose_means(probes, tolerance, request, named.minus(chosen.without), chosen, tally);
    chosen.work = tally.work;
    return chosen;
}

Job integrated_job(Job job, const SamplingTolerance& tolerance) {
    if (!job.light->settings.wavelengths) return job;
    job.light = without_wavelengths(job.light);
    SamplingCounts counts = job.sampling.counts();
    counts.nodes = {};
    job.sampling = choose_sampling(job, tolerance, {.counts = counts, .judges_effects = false}).sampling;
    return job;
}

SpectralSampling default_sampling(const Job& job) {
    return choose_sampling(job, {}, {.judges_effects = false}).sampling;
}

}  // namespace nacre
