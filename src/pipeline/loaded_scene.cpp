// Opening a scene: its text is read and planned (nacre/scene), then the colour config that it names is opened, and
// every space, display and view that the plan speaks of is looked up. After that only the disk can fail.
#include "pipeline/loaded_scene.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "io/scene/scene_file.h"
#include "io/scene/variants.h"
#include "nacre/base/error.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/gamut.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/output_names.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/scene/table.h"
#include "pipeline/picked_colours.h"
#include "pipeline/plan_variants.h"

namespace nacre {
namespace {

// What configs call linear Rec.709, nacre's default space, when they do not call it lin_rec709.
constexpr const char* linear_rec709_names[] = {"lin_rec709_scene", "Linear Rec.709 (sRGB)", "lin_srgb",
                                               "Utility - Linear - sRGB"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// What the config calls the space that nobody named.
void find_default_name(LutColour& colour, const ColourSpaces& colours) {
    if (colour.is_space_given) return;
    const std::vector<std::string> known = colours.names();
    const auto other = std::find_if(std::begin(linear_rec709_names), std::end(linear_rec709_names),
                                    [&](const char* candidate) { return contains(known, candidate); });
    if (!contains(known, colour.space) && other != std::end(linear_rec709_names)) colour.space = *other;
}

// Opens the space, and gives it the name that its config has for it.
void open_space(LutColour& colour, LoadedScene& scene) {
    const std::string& where = colour.where.empty() ? scene.path : colour.where;
    std::shared_ptr<const ColourSpace>& space = scene.spaces[colour.space];
    if (space == nullptr) space = scene.colours->space(colour.space, where);
    if (colour.gamut == Gamut::compress && !space->linear_matrix()) {
        throw Error(where + ": gamut = \"compress\" needs a linear space, and " + space->name() +
                    " is not linear; use clip or keep");
    }
    colour.space = space->name();
    scene.spaces.emplace(space->name(), space);
}

void open_spaces(Plan& plan, LoadedScene& scene) {
    // A LUT that names no space has the scene's.
    find_default_name(plan.colour, *scene.colours);
    const std::string scene_space = plan.colour.space;
    open_space(plan.colour, scene);
    const auto open = [&](LutColour& colour) {
        if (!colour.is_space_given) colour.space = scene_space;
        open_space(colour, scene);
    };
    for (PlannedLut& lut : plan.luts) open(lut.colour);
    for (PlannedSwatch& swatch : plan.swatches) open(swatch.colour);
}

// The texels of a LUT become a picture by way of XYZ.
void open_display_of_pngs(const Plan& plan, LoadedScene& scene) {
    for (const PlannedLut& lut : plan.luts) {
        if (std::find(lut.outputs.begin(), lut.outputs.end(), LutOutput::png) == lut.outputs.end()) continue;
        const std::string where = lut.where.text() + " [lut." + lut.name + "]";
        open_default_display(scene, where);
        const ColourSpace& space = scene.space_of(lut.colour);
        if (!space.has_inverse()) {
            throw Error(where + ": outputs has \"png\", and space " + space.name() +
                        " has no inverse to XYZ, so its texels cannot be shown; remove \"png\"");
        }
    }
}

Plan plan_table(const Table& table, const std::string& path, const SceneRequest& request) {
    Plan plan =
        plan_scene(table, scene_files_with_colours(path, request.config, request.open_colours, request.after_step),
                   {request.only, request.all_materials, request.strict, request.bands});
    if (request.on_warning) {
        for (const std::string& warning : plan.warnings) request.on_warning(warning);
    }
    return plan;
}

LoadedScene with_colours(Plan plan, const std::string& path, const SceneRequest& request) {
    LoadedScene scene;
    scene.path = path;
    scene.colours = request.open_colours(config_choice(plan.colour, path, request.config));
    scene.source = {scene.colours->description(), scene.colours->content_hash()};
    open_spaces(plan, scene);
    if (request.want_swatches) {
        for (const PlannedSwatch& swatch : plan.swatches) {
            scene.displays.push_back(scene.colours->display_view(
                swatch.display, swatch.view, swatch.where.text() + " [swatch." + swatch.name + "]"));
        }
    }
    open_display_of_pngs(plan, scene);
    scene.plan = std::move(plan);
    return scene;
}

// Opens each config once for all variants of a scene.
OpenColourSpaces opened_once(const OpenColourSpaces& open) {
    using Key = std::pair<std::string, std::string>;
    const auto opened = std::make_shared<std::map<Key, std::shared_ptr<const ColourSpaces>>>();
    return [open, opened](const ColourConfigChoice& choice) {
        auto& spaces = (*opened)[Key(choice.path, choice.interchange)];
        if (spaces == nullptr) spaces = open(choice);
        return spaces;
    };
}

Table edited(Table table, const SceneRequest& request) {
    for (const SceneEdit& edit : request.edits) set_key(table, edit);
    return table;
}

// One scene, or one per variant.
std::vector<LoadedScene> load_file(const std::string& path, const SceneRequest& asked) {
    const Table table = edited(read_scene_file(path), asked);
    SceneRequest request = asked;
    request.open_colours = opened_once(asked.open_colours);
    const auto plan = [&](const Table& scene, const SceneRequest& own) {
        Plan planned = plan_table(scene, path, own);
        add_edits(planned, own.edits);
        return planned;
    };
    const std::vector<Variant> variants = read_variants(table);
    std::vector<LoadedScene> scenes;
    if (variants.empty()) {
        scenes.push_back(with_colours(plan(table, request), path, request));
        return scenes;
    }
    for (Plan& one : plan_variants(table, variants, request, plan))
        scenes.push_back(with_colours(std::move(one), path, request));
    return scenes;
}

}  // namespace

void open_default_display(LoadedScene& scene, const std::string& where) {
    if (scene.default_display == nullptr) scene.default_display = scene.colours->display_view("", "", where);
}

Plan plan_file(const std::string& path, const SceneRequest& request) {
    return plan_table(edited(read_scene_file(path), request), path, request);
}

Plan plan_text(const std::string& text, const std::string& name, const SceneRequest& request) {
    return plan_table(edited(parse_scene(text, name), request), name, request);
}

LoadedScene load_scene_text(const std::string& text, const std::string& name, const SceneRequest& request) {
    return with_colours(plan_text(text, name, request), name, request);
}

std::vector<LoadedScene> load_scenes(const std::vector<std::string>& paths, const SceneRequest& asked) {
    SceneRequest request = asked;
    if (!request.bands) request.bands = std::make_shared<KnownBands>();
    std::vector<LoadedScene> scenes;
    OutputNames names;
    for (const std::string& path : paths) {
        for (LoadedScene& scene : load_file(path, request)) {
            names.claim(scene.plan);
            scenes.push_back(std::move(scene));
        }
    }
    return scenes;
}

}  // namespace nacre
