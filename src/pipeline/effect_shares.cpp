#include "pipeline/effect_shares.h"

#include <algorithm>

#include "nacre/cost/effect_cost.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/job.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

// Of a few texels all over the axes: what is prepared once counts as much as in a whole LUT, or more.
constexpr int piece_width = 96;
constexpr int piece_height = 4;

double bake_seconds(Job job, const Execution& execution) {
    job.width = std::min(job.width, piece_width);
    job.height = std::min(job.height, piece_height);
    constexpr int runs = 3;
    double best = 0.0;
    for (int run = 0; run < runs; ++run) {
        execution.may_stop();
        const double begin = thread_seconds();
        bake(job);
        const double seconds = thread_seconds() - begin;
        best = run == 0 ? seconds : std::min(best, seconds);
    }
    return best;
}

// A job with an effect that was left out, sampled as it would have been.
Job with_effect(Job job, Effect effect) {
    job.without.erase(effect);
    job.sampling = choose_sampling(job, {1e-2, 0.1, 1e-2, 0.0}).sampling;
    return job;
}

}  // namespace

std::vector<EffectShare> effect_shares(const ChosenLut& chosen, const Execution& execution) {
    const Job& job = chosen.lut.job;
    std::vector<EffectShare> effects;
    if (chosen.effects.empty()) return effects;
    const double whole = bake_seconds(job, execution);
    for (const EffectChoice& choice : chosen.effects) {
        EffectShare& share = effects.emplace_back(EffectShare{choice, 0.0});
        const double other = choice.is_simulated ? bake_seconds(without_effect(job, choice.effect), execution)
                                                 : bake_seconds(with_effect(job, choice.effect), execution);
        const double longer = choice.is_simulated ? whole : other;
        const double shorter = choice.is_simulated ? other : whole;
        if (longer > 0.0) share.time_share = std::clamp(1.0 - shorter / longer, 0.0, 1.0);
    }
    std::stable_sort(effects.begin(), effects.end(), [](const EffectShare& a, const EffectShare& b) {
        if (a.choice.is_simulated != b.choice.is_simulated) return a.choice.is_simulated;
        return a.time_share > b.time_share;
    });
    return effects;
}

}  // namespace nacre
