#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "nacre/lut/colour_settings.h"
#include "nacre/lut/colour_space.h"
#include "nacre/lut/colour_spaces.h"
#include "nacre/scene/edit_scene.h"
#include "nacre/scene/plan.h"
#include "pipeline/baked_lut.h"

namespace nacre {

/// What a command line says of colours: it wins over the scene, and over the tables of its LUTs and swatches. Empty:
/// the scene decides.
struct ColourOverride {
    std::string space;
    std::string display;  ///< of all pictures; with its default view unless `view` is given
    std::string view;
};

/// What of a scene is wanted, and where its colour spaces come from.
struct SceneRequest {
    OpenColourSpaces open_colours;
    std::string config;  ///< colour config of the front end (--ocio); wins over the scene's. May be empty
    ColourOverride colours;
    bool want_swatches = true;      ///< whether displays and views are needed
    std::vector<std::string> only;  ///< names of LUTs and swatches; empty: all
    std::vector<SceneEdit> edits;   ///< made in every scene before it is planned
    bool all_materials = false;     ///< those too that no LUT and no swatch asks for
    bool strict = false;            ///< whether a picked colour that cannot be reached is an error
    bool wants_pale_paths = false;  ///< whether it is to be known where a palette passes through grey
    bool any_thickness = false;     ///< whether layers may be too thick for a LUT
    /// Shared by scenes that are planned one after the other; null: each makes its own, or load_scenes() does.
    std::shared_ptr<KnownBands> bands{};
    /// Called every few steps of a search for what picks ask for; what it throws ends it. May be empty.
    std::function<void()> after_step{};
    /// Told what is allowed and hardly meant, as soon as the scene is planned. May be empty.
    std::function<void(const std::string& warning)> on_warning{};
};

/// A scene with nothing left to go wrong but the disk: planned, its colour config open, every space, display and view
/// found.
struct LoadedScene {
    std::string path;
    Plan plan;
    ColourSource source;
    std::shared_ptr<const ColourSpaces> colours;                       ///< the scene's config
    std::map<std::string, std::shared_ptr<const ColourSpace>> spaces;  ///< of the scene and of its LUTs, by name
    std::vector<std::shared_ptr<const ColourSpace>> displays;  ///< as many as the plan has swatches, if they are wanted
    /// The config's default, or what the command line asks for. If a LUT asks for a png, or the command line for a
    /// display; else null until it is opened.
    std::shared_ptr<const ColourSpace> default_display;

    /// @pre the colour is that of the plan, of one of its LUTs or of one of its swatches
    const ColourSpace& space_of(const LutColour& colour) const { return *spaces.at(colour.space); }
};

/// Opens the display and view of pictures that name none, unless that was done.
/// @param where  who needs them, for messages
/// @throws Error if its config has none
void open_default_display(LoadedScene& scene, const std::string& where);

/// Reads and plans a scene file, without its colour space and its variants.
Plan plan_file(const std::string& path, const SceneRequest& request);

/// Reads, plans and opens a scene file without its variants.
LoadedScene load_scene(const std::string& path, const SceneRequest& request);

/// The same of text that is in memory, without its colour space.
/// @param name  what messages call it
Plan plan_text(const std::string& text, const std::string& name, const SceneRequest& request);

LoadedScene load_scene_text(const std::string& text, const std::string& name, const SceneRequest& request);

/// All of them; a scene with variants is one scene per variant. Throws Error if two would write one file.
std::vector<LoadedScene> load_scenes(const std::vector<std::string>& paths, const SceneRequest& request);

}  // namespace nacre
