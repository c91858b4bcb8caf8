#include "cli/effect_table.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/report.h"
#include "cli/stop_signal.h"
#include "cli/text_table.h"
#include "cli/thread_clock.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/names.h"
#include "nacre/cost/effect_cost.h"
#include "nacre/lut/bake.h"

namespace nacre {
namespace {

// Of a few texels all over the axes: what is prepared once counts as much as in a whole LUT, or more.
constexpr int piece_width = 96;
constexpr int piece_height = 4;

double bake_seconds(Job job) {
    job.width = std::min(job.width, piece_width);
    job.height = std::min(job.height, piece_height);
    constexpr int runs = 3;
    double best = 0.0;
    for (int run = 0; run < runs; ++run) {
        throw_if_stopped();
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

std::string reason(const EffectChoice& choice) {
    if (choice.is_given) return "the scene does without; that changes colours by " + short_number(choice.contribution);
    if (!choice.is_measured) return "asked for";
    return "changes colours by " + short_number(choice.contribution) +
           (choice.is_simulated ? ", more than " : ", within ") + short_number(choice.share);
}

std::string state(const EffectChoice& choice, const std::string& negligible) {
    return choice.is_simulated ? "simulated" : choice.is_given ? "left out" : negligible;
}

bool is_listed(const std::vector<EffectShare>& effects, Effect effect) {
    return std::any_of(effects.begin(), effects.end(),
                       [&](const EffectShare& share) { return share.choice.effect == effect; });
}

}  // namespace

std::vector<EffectShare> effect_shares(const SettledLut& settled) {
    const Job& job = settled.lut.job;
    std::vector<EffectShare> effects;
    if (settled.effects.empty()) return effects;
    const double whole = bake_seconds(job);
    for (const EffectChoice& choice : settled.effects) {
        EffectShare& share = effects.emplace_back(EffectShare{choice, 0.0});
        const double other = choice.is_simulated ? bake_seconds(without_effect(job, choice.effect))
                                                 : bake_seconds(with_effect(job, choice.effect));
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

std::vector<std::string> effect_lines(const std::string& lut, const std::vector<EffectShare>& effects) {
    std::vector<std::vector<std::string>> rows{{"effects of " + lut, "", "time", "why"}};
    for (const EffectShare& share : effects) {
        const std::string percent = std::to_string(std::lround(100.0 * share.time_share)) + " %";
        rows.push_back({std::string(row_of(share.choice.effect).name), state(share.choice, "negligible here"),
                        share.choice.is_simulated ? percent : "saves " + percent, reason(share.choice)});
    }
    std::vector<std::string> absent;
    for (const EffectRow& row : effect_rows()) {
        if (!is_listed(effects, row.effect)) absent.emplace_back(row.name);
    }
    std::vector<std::string> lines;
    if (!effects.empty()) lines = table_lines(rows, {false, false, true, false});
    if (absent.empty()) return lines;
    constexpr std::size_t width = 100;
    std::string line = "not in " + lut + ":";
    for (std::size_t i = 0; i < absent.size(); ++i) {
        const std::string word = " " + absent[i] + (i + 1 < absent.size() ? "," : "");
        if (line.size() + word.size() > width) lines.push_back(std::exchange(line, "   "));
        line += word;
    }
    lines.push_back(line);
    return lines;
}

nlohmann::ordered_json effects_json(const std::vector<EffectShare>& effects) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const EffectShare& share : effects) {
        const EffectChoice& choice = share.choice;
        nlohmann::ordered_json row{{"effect", row_of(choice.effect).name}, {"state", state(choice, "negligible")}};
        row["de00"] = nullptr;
        if (choice.is_measured) row["de00"] = choice.contribution;
        row["share"] = choice.share;
        row["time_share"] = share.time_share;
        row["why"] = reason(choice);
        json.push_back(std::move(row));
    }
    for (const EffectRow& row : effect_rows()) {
        if (!is_listed(effects, row.effect)) json.push_back({{"effect", row.name}, {"state", "absent"}});
    }
    return json;
}

}  // namespace nacre
