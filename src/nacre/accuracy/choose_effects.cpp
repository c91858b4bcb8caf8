// Which effects of a material are simulated.
//
// In: the probes of a job, a sampling whose nodes, slices and radii are chosen, and what all effects that are left out
// may change together. Every effect that the scene names has an even share of that. Effects are asked in the order of
// the enumeration:
//   - What the scene does without is put back alone, to find what its absence changes. It stays away.
//   - Any other is left out alone, everything else as it is. If the colours change by less than the share, it is left
//     out for good. Contributions add up, so that all of them together keep the tolerance.
// What was left out so far is missing from the materials with which the scene's own `without` and facets are compared;
// the other comparisons hold against the material with all of its effects. A few samples of uneven thicknesses stand
// for their mean here.
//
// The constants are empirical: with them none of the 300 random scenes of tests/cli/effects_accuracy_test.cpp changes
// by more than the shares of what is left out.
#include "nacre/accuracy/choose_effects.h"

#include <algorithm>
#include <utility>

#include "nacre/accuracy/choose_nodes.h"
#include "nacre/accuracy/facet_contribution.h"
#include "nacre/shade/facets.h"
#include "nacre/shade/kinks.h"
#include "nacre/shade/prepared_colour.h"

namespace nacre {
namespace {

// What an effect changes between the probes may be half as much again (empirical).
constexpr double between_probes = 1.5;
// Enough to see whether a spread counts at all (empirical), as few_thickness_samples are.
constexpr int radii_of_contribution = 32;

using ColoursOfBands = std::array<Colours, band_least_cos_theta.size()>;

// Colours with all effects, which most contributions are compared with.
ColoursOfBands whole_colours(const Probes& probes, const SpectralSampling& sampling, ProbeTally& tally) {
    ColoursOfBands colours;
    for (std::size_t band = 0; band < probes.bands.size(); ++band)
        colours[band] = colours_at(probes, band, sampling, {}, tally);
    return colours;
}

double contribution_of(Effect effect, const Probes& probes, SpectralSampling sampling, const ColoursOfBands& whole,
                       ProbeTally& tally) {
    if (effect == Effect::incoherent_layers) sampling.incoherent_layers.clear();  // they may be nodes that are gone
    EffectSet without;
    without.insert(effect);
    double largest = 0.0;
    for (std::size_t band = 0; band < probes.bands.size(); ++band) {
        const Colours less = colours_at(probes, band, sampling, without, tally);
        largest = std::max(largest, largest_difference(less, whole[band], tally));
    }
    return largest;
}

// With facets.
void append_colours(Mechanism mechanism, const Probe& probe, const Probes& probes, const SpectralSampling& sampling,
                    Colours& out, ProbeTally& tally) {
    const Light& light = *probes.job.light;
    const Relief relief = std::exchange(mechanism.effects.relief, {});
    PreparedColour prepared = prepare_colour(mechanism, sampling, light);
    const auto flat = [&](const Geometry& geometry) {
        return adapt(light.adaptation, colour_at(prepared, geometry, tally.work));
    };
    FacetColours facets;
    if (!relief.is_plane()) facets = FacetColours(facet_curve(flat, kinks_deg(mechanism), probes.after_step));
    for (const Geometry& geometry : probe.geometries) {
        std::uint64_t& points = work_of(tally.work.effects, facet_effect(relief)).points;
        out.push_back(relief.is_plane() ? flat(geometry) : facets.mean(relief, geometry.incidence, points));
        if (probes.after_step) probes.after_step();
    }
}

// Of what the scene does without although its material has it. @param rest  everything else that is left out
double contribution_of_given(Effect effect, const EffectSet& rest, const Probes& probes,
                             const SpectralSampling& sampling, ProbeTally& tally) {
    SpectralSampling sampling_with = sampling;
    if (effect == Effect::thickness_spread) sampling_with.thickness_samples = few_thickness_samples;
    if (effect == Effect::size_spread) sampling_with.radii = radii_of_contribution;
    double largest = 0.0;
    for (const std::vector<Probe>& band : probes.bands) {
        Colours without;
        Colours with;
        for (const Probe& probe : band) {
            Mechanism mechanism = probe.named;
            remove(rest, mechanism, probes.job.light->settings.first_nm);
            append_colours(probe.simulated, probe, probes, sampling, without, tally);
            append_colours(std::move(mechanism), probe, probes, sampling_with, with, tally);
        }
        largest = std::max(largest, largest_difference(without, with, tally));
    }
    return largest;
}

EffectSet without_one(EffectSet effects, Effect effect) {
    effects.erase(effect);
    return effects;
}

}  // namespace

ChosenEffects choose_effects(const Probes& probes, const SpectralSampling& sampling, double tolerance,
                             ProbeTally& tally) {
    const EffectSet named = effects_in(probes.job);
    const EffectSet given = probes.job.without;
    const double share = named.is_empty() ? 0.0 : tolerance / named.size();
    SpectralSampling few_samples = sampling;
    few_samples.thickness_samples = few_thickness_samples;
    std::optional<ColoursOfBands> whole;  // computed when the first effect asks for it
    const auto contribution = [&](Effect effect, const EffectSet& without) {
        if (facet_effects.has(effect)) return contribution_of_facets(probes, sampling, without, tally);
        if (!whole) whole = whole_colours(probes, few_samples, tally);
        return contribution_of(effect, probes, few_samples, *whole, tally);
    };
    ChosenEffects chosen{{}, given, 0.0};
    for (const EffectRow& row : effect_rows()) {
        const Effect effect = row.effect;
        if (!named.has(effect)) continue;
        EffectChoice choice{effect, !given.has(effect), given.has(effect), false, 0.0, share};
        choice.is_measured = choice.is_given || share > 0.0;
        if (choice.is_given) {
            const EffectSet rest = without_one(chosen.without, effect);
            choice.contribution = between_probes * contribution_of_given(effect, rest, probes, sampling, tally);
        } else if (choice.is_measured) {
            choice.contribution = between_probes * contribution(effect, chosen.without);
            choice.is_simulated = choice.contribution > share;
        }
        if (!choice.is_simulated) {
            chosen.without.insert(effect);
            chosen.error += choice.contribution;
        }
        chosen.effects.push_back(choice);
    }
    return chosen;
}

}  // namespace nacre
