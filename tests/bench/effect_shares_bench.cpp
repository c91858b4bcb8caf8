// What `nacre plan` says an effect costs, beside what it costs: the texels of every LUT of the shipped scenes, baked
// with each effect really off and on, each with a sampling of its own and of one size.
//
//   plan   the share of the time that the plan says
//   true   the share that was measured; below 3 % it may be 3 percentage points off, else by a factor of 1.5
//   off    how many effects are further off than that
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "io/ocio/ocio_spaces.h"
#include "pipeline/baked_lut.h"
#include "pipeline/decide.h"
#include "pipeline/effect_shares.h"
#include "pipeline/thread_clock.h"

namespace nacre::bench {
namespace {

constexpr double seconds_per_job = 0.2;
constexpr int most_bakes = 50;
constexpr double most_factor = 1.5;
constexpr double little = 0.03;

struct Both {
    double on = 0.0;
    double off = 0.0;
};

double seconds_of_bake_of(const Job& job) {
    const double begin = thread_seconds();
    benchmark::DoNotOptimize(bake(job));
    return thread_seconds() - begin;
}

// In turn, so that what else the machine does meets both. The best of all runs.
Both seconds_of_bakes(const Job& on, const Job& off) {
    Both best{1e9, 1e9};
    double all = 0.0;
    for (int run = 0; run < most_bakes && (run < 3 || all < seconds_per_job); ++run) {
        const double with = seconds_of_bake_of(on);
        const double without = seconds_of_bake_of(off);
        best = {std::min(best.on, with), std::min(best.off, without)};
        all += with + without;
    }
    return best;
}

// The same LUT without some effects, sampled as is right for one whose size is free; facets' colours are left to the
// bake.
Job job_without(const DecidedLut& decided, const EffectSet& without) {
    PlannedLut lut = *decided.asked;
    const Job& job = decided.lut.lut.job;
    lut.request.without = without;
    lut.request.may_drop_effects = false;
    Job chosen = choose_lut(lut, lut_encoding(decided.space(), lut.colour.gamut)).lut.job;
    chosen.width = job.width;
    chosen.height = job.height;
    chosen.sampling.facets.reset();
    return chosen;
}

bool is_off(double said, double truth) {
    const double more = std::max(said, truth);
    const double less = std::min(said, truth);
    return more - less > little && more > most_factor * less;
}

int compare_lut(const DecidedLut& decided) {
    int off = 0;
    Job chosen = decided.lut.lut.job;
    chosen.sampling.facets.reset();
    for (const EffectShare& share : effect_shares(decided, {})) {
        EffectSet other = chosen.without;
        share.choice.is_simulated ? other.insert(share.choice.effect) : other.erase(share.choice.effect);
        const Job changed = job_without(decided, other);
        const Both seconds =
            share.choice.is_simulated ? seconds_of_bakes(chosen, changed) : seconds_of_bakes(changed, chosen);
        const double truth = std::max(0.0, 1.0 - seconds.off / seconds.on);
        const bool is_wrong = is_off(share.time_share, truth);
        off += is_wrong ? 1 : 0;
        std::printf("%-24s %-18s %-10s plan %5.1f %%  true %5.1f %%  %10.1f us with  %s, other: %s%s\n",
                    decided.lut.lut.name.c_str(), std::string(row_of(share.choice.effect).name).c_str(),
                    share.choice.is_simulated ? "simulated" : "left out", 100.0 * share.time_share, 100.0 * truth,
                    1e6 * seconds.on, integration_text(chosen).c_str(), integration_text(changed).c_str(),
                    is_wrong ? "  OFF" : "");
    }
    return off;
}

void shares_of_shipped_scenes(benchmark::State& state) {
    SceneRequest request;
    request.open_colours = open_ocio_spaces;
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(NACRE_SCENES_DIR)) {
        if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
    }
    std::sort(paths.begin(), paths.end());
    const std::vector<LoadedScene> scenes = load_scenes(paths, request);
    for (auto _ : state) {
        std::vector<DecidedLut> luts = undecided_luts(scenes);
        decide_all(luts, {});
        int off = 0;
        for (const DecidedLut& lut : luts) off += compare_lut(lut);
        state.counters["off"] = off;
    }
}

BENCHMARK(shares_of_shipped_scenes)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace nacre::bench
