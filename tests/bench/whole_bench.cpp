// What the LUTs of the scenes that come with nacre cost as a whole, each at its own bound: deciding, computing and
// measuring beside computing alone. Those over one axis; of each scene the LUT that is furthest from what is allowed.
// Read `ratio` and `of_allowed`.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/whole.h"
#include "io/ocio/ocio_spaces.h"
#include "pipeline/loaded_scene.h"

namespace nacre {
namespace {

void whole_scene(benchmark::State& state, const std::string& path) {
    SceneRequest request;
    request.open_colours = open_ocio_spaces;
    request.want_swatches = false;
    const std::vector<LoadedScene> scenes = load_scenes({path}, request);
    for (auto _ : state) {
        bench::WholeSeconds worst;
        for (const LoadedScene& scene : scenes) {
            for (const PlannedLut& lut : scene.plan.luts) {
                if (lut.job.y) continue;
                const Encoding encoding = lut_encoding(scene.space_of(lut.colour), lut.colour.gamut);
                const bench::WholeSeconds seconds = bench::median_whole_bake(lut, encoding);
                if (seconds.of_allowed() <= worst.of_allowed()) continue;
                worst = seconds;
                state.SetLabel(lut.name);
            }
        }
        if (worst.computing > 0.0) {
            bench::report(state, worst);
        } else {
            state.SetLabel("has no LUT over one axis");
        }
    }
}

// Scenes are read when their turn comes: searches for picks take seconds.
const bool is_registered = [] {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(NACRE_SCENES_DIR)) {
        if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
    }
    std::sort(paths.begin(), paths.end());
    for (const std::string& path : paths) {
        const std::string name = "whole/" + std::filesystem::path(path).stem().string();
        benchmark::RegisterBenchmark(name.c_str(), [path](benchmark::State& state) { whole_scene(state, path); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1);
    }
    return true;
}();

}  // namespace
}  // namespace nacre
