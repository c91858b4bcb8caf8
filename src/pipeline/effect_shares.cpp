// What each effect of a LUT costs.
//
// In: a LUT as it was chosen. The texels without an effect, or with one that was left out, are timed as a bake of them
// would go: with the sampling that is right for them, and of tilted surfaces with the curve of facets' colours, whose
// number the choice remembers.
#include "pipeline/effect_shares.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/accuracy/effort.h"
#include "nacre/accuracy/survey.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/cost/effect_cost.h"
#include "nacre/lut/job.h"
#include "pipeline/plan_seconds.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

struct TooLong {};

// The job sampled as its own bake would be; as it is where finding that takes too long.
Job with_own_sampling(Job job, const PlannedLut& lut, const std::shared_ptr<NodeMaker>& nodes, double most_seconds,
                      const Execution& execution) {
    const double begin = thread_seconds();
    const auto in_time = [&] {
        execution.may_stop();
        if (thread_seconds() - begin > most_seconds) throw TooLong{};
    };
    try {
        const SamplingRequest request{lut.request.sampling, {}, nodes, false};
        job.sampling = choose_sampling(job, sampling_tolerance(lut.request.max_de00), request, in_time).sampling;
    } catch (const TooLong&) {
        return job;
    }
    return job;
}

// Without an effect that blurs them, spectra may need many times as many nodes: then that is not timed.
bool saves_nothing(const Job& job, const Job& less) {
    return is_layered(job.material.mechanism) &&
           effort_per_colour(less) > 2.0 * (effort_per_colour(job) + effort_per_mean(job));
}

// The job without, or with, the effect of each choice.
std::vector<Job> changed_jobs(const DecidedLut& decided, const Execution& execution) {
    const ChosenLut& chosen = decided.lut;
    const Job& job = chosen.lut.job;
    // For the sampling without each effect, of all of them together, beside deciding itself. Chosen: without what blurs
    // them, spectra may need hundreds of times as many nodes.
    constexpr double most_times_deciding = 10.0;
    double left_seconds = most_times_deciding * decided.seconds;
    const auto nodes = std::make_shared<NodeMaker>(job.light->weights);
    std::vector<Job> jobs;
    for (const EffectChoice& choice : chosen.effects) {
        Job changed = job;
        if (choice.is_simulated)
            changed = without_effect(std::move(changed), choice.effect);
        else
            changed.without.erase(choice.effect);
        const double begin = thread_seconds();
        changed = with_own_sampling(std::move(changed), chosen.lut, nodes, left_seconds, execution);
        left_seconds -= thread_seconds() - begin;
        if (choice.is_simulated && saves_nothing(job, changed)) changed = job;
        jobs.push_back(std::move(changed));
    }
    return jobs;
}

// With the curve of facets' colours, but without what deciding has already made of it for their mean.
Job with_bare_facets(Job job) {
    if (job.sampling.facets != nullptr)
        job.sampling.facets = std::make_shared<const FacetColours>(job.sampling.facets->colour());
    return job;
}

// Of each job, the least time of a few rounds: in turn, so that what else the machine does meets all of them.
std::vector<double> seconds_of(const std::vector<Job>& jobs, const Execution& execution) {
    constexpr int most_rounds = 20;
    constexpr double enough_seconds = 2e-3;
    constexpr double once_is_enough = 5e-2;
    std::vector<double> least(jobs.size(), std::numeric_limits<double>::infinity());
    double all = 0.0;
    for (int round = 0; round < most_rounds && (round == 0 || all < (round == 1 ? once_is_enough : enough_seconds));
         ++round) {
        const double begin = thread_seconds();
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            execution.may_stop();
            least[i] = std::min(least[i], seconds_of_facets(jobs[i]) + seconds_of_texels(jobs[i]));
        }
        all += thread_seconds() - begin;
    }
    return least;
}

}  // namespace

std::vector<EffectShare> effect_shares(const DecidedLut& decided, const Execution& execution) {
    std::vector<EffectShare> effects;
    if (decided.lut.effects.empty()) return effects;
    std::vector<Job> jobs = changed_jobs(decided, execution);
    jobs.push_back(decided.lut.lut.job);
    for (Job& job : jobs) job = with_bare_facets(std::move(job));
    const std::vector<double> seconds = seconds_of(jobs, execution);
    const double whole = seconds.back();
    for (std::size_t i = 0; i < decided.lut.effects.size(); ++i) {
        const EffectChoice& choice = decided.lut.effects[i];
        const double longer = choice.is_simulated ? whole : seconds[i];
        const double shorter = choice.is_simulated ? seconds[i] : whole;
        effects.push_back({choice, longer > 0.0 ? std::clamp(1.0 - shorter / longer, 0.0, 1.0) : 0.0});
    }
    std::stable_sort(effects.begin(), effects.end(), [](const EffectShare& a, const EffectShare& b) {
        if (a.choice.is_simulated != b.choice.is_simulated) return a.choice.is_simulated;
        return a.time_share > b.time_share;
    });
    return effects;
}

}  // namespace nacre
