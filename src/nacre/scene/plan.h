#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nacre/colour/light.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/band/known_bands.h"
#include "nacre/pick/band/pale_path.h"
#include "nacre/pick/fit_shape.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/pick/picked_colour.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/scene/readers/light_reader.h"
#include "nacre/scene/scene_context.h"

namespace nacre {

/// A material of the scene, and what its picks became.
struct SceneMaterial : Material {
    std::vector<PickedColour> picked;   ///< of the mechanism's picks those that were given as colours
    std::optional<ShapeFit> shape_fit;  ///< of a palette that left its shape open
    std::vector<PalePath> pale_paths;   ///< of a palette of colours
};

struct Plan {
    std::shared_ptr<const Light> light;
    ColourSettings colour;
    std::vector<std::string> names;        ///< of all LUTs and swatches that the scene has, asked for or not
    std::vector<std::string> warnings;     ///< of what is allowed and hardly meant, with file, line and column
    std::vector<SceneMaterial> materials;  ///< those that were read
    std::vector<MaterialSearch> searches;  ///< of these, what picks of films, stacks, gratings and crystals led to
    std::vector<PlannedLut> luts;
    std::vector<PlannedSwatch> swatches;
    bool has_swatches = false;  ///< whether the scene has any [swatch], asked for or not
    std::string variant{};      ///< the name of the variant of the scene that this is; empty: it is the scene itself
};

/// Null if the plan has no material of that name.
const SceneMaterial* find_material(const Plan& plan, const std::string& name);

/// How the core asks for the files that a scene names.
struct SceneFiles {
    CurveReader read_curve;
    MaterialReader find_material;
    SpectraReader read_spectra;
    /// A picked colour's XYZ, by the scene's OpenColorIO config; empty: colours cannot be read here.
    std::function<Xyz(const Rgb& colour, const std::string& space, const Where& where, const ColourSettings& settings)>
        read_colour{};
    /// Looks for mechanisms that show what picks ask for, best first, at least one (see fit/find_mechanism.h); empty:
    /// such picks cannot be read here.
    std::function<std::vector<FoundMechanism>(const MechanismSearch& search, const Light& light)> find_mechanisms{};
};

/// What of a scene is wanted.
struct PlanRequest {
    /// Names of LUTs and swatches; empty: all. Names that the scene does not have are no error: another scene may.
    std::vector<std::string> only;
    bool all_materials = false;  ///< those too that no LUT and no swatch asks for
    bool strict = false;         ///< whether a picked colour that no band, film, ... has is an error
    bool any_thickness = false;  ///< whether layers may be so thick that no sampling of a LUT resolves their fringes
    /// Shared by plans that are made one after the other; null: the plan makes its own.
    std::shared_ptr<KnownBands> bands{};
    bool wants_pale_paths = false;  ///< whether SceneMaterial::pale_paths are looked for

    bool wants(const std::string& name) const;
};

/// Decides everything that a scene leaves open. After it only the disk can fail.
///
/// Every mistake of the user's is found here: unknown keys and names, wrong types, numbers out of range, picks that
/// contradict each other. Throws Error with file, line and column.
/// Materials that nothing asks for are not read at all, nor are the files that they name.
/// @param scene  the top table of a scene, includes resolved
Plan plan_scene(const Table& scene, const SceneFiles& files, const PlanRequest& request = {});

/// A scene that holds one LUT and nothing else, every default written out: what a file header carries so that the LUT
/// can be derived again. plan_scene() of it gives the same job, and this text again.
std::string scene_toml(const PlannedLut& lut);

}  // namespace nacre
