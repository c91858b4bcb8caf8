#include "cli/scenes.h"

#include <algorithm>
#include <cstddef>

#include "cli/report.h"
#include "cli/stop_signal.h"
#include "io/ocio/ocio_spaces.h"
#include "io/scene/toml_tree.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {
namespace {

void check_names(const std::vector<std::string>& only, const std::vector<LoadedScene>& scenes) {
    std::vector<std::string> known;
    for (const LoadedScene& scene : scenes) known.insert(known.end(), scene.plan.names.begin(), scene.plan.names.end());
    for (const std::string& name : only) {
        const auto is_known = [&](const std::string& one) {
            return std::find(known.begin(), known.end(), one) != known.end();
        };
        // A name may stand for both polarisations, for reflectance and transmittance, or for all four.
        if (is_known(name) || is_known(name + "_s") || is_known(name + "_r") || is_known(name + "_s_r")) continue;
        throw Error("--only " + in_quotes(name) +
                    ": the scenes have no LUT or swatch of that name; known: " + known_like(name, known));
    }
}

}  // namespace

SceneRequest scene_request(const std::string& ocio, Console& console) {
    SceneRequest request;
    request.open_colours = open_ocio_spaces;
    request.config = ocio;
    request.after_step = throw_if_stopped;
    request.on_warning = [&console](const std::string& warning) { console.warning(warning); };
    return request;
}

std::vector<SceneEdit> scene_edits(const std::vector<std::string>& words) {
    std::vector<SceneEdit> edits;
    for (const std::string& word : words) {
        const Where where{"--set " + in_quotes(word)};
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos) {
            throw Error(where.text() +
                        ": is not KEY=VALUE; write for example --set material.hero.picks[0].colour=#aa2244");
        }
        const std::string key = word.substr(0, equals);
        const std::string heading = key.substr(0, std::min(key.rfind('.'), key.size()));
        edits.push_back({key, parse_value(word.substr(equals + 1), heading, where), where});
    }
    return edits;
}

std::vector<LoadedScene> open_scenes(const std::vector<std::string>& paths, const SceneRequest& request,
                                     Console& console) {
    std::vector<LoadedScene> scenes = load_scenes(paths, request);
    for (const LoadedScene& scene : scenes) {
        console.note(scene.path + ": LUTs: " + std::to_string(scene.plan.luts.size()) +
                     ", swatches: " + std::to_string(scene.plan.swatches.size()) + "; OpenColorIO config " +
                     scene.source.config + ", space " + scene.plan.colour.space);
    }
    check_names(request.only, scenes);
    return scenes;
}

AccuracyOverride accuracy_override(double max_de00, const std::string& effects) {
    AccuracyOverride accuracy;
    if (max_de00 > 0.0) accuracy.max_de00 = max_de00;
    if (!effects.empty()) accuracy.may_drop_effects = effects == "auto";
    return accuracy;
}

std::size_t report_out_of_reach(const std::vector<DecidedLut>& luts, bool best_effort, Console& console) {
    std::size_t count = 0;
    for (const DecidedLut& lut : luts) {
        if (!lut.is_out_of_reach()) continue;
        const bool is_error = lut.lut.lut.request.is_binding && !best_effort;
        is_error ? console.error(out_of_reach(lut.lut)) : console.warning(out_of_reach(lut.lut));
        count += is_error ? 1 : 0;
    }
    return count;
}

}  // namespace nacre
