#include "cli/effect_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/report.h"
#include "cli/text_table.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/names.h"

namespace nacre {
namespace {

std::string reason(const EffectChoice& choice) {
    if (choice.is_given) return "left out by the scene; this changes colours by " + short_number(choice.contribution);
    if (!choice.is_measured) return "requested";
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
    std::string line = "effects not in " + lut + ":";
    for (std::size_t i = 0; i < absent.size(); ++i) {
        const std::string word = " " + absent[i] + (i + 1 < absent.size() ? "," : "");
        if (line.size() + word.size() > width) lines.push_back(std::exchange(line, "   "));
        line += word;
    }
    lines.push_back(line);
    return lines;
}

Json effects_json(const std::vector<EffectShare>& effects) {
    Json json = Json::array();
    for (const EffectShare& share : effects) {
        const EffectChoice& choice = share.choice;
        Json row{{"effect", row_of(choice.effect).name}, {"state", state(choice, "negligible")}};
        row["de00"] = choice.is_measured ? Json(choice.contribution) : Json();
        row["share"] = choice.share;
        row["time_share"] = share.time_share;
        row["why"] = reason(choice);
        json.push_back(row);
    }
    for (const EffectRow& row : effect_rows()) {
        if (!is_listed(effects, row.effect)) json.push_back(Json{{"effect", row.name}, {"state", "absent"}});
    }
    return json;
}

}  // namespace nacre
