#include "cli/loaded_scene.h"

#include <filesystem>
#include <map>

#include "io/scene_file.h"
#include "nacre/error.h"

namespace nacre {
namespace {

ColourConfigChoice config_choice(const Plan& plan, const std::string& scene_path, const std::string& ocio) {
    const ColourSettings& colour = plan.colour;
    if (!ocio.empty()) return {ocio, colour.interchange, "--ocio"};
    if (colour.config.empty()) return {"", colour.interchange, scene_path};
    // A file that a scene names lies beside the scene.
    const auto file = std::filesystem::path(colour.config_where.file).parent_path() / colour.config;
    return {file.string(), colour.interchange, colour.config_where.text() + " [colour]"};
}

void check_output_names(const std::vector<LoadedScene>& scenes) {
    std::map<std::string, std::string> taken;
    const auto claim = [&](const std::string& name, const std::string& suffix, const Where& where) {
        std::string key = name + suffix;
        for (char& c : key) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        const auto [first, is_new] = taken.emplace(key, where.text());
        if (!is_new)
            throw Error(where.text() + ": this would write " + name + suffix + ", and so would " + first->second +
                        "; rename one of them");
    };
    for (const LoadedScene& scene : scenes) {
        for (const PlannedLut& lut : scene.plan.luts) {
            for (const LutOutput output : lut.outputs)
                claim(lut.name, "." + std::string(name_of(output_words, output)), lut.where);
        }
        for (const PlannedSwatch& swatch : scene.plan.swatches) claim(swatch.name, ".png", swatch.where);
    }
}

}  // namespace

LoadedScene load_scene(const std::string& path, const std::string& ocio, bool want_swatches, Console& console) {
    Plan plan = plan_scene(read_scene_file(path), curve_reader());
    const ColourConfig config = ColourConfig::open(config_choice(plan, path, ocio));
    const std::string where = plan.colour.space_where.line > 0 ? plan.colour.space_where.text() + " [colour]" : path;
    ColourTransform transform = config.to_colour_space(plan.colour.space, where);
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
    ColourSource source{config.description(), config.content_hash()};
    return {path, std::move(plan), config, std::move(source), std::move(transform), std::move(swatch_transforms)};
}

std::vector<LoadedScene> load_scenes(const std::vector<std::string>& paths, const std::string& ocio, bool want_swatches,
                                     Console& console) {
    std::vector<LoadedScene> scenes;
    for (const std::string& path : paths) scenes.push_back(load_scene(path, ocio, want_swatches, console));
    check_output_names(scenes);
    return scenes;
}

}  // namespace nacre
