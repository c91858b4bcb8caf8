// Effects: what each adds to a LUT's bake, and what the plain way to compute it would take, both in turn inside of one
// loop. Read the ratios.
//
//   adds     time with the effect over the time without
//   ratio    the baseline's time over ours
//   dE00     largest CIEDE2000 over the LUT, at the scale of its brightest texel: ours and the baseline's, each against
//   a
//            sum of many more points
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "bench/lut_colours.h"
#include "io/ocio/colour_config.h"
#include "nacre/base/gauss_points.h"
#include "nacre/cost/baselines.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/shade/facets.h"
#include "nacre/shade/layered_colour.h"
#include "nacre/shade/prepared_colour.h"
#include "pipeline/baked_lut.h"

namespace nacre::bench {
namespace {

Mechanism film() {
    return Film{Index(1.0), Index(1.56), 420.0, Index(1.33), 0.0};
}
Mechanism palette() {
    return Palette{{{0, {460, 70, 1}}, {40, {395, 60, 0.7}}}, 0.26};
}

using Way = std::function<Colours()>;

// @param plain  the same without the effect
// @param truth  empty: the baseline's way is exact
void compare(benchmark::State& state, const Job& job, const Job& plain, const Way& baseline, const Way& truth) {
    double ours = 0.0, less = 0.0, theirs = 0.0;
    for (auto _ : state) {
        ours += seconds_of([&] { benchmark::DoNotOptimize(bake(job)); });
        less += seconds_of([&] { benchmark::DoNotOptimize(bake(plain)); });
        theirs += seconds_of([&] { benchmark::DoNotOptimize(baseline()); });
    }
    const Colours true_colours = truth ? truth() : baseline();
    state.counters["us"] = 1e6 * ours / static_cast<double>(state.iterations());
    state.counters["adds"] = ours / less;
    state.counters["ratio"] = theirs / ours;
    state.counters["dE00"] = largest_difference(colours_of(bake(job)), true_colours);
    if (truth) state.counters["baseline_dE00"] = largest_difference(baseline(), true_colours);
}

// ---- Tilt and roughness: facet after facet, each with its own integral over wavelength ----

Colours facet_by_facet(const Job& job, FacetPoints points) {
    Mechanism flat = job.material.mechanism;
    const Relief relief = std::exchange(flat.effects.relief, {});
    PreparedColour prepared = prepare_colour(flat, job.sampling, *job.light);
    Work work;
    Colours colours;
    for (int i = 0; i < texels; ++i) {
        Xyz sum;
        for (const Facet& facet : seen_facets(relief, geometry_of_texel(job, i).incidence, points)) {
            const Xyz seen = colour_at(prepared, Incidence::from_cos(facet.cos_theta), work);
            sum = {sum.x + facet.share * seen.x, sum.y + facet.share * seen.y, sum.z + facet.share * seen.z};
        }
        colours.push_back(adapt(job.light->adaptation, sum));
    }
    return colours;
}
void with_facets(benchmark::State& state, Mechanism mechanism, const Relief& relief) {
    const Mechanism flat = mechanism;
    mechanism.effects.relief = relief;
    const Job job = decided(mechanism);
    compare(
        state, job, decided(flat),
        [&] {
            return facet_by_facet(job, {8, 16, 8});
        },
        [&] {
            return facet_by_facet(job, {24, 48, 64});
        });
}
void tilted_film(benchmark::State& state) {
    with_facets(state, film(), {10.0, 0.0});
}
void tilted_palette(benchmark::State& state) {
    with_facets(state, palette(), {10.0, 0.0});
}
void rough_film(benchmark::State& state) {
    with_facets(state, film(), {0.0, 0.4});
}
void rough_palette(benchmark::State& state) {
    with_facets(state, palette(), {0.0, 0.4});
}

// A LUT of angle and roughness, beside the same LUT over the tilt, whose means are series.
void rough_plane(benchmark::State& state) {
    Job job = decided(film());
    job.width = 128;
    job.height = 64;
    job.y = parameter_axis(job.material.mechanism, "roughness", 0.0, 1.0);
    Job over_tilt = job;
    over_tilt.y = parameter_axis(job.material.mechanism, "tilt_deg", 0.0, 30.0);
    double ours = 0.0, theirs = 0.0;
    for (auto _ : state) {
        ours += seconds_of([&] { benchmark::DoNotOptimize(bake(job)); });
        theirs += seconds_of([&] { benchmark::DoNotOptimize(bake(over_tilt)); });
    }
    state.counters["ms"] = 1e3 * ours / static_cast<double>(state.iterations());
    state.counters["ratio"] = theirs / ours;
}

// ---- The rest of a film's ----

// Layers, at every nanometre.
Colours at_every_nm(Job job, int hemisphere) {
    job.sampling.nodes.fill(std::make_shared<const SpectralNodes>(sum_nodes(*job.light, 1)));
    job.sampling.base_directions = hemisphere;
    return colours_of(bake(job));
}
void film_on_a_base(benchmark::State& state) {
    Mechanism mechanism = film();
    mechanism.effects.base = GreyBase{0.3};
    const Job job = decided(mechanism);
    Job better = job;
    better.sampling.base_directions = 64;
    better.sampling.nodes.fill(std::make_shared<const SpectralNodes>(make_spectral_nodes(job.light->weights, 2048)));
    compare(
        state, job, decided(film()), [&] { return at_every_nm(job, 16); }, [&] { return colours_of(bake(better)); });
    state.counters["directions"] = job.sampling.base_directions;
}

// Films whose thicknesses are as many points of a rule, or as many draws.
Colours mean_film(const Job& job, const std::vector<GaussPoint>& deviations) {
    Film one = std::get<Film>(job.material.mechanism);
    const double spread_nm = std::exchange(one.thickness_spread_nm, 0.0);
    const double mean_nm = one.thickness_nm;
    SpectralSampling sampling = job.sampling;
    sampling.thickness_samples = 1;
    Colours mean(texels);
    for (const GaussPoint& deviation : deviations) {
        one.thickness_nm = std::max(0.0, mean_nm + spread_nm * deviation.at);
        LayeredColour colour(one, sampling);
        for (int i = 0; i < texels; ++i) {
            const Xyz seen = colour.at(geometry_of_texel(job, i).incidence);
            Xyz& sum = mean[static_cast<std::size_t>(i)];
            sum = {sum.x + deviation.weight * seen.x, sum.y + deviation.weight * seen.y,
                   sum.z + deviation.weight * seen.z};
        }
    }
    for (Xyz& sum : mean) sum = adapt(job.light->adaptation, sum);
    return mean;
}
std::vector<GaussPoint> draws(int count) {
    std::mt19937 random(1);
    std::normal_distribution<double> drawn;
    std::vector<GaussPoint> points;
    for (int i = 0; i < count; ++i) points.push_back({drawn(random), 1.0 / count});
    return points;
}
void film_of_uneven_thickness(benchmark::State& state) {
    Mechanism mechanism = film();
    std::get<Film>(mechanism).thickness_spread_nm = 30.0;
    const Job job = decided(mechanism);
    const Way drawn = [&] { return mean_film(job, draws(job.sampling.thickness_samples)); };
    const Way truth = [&] { return mean_film(job, normal_points(256)); };
    compare(state, job, decided(film()), drawn, truth);
    state.counters["films"] = job.sampling.thickness_samples;
    // What a rule for one variable does with few of them.
    state.counters["8_points_dE00"] = largest_difference(mean_film(job, normal_points(8)), truth());
}

Mechanism stack_of_20(Polarisation polarisation) {
    Stack stack{Index(1.0), {}, Index(1.52), 0.0};
    for (int i = 0; i < 20; ++i) {
        Layer layer;
        layer.index = i % 2 == 0 ? Index(1.7) : Index(1.46);
        layer.thickness_nm = 60.0 + 4.0 * i;
        stack.layers.push_back(layer);
    }
    Mechanism mechanism = stack;
    mechanism.effects.polarisation = polarisation;
    return mechanism;
}
// The baseline: spectra of both, of which one is summed.
void stack_in_s_light(benchmark::State& state) {
    const Mechanism mechanism = stack_of_20(Polarisation::s);
    Job job = decided(mechanism);
    job.sampling.nodes.fill(job.sampling.nodes.front());  // at all angles alike
    const SpectralNodes& nodes = *job.sampling.nodes.front();
    const LayerSystem system = even_system(mechanism);
    const auto both = [&] {
        const MultilayerSolver solver(system, nodes.wavelength_nm);
        std::vector<Response> responses(nodes.wavelength_nm.size());
        Colours colours;
        for (int i = 0; i < texels; ++i) {
            solver.responses(geometry_of_texel(job, i).incidence, responses);
            Xyz sum;
            for (std::size_t k = 0; k < responses.size(); ++k) {
                const double r = responses[k].reflectance_s;
                sum = {sum.x + r * nodes.x[k], sum.y + r * nodes.y[k], sum.z + r * nodes.z[k]};
            }
            colours.push_back(adapt(job.light->adaptation, sum));
        }
        return colours;
    };
    Job mean = job;
    mean.material.mechanism = stack_of_20(Polarisation::mean);
    compare(state, job, mean, both, {});
}

// ---- The planner: a film with effects that hardly anybody sees, and one with effects that all see ----

void decide_and_bake(benchmark::State& state, double strength) {
    Mechanism mechanism = film();
    std::get<Film>(mechanism).thickness_spread_nm = 20.0 * strength;
    mechanism.effects.relief.tilt_deg = 10.0 * strength;
    mechanism.effects.base = GreyBase{0.3 * strength * strength};
    PlannedLut lut;
    lut.name = "film";
    lut.job.material = {"film", mechanism, {}};
    lut.job.light = d65();
    PlannedLut all = lut;
    all.request.may_drop_effects = false;
    const ColourTransform transform = ColourConfig::open({"", "", "bench"}).to_colour_space("lin_rec709", "bench");
    const Encoding encoding = lut_encoding(transform, Gamut::keep);
    double ours = 0.0, theirs = 0.0, baking = 0.0, baking_all = 0.0;
    for (auto _ : state) {
        ChosenLut chosen, chosen_all;
        ours += seconds_of([&] { chosen = choose_lut(lut, encoding); });
        baking += seconds_of([&] { benchmark::DoNotOptimize(bake(chosen.lut.job)); });
        theirs += seconds_of([&] { chosen_all = choose_lut(all, encoding); });
        baking_all += seconds_of([&] { benchmark::DoNotOptimize(bake(chosen_all.lut.job)); });
        state.counters["left_out"] = chosen.lut.job.without.size();
        state.counters["effects_dE00"] = chosen.predicted.effects;
    }
    state.counters["decide_ms"] = 1e3 * ours / static_cast<double>(state.iterations());
    state.counters["decide_ratio"] = theirs / ours;  // the baseline simulates whatever the scene names
    state.counters["bake_ratio"] = baking_all / baking;
}

BENCHMARK(tilted_film)->Unit(benchmark::kMillisecond);
BENCHMARK(tilted_palette)->Unit(benchmark::kMillisecond);
BENCHMARK(rough_film)->Unit(benchmark::kMillisecond);
BENCHMARK(rough_palette)->Unit(benchmark::kMillisecond);
BENCHMARK(rough_plane)->Unit(benchmark::kMillisecond);
BENCHMARK(film_on_a_base)->Unit(benchmark::kMillisecond);
BENCHMARK(film_of_uneven_thickness)->Unit(benchmark::kMillisecond);
BENCHMARK(stack_in_s_light)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decide_and_bake, weak, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decide_and_bake, strong, 1.0)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nacre::bench
