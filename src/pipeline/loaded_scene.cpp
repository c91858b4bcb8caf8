// Opening a scene: its text is read and planned (nacre/scene), then the colour config that it names is opened, and
// every space, display and view that the plan speaks of is looked up. After that only the disk can fail.
#include "pipeline/loaded_scene.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "io/scene/scene_file.h"
#include "io/scene/variants.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
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

// nacre's default space, linear Rec.709, and what configs call it that have no lin_rec709.
constexpr const char* default_space_names[] = {"lin_rec709", "lin_rec709_scene", "Linear Rec.709 (sRGB)", "lin_srgb",
                                               "Utility - Linear - sRGB"};
constexpr const char* scene_linear_role = "scene_linear";

[[noreturn]] void throw_no_default(const std::string& where, const ColourSpaces& colours) {
    const std::string linear = colours.space_called(scene_linear_role);
    const std::vector<std::string> known = colours.names();
    throw Error(
        where + ": config " + in_quotes(colours.description()) +
        " has no lin_rec709, which is nacre's default space; name one of its spaces with [colour] space or --space" +
        (linear.empty() ? "; known: " + comma_separated(known)
                        : ", for example " + in_quotes(linear) + ", its role scene_linear"));
}

// The space of a scene that names none. $OCIO is set for all programs of a pipeline: with it nacre works in the linear
// space in which they work. A config that was named for nacre is asked for nacre's own default.
void choose_default_space(LutColour& colour, const ColourSpaces& colours, const std::string& scene_path) {
    if (colour.is_space_given) return;
    const bool is_piped = colours.is_from_environment();
    if (is_piped && colour.where.empty()) colour.where = "$OCIO";
    const std::string linear = is_piped ? colours.space_called(scene_linear_role) : std::string();
    if (!linear.empty()) {
        colour.space = linear;
        return;
    }
    const auto name = std::find_if(std::begin(default_space_names), std::end(default_space_names),
                                   [&](const char* candidate) { return !colours.space_called(candidate).empty(); });
    if (name == std::end(default_space_names))
        throw_no_default(colour.where.empty() ? scene_path : colour.where, colours);
    colour.space = *name;
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

// A config need not have a default space that no LUT and no swatch is left to.
bool needs_scene_space(const Plan& plan) {
    const auto names_one = [](const auto& lut_or_swatch) { return lut_or_swatch.colour.is_space_given; };
    return plan.colour.is_space_given || plan.luts.empty() ||
           !std::all_of(plan.luts.begin(), plan.luts.end(), names_one) ||
           !std::all_of(plan.swatches.begin(), plan.swatches.end(), names_one);
}

void open_spaces(Plan& plan, LoadedScene& scene) {
    // A LUT that names no space has the scene's.
    if (needs_scene_space(plan)) {
        choose_default_space(plan.colour, *scene.colours, scene.path);
        open_space(plan.colour, scene);
    }
    const std::string scene_space = plan.colour.space;
    const auto open = [&](LutColour& colour) {
        if (!colour.is_space_given) colour.space = scene_space;
        open_space(colour, scene);
    };
    for (PlannedLut& lut : plan.luts) open(lut.colour);
    for (PlannedSwatch& swatch : plan.swatches) open(swatch.colour);
}

void override_colours(Plan& plan, const ColourOverride& asked) {
    const auto set_space = [&](LutColour& colour) {
        if (asked.space.empty()) return;
        colour.space = asked.space;
        colour.is_space_given = true;
        colour.where = "--space";
    };
    set_space(plan.colour);
    for (PlannedLut& lut : plan.luts) set_space(lut.colour);
    for (PlannedSwatch& swatch : plan.swatches) {
        set_space(swatch.colour);
        // The view that a scene names is one of the display that it names.
        if (!asked.display.empty()) {
            swatch.display = asked.display;
            swatch.view.clear();
        }
        if (!asked.view.empty()) swatch.view = asked.view;
    }
}

// A display of the command line is looked up even if no picture needs it, so that its mistakes are always found.
void open_display_of_command_line(LoadedScene& scene, const ColourOverride& asked) {
    if (asked.display.empty() && asked.view.empty()) return;
    const std::string where = asked.display.empty() ? "--view" : asked.view.empty() ? "--display" : "--display, --view";
    scene.default_display = scene.colours->display_view(asked.display, asked.view, where);
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
                   {request.only, request.all_materials, request.strict, request.any_thickness, request.bands,
                    request.wants_pale_paths});
    if (request.on_warning) {
        for (const std::string& warning : plan.warnings) request.on_warning(warning);
    }
    return plan;
}

LoadedScene with_colours(Plan plan, const std::string& path, const SceneRequest& request) {
    LoadedScene scene;
    scene.path = path;
    scene.colours = request.open_colours(config_choice(plan.colour, path, request.config));
    scene.source = {scene.colours->description(), scene.colours->content_hash(), scene.colours->short_name()};
    override_colours(plan, request.colours);
    open_spaces(plan, scene);
    open_display_of_command_line(scene, request.colours);
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
    using Key = std::array<std::string, 3>;
    const auto opened = std::make_shared<std::map<Key, std::shared_ptr<const ColourSpaces>>>();
    return [open, opened](const ColourConfigChoice& choice) {
        auto& spaces = (*opened)[Key{choice.path, choice.interchange, choice.aces_interchange}];
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

LoadedScene load_scene(const std::string& path, const SceneRequest& request) {
    return with_colours(plan_file(path, request), path, request);
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
