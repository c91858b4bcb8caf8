// A default LUT: computed, converted, encoded.
#include <benchmark/benchmark.h>

#include "io/baked_lut.h"
#include "nacre/bake/bake.h"
#include "nacre/bake/snippet.h"
#include "nacre/colour/illuminant.h"

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
    return lut;
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
    for (auto _ : state) {
        const BakedLut baked = bake_lut(lut, {}, {"nacre (built in)", ""}, transform);
        benchmark::DoNotOptimize(encode_lut(baked.image, lut.format, baked.header));
    }
}

BENCHMARK(lut_256_exact)->Unit(benchmark::kMicrosecond);
BENCHMARK(lut_256_sampled_at_1nm)->Unit(benchmark::kMicrosecond);
BENCHMARK(lut_256_to_exr_bytes)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace nacre
