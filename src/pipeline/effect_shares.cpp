// What each effect of a LUT costs.
//
// In: a LUT as it was chosen. The texels without an effect, or with one that was left out, are timed as a bake of them
// would go: at the nodes that their own spectra need, and of tilted surfaces with the curve of facets' colours, whose
// number the choice remembers.
#include "pipeline/effect_shares.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "nacre/accuracy/choose_nodes.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/accuracy/effort.h"
#include "nacre/accuracy/probes.h"
#include "nacre/accuracy/survey.h"
#include "nacre/cost/effect_cost.h"
#include "nacre/lut/job.h"
#include "pipeline/plan_seconds.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

// Curves of facets' colours take about as many colours with an effect as without it.
Job without_one_effect(const Job& job, Effect effect) {
    Job changed = without_effect(job, effect);
    if (effect != Effect::tilt) changed.sampling.facets = job.sampling.facets;
    return changed;
}

// A job with an effect that was left out, sampled as it would have been.
Job with_effect(const PlannedLut& lut, Effect effect) {
    // What a survey allows sums to err by.
    constexpr double share_of_spread = 0.3;
    constexpr double share_of_quadrature = 0.04;
    const double bound = lut.request.max_de00;
    Job job = lut.job;
    job.without.erase(effect);
    job.sampling =
        choose_sampling(job, {tolerance_of_nodes(bound), share_of_spread * bound, share_of_quadrature * bound, 0.0})
            .sampling;
    return job;
}

// Next to grazing there are many angles and few texels: a third of them show how many nodes another material needs
// (empirical).
void thin_out(Probes& probes) {
    constexpr std::size_t step = 3;
    for (Probe& probe : probes.bands.back()) {
        std::vector<Geometry> kept;
        for (std::size_t i = 0; i < probe.geometries.size(); i += step) kept.push_back(probe.geometries[i]);
        probe.geometries = std::move(kept);
    }
}

struct TooLong {};

// The job at the nodes that its own spectra need; as it is where they are given, or where finding them takes too long.
Job with_own_nodes(Job job, const PlannedLut& lut, const std::shared_ptr<NodeMaker>& nodes, double most_seconds,
                   const Execution& execution) {
    const bool is_given = job.light->settings.wavelengths || lut.request.sampling.nodes.front() > 0;
    if (is_given || !samples_spectra(job.material.mechanism)) return job;
    const double begin = thread_seconds();
    const auto in_time = [&] {
        execution.may_stop();
        if (thread_seconds() - begin > most_seconds) throw TooLong{};
    };
    try {
        Probes probes = make_probes(job, in_time, nodes);
        thin_out(probes);
        ProbeTally tally;
        ChosenNodes chosen =
            choose_nodes(probes, job.sampling, tolerance_of_nodes(lut.request.max_de00), {}, {}, tally);
        job.sampling.nodes = std::move(chosen.nodes);
        job.sampling.incoherent_layers = std::move(chosen.incoherent_layers);
    } catch (const TooLong&) {
        return job;
    }
    return job;
}

// Without an effect that blurs them, spectra may need many times as many nodes: then that is not timed.
bool saves_nothing(const Job& job, const Job& less) {
    return is_layered(job.material.mechanism) && effort_per_colour(less) > 2.0 * effort_per_colour(job);
}

// The job without, or with, the effect of each choice.
std::vector<Job> changed_jobs(const DecidedLut& decided, const Execution& execution) {
    const ChosenLut& chosen = decided.lut;
    const Job& job = chosen.lut.job;
    // For the nodes without an effect, of all effects together: as long as deciding took. Chosen.
    double left_seconds = decided.seconds;
    const auto nodes = std::make_shared<NodeMaker>(job.light->weights);
    std::vector<Job> jobs;
    for (const EffectChoice& choice : chosen.effects) {
        if (!choice.is_simulated) {
            jobs.push_back(with_effect(chosen.lut, choice.effect));
            continue;
        }
        Job less = without_one_effect(job, choice.effect);
        // A mean over facets needs the nodes of what it is the mean of.
        if (choice.effect != Effect::tilt) {
            const double begin = thread_seconds();
            less = with_own_nodes(std::move(less), chosen.lut, nodes, left_seconds, execution);
            left_seconds -= thread_seconds() - begin;
            if (saves_nothing(job, less)) less = job;
        }
        jobs.push_back(std::move(less));
    }
    return jobs;
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
