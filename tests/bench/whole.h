#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/measure.h"
#include "nacre/cost/cost.h"
#include "nacre/lut/bake.h"
#include "pipeline/baked_lut.h"
#include "pipeline/thread_clock.h"

/// What a LUT costs as a whole: deciding on it, computing it, measuring it, beside computing alone.
namespace nacre::bench {

struct WholeSeconds {
    double computing = 0.0;
    double deciding = 0.0;
    double measuring = 0.0;

    double all() const { return computing + deciding + measuring; }
    /// All together over ten times computing, or over 5 ms where that is more: above 1 is too slow.
    double of_allowed() const { return all() / std::max(10.0 * computing, 5e-3); }
};

inline double thread_seconds_of(const std::function<void()>& work) {
    const double start = thread_seconds();
    work();
    return thread_seconds() - start;
}

/// The colours of tilted facets are a part of computing, though deciding has found them.
inline WholeSeconds whole_bake(const PlannedLut& lut, const Encoding& encoding) {
    ChosenLut chosen;
    Image<Rgb> stored;
    WholeSeconds seconds;
    seconds.deciding = thread_seconds_of([&] { chosen = choose_lut(lut, encoding); });
    const Job& job = chosen.lut.job;
    const Image<Xyz> texels = bake(job);
    seconds.computing = thread_seconds_of([&] { stored = stored_lut(job, chosen.lut.format, encoding); });
    if (job.sampling.facets != nullptr) {
        Job bare = job;
        bare.sampling.facets.reset();
        const double alone = thread_seconds_of([&] { stored_lut(bare, chosen.lut.format, encoding); });
        seconds.deciding -= std::max(alone - seconds.computing, 0.0);
        seconds.computing = std::max(alone, seconds.computing);
    }
    seconds.measuring = thread_seconds_of([&] { benchmark::DoNotOptimize(measure(chosen, texels, stored, encoding)); });
    return seconds;
}

/// The run with the median of all together: on a shared machine some take twice as long.
inline WholeSeconds median_whole_bake(const PlannedLut& lut, const Encoding& encoding) {
    std::array<WholeSeconds, 5> runs;
    for (WholeSeconds& run : runs) run = whole_bake(lut, encoding);
    std::sort(runs.begin(), runs.end(), [](const WholeSeconds& a, const WholeSeconds& b) { return a.all() < b.all(); });
    return runs[runs.size() / 2];
}

inline void report(benchmark::State& state, const WholeSeconds& seconds) {
    state.counters["computing_ms"] = 1e3 * seconds.computing;
    state.counters["deciding_ms"] = 1e3 * seconds.deciding;
    state.counters["measuring_ms"] = 1e3 * seconds.measuring;
    state.counters["ratio"] = seconds.all() / seconds.computing;
    state.counters["of_allowed"] = seconds.of_allowed();
}

}  // namespace nacre::bench
