// A default LUT: computed, converted, encoded.
#include <benchmark/benchmark.h>

#include "io/ocio/colour_config.h"
#include "nacre/colour/illuminant.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/lut/snippet.h"
#include "nacre/scene/readers/axis_reader.h"
#include "pipeline/baked_lut.h"

namespace nacre {
namespace {

PlannedLut planned_lut(std::optional<int> wavelengths) {
    LightSettings settings;
    settings.power = *illuminant_by_name("D65");
    settings.wavelengths = wavelengths;
    PlannedLut lut;
    lut.name = "morpho";
    lut.job.material = {"morpho", Palette{{{0, {460, 70, 1}}, {40, {395, 60, 0.7}}}, 0.26}, {}};
    lut.job.light = std::make_shared<const Light>(make_light(settings));
    lut.job.width = 256;
    return lut;
}

ChosenLut choose_at_256(PlannedLut lut, const ColourTransform& transform) {
    lut.request.width = 256;
    lut.request.is_binding = lut.request.has_bound = false;
    return choose_lut(lut, lut_encoding(transform, Gamut::keep));
}

// What a palette swatch bakes: 400 x 400 lobes of one pick, over width and height.
Job swatch_job() {
    Job job = planned_lut({}).job;
    Palette& palette = std::get<Palette>(job.material.mechanism);
    palette.picks.resize(1);
    job.x = parameter_axis(palette, "width_nm", 0.0, 200.0);
    job.y = parameter_axis(palette, "height", 0.0, 1.0);
    job.width = job.height = 400;
    return job;
}
void swatch_400(benchmark::State& state) {
    const Job job = swatch_job();
    for (auto _ : state) benchmark::DoNotOptimize(bake(job));
}

// Deciding on a size for the default bound, and measuring what came out.
void decide_for_bound_of_0_1(benchmark::State& state) {
    PlannedLut lut = planned_lut({});
    const ColourTransform transform = ColourConfig::open({"", "", "bench"}).to_colour_space("lin_rec709", "bench");
    const Encoding encoding = lut_encoding(transform, Gamut::keep);
    for (auto _ : state) benchmark::DoNotOptimize(choose_lut(lut, encoding));
}

void lut_256_exact(benchmark::State& state) {
    const PlannedLut lut = planned_lut({});
    for (auto _ : state) benchmark::DoNotOptimize(bake(lut.job));
}
void lut_256_sampled_at_1nm(benchmark::State& state) {
    const PlannedLut lut = planned_lut(471);
    for (auto _ : state) benchmark::DoNotOptimize(bake(lut.job));
}
void lut_256_to_exr_bytes(benchmark::State& state) {
    const PlannedLut lut = planned_lut({});
    const ColourTransform transform = ColourConfig::open({"", "", "bench"}).to_colour_space("lin_rec709", "bench");
    const ChosenLut chosen = choose_at_256(lut, transform);
    for (auto _ : state) {
        const BakedLut baked = bake_lut(chosen, Plan{}, {"nacre (built in)", ""}, transform);
        benchmark::DoNotOptimize(encode_lut(baked.image, lut.format, baked.header));
    }
}

BENCHMARK(lut_256_exact)->Unit(benchmark::kMicrosecond);
BENCHMARK(lut_256_sampled_at_1nm)->Unit(benchmark::kMicrosecond);
BENCHMARK(lut_256_to_exr_bytes)->Unit(benchmark::kMicrosecond);
BENCHMARK(decide_for_bound_of_0_1)->Unit(benchmark::kMicrosecond);
BENCHMARK(swatch_400)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nacre
