#include "cli/loaded_scene.h"

#include <algorithm>

#include "cli/stop_signal.h"
#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/planned_swatch.h"
#include "pipeline/picked_colours.h"

namespace nacre {
namespace {

void check_names(const std::vector<std::string>& only, const std::vector<LoadedScene>& scenes) {
    std::vector<std::string> known;
    for (const LoadedScene& scene : scenes) known.insert(known.end(), scene.plan.names.begin(), scene.plan.names.end());
    for (const std::string& name : only) {
        const auto is_known = [&](const std::string& one) {
            return std::find(known.begin(), known.end(), one) != known.end();
        };
        if (is_known(name) || is_known(name + "_s")) continue;  // a name may stand for both polarisations
        const auto near = nearest_names(name, known, 5);
        throw Error("--only " + name + ": the scenes have no LUT or swatch of that name" +
                    (near.empty() ? "" : "; did you mean " + comma_separated(near) + "?"));
    }
}

}  // namespace

ColourTransform target_transform(const ColourConfig& config, const ColourSettings& colour, const std::string& where) {
    if (!colour.is_space_given) {
        const std::vector<std::string> known = config.colour_spaces();
        for (const char* name : {"lin_rec709_scene", "Linear Rec.709 (sRGB)", "lin_srgb", "Utility - Linear - sRGB"}) {
            if (std::find(known.begin(), known.end(), name) == known.end()) continue;
            if (std::find(known.begin(), known.end(), colour.space) == known.end())
                return config.to_colour_space(name, where);
        }
    }
    return config.to_colour_space(colour.space, where);
}

LoadedScene load_scene(const std::string& path, const std::string& ocio, bool want_swatches,
                       const std::vector<std::string>& only, bool strict, Console& console) {
    Plan plan = plan_scene(read_scene_file(path), scene_files_with_colours(path, ocio, throw_if_stopped),
                           {only, false, strict});
    for (const std::string& warning : plan.warnings) console.warning(warning);
    const ColourConfig config = ColourConfig::open(config_choice(plan.colour, path, ocio));
    const std::string where = plan.colour.space_where.line > 0 ? plan.colour.space_where.text() + " [colour]" : path;
    ColourTransform transform = target_transform(config, plan.colour, where);
    if (plan.colour.gamut == Gamut::compress && !transform.linear_matrix()) {
        throw Error(where + ": gamut = \"compress\" needs a linear space, and " + transform.target() +
                    " is none; use clip or keep");
    }
    plan.colour.space = transform.target();
    std::vector<ColourTransform> swatch_transforms;
    if (want_swatches) {
        for (const PlannedSwatch& swatch : plan.swatches) {
            swatch_transforms.push_back(
                config.to_display(swatch.display, swatch.view, swatch.where.text() + " [swatch." + swatch.name + "]"));
        }
    }
    console.note(path + ": " + std::to_string(plan.luts.size()) + " LUTs and " + std::to_string(plan.swatches.size()) +
                 " swatches; OpenColorIO config " + config.description() + ", space " + transform.target());
    std::optional<ColourTransform> strip_transform;
    const auto png_lut = std::find_if(plan.luts.begin(), plan.luts.end(), [](const PlannedLut& lut) {
        return std::find(lut.outputs.begin(), lut.outputs.end(), LutOutput::png) != lut.outputs.end();
    });
    if (png_lut != plan.luts.end())
        strip_transform = config.to_display("", "", png_lut->where.text() + " [lut." + png_lut->name + "]");
    ColourSource source{config.description(), config.content_hash()};
    return {path,
            std::move(plan),
            std::move(source),
            std::move(transform),
            std::move(swatch_transforms),
            std::move(strip_transform)};
}

std::vector<LoadedScene> load_scenes(const std::vector<std::string>& paths, const std::string& ocio, bool want_swatches,
                                     const std::vector<std::string>& only, bool strict, Console& console) {
    std::vector<LoadedScene> scenes;
    OutputNames names;
    for (const std::string& path : paths) {
        scenes.push_back(load_scene(path, ocio, want_swatches, only, strict, console));
        names.claim(scenes.back().plan);
    }
    check_names(only, scenes);
    return scenes;
}

}  // namespace nacre
