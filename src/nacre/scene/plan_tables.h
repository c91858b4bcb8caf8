#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nacre/lut/planned_lut.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {

// The parts of plan_scene(): one function per kind of table, each of which returns its part of the plan. Mistakes are
// noted in the table where they are (mistakes.cpp), and a part that has one is missing from what is returned.

/// Names become file names on every system that an artist's files pass through.
/// @param parent  the table that holds the name, for the message
void check_name(const std::string& name, const Table& parent, const Where& where);

/// `size`: a number, or [width, height] where there are two axes. Powers of two, 2 ... largest_lut_size;
/// one number up to widest_lut_size.
struct LutSize {
    std::optional<int> width;
    std::optional<int> height;
};
LutSize read_lut_size(const Table& table);

/// [accuracy]: what holds for every LUT that does not say otherwise.
struct AccuracySettings {
    std::optional<double> max_de00;
    std::optional<int> wavelengths;
    SamplingCounts sampling;
    bool may_drop_effects = true;
    EffectSet without;
    LutSize size;
    std::vector<std::string> warnings;  ///< of keys that have moved, with file, line and column
};
/// @param table  null: nothing is said
AccuracySettings read_accuracy(const Table* table);

/// The request of a LUT that says nothing itself.
AccuracyRequest default_request(const AccuracySettings& accuracy, bool has_y);

/// Gives a LUT its request, and what the request requests.
void take_request(const AccuracyRequest& request, PlannedLut& lut);

/// [light], and `wavelengths` of [accuracy]. The light has some power where it is sampled, and a white that the
/// adaptation can start from. Null if [light] has mistakes.
std::shared_ptr<const Light> plan_light(const Table& scene, const AccuracySettings& accuracy,
                                        const CurveReader& read_curve);

/// `space` and `gamut`, of [colour] or of a LUT. What the table does not say stays as it is.
void read_lut_colour(const Table& table, LutColour& colour);

/// [colour].
ColourSettings plan_colour(const Table& scene);

/// Notes it if a material's layers are so thick that no sampling of wavelengths resolves their fringes.
/// @param table  the material's or the LUT's
void check_fringes(const Table& table, const Mechanism& mechanism, const LightSettings& light);

/// [material]: the materials of a scene. Each is read and checked once, when it is asked for first.
class Materials {
public:
    /// @param scene  has to outlive this
    /// @param light  null if it has mistakes: then nothing is checked that needs it
    /// @param any_thickness  see PlanRequest
    Materials(const Table& scene, SceneContext context, std::shared_ptr<const Light> light, bool any_thickness);
    Materials(const Materials&) = delete;
    Materials& operator=(const Materials&) = delete;

    const std::vector<std::string>& names() const { return names_; }
    /// Null if it has mistakes. @pre the name is one of names()
    const SceneMaterial* named(const std::string& name);
    /// Those that were asked for and have no mistakes, in the scene's order.
    std::vector<SceneMaterial> read() const;
    /// Of these, what picks led to, in the order in which they were asked for.
    const std::vector<MaterialSearch>& searches() const { return searches_; }

private:
    std::optional<SceneMaterial> read_material(const std::string& name);

    const Table* table_;  // null: [material] is missing or not a table
    SceneContext context_;
    std::shared_ptr<const Light> light_;
    bool any_thickness_;
    std::vector<std::string> names_;
    std::map<std::string, std::optional<SceneMaterial>> read_;
    std::vector<MaterialSearch> searches_;
};

/// The material that the key `material` names, or the only one that there is. Null if there is no such material or it
/// has mistakes.
const SceneMaterial* material_of(const Table& table, Materials& materials);

/// What LUTs and swatches refer to.
struct SceneParts {
    const Table& scene;
    AccuracySettings accuracy;
    ColourSettings colour;
    std::shared_ptr<const Light> light;  ///< null if it has mistakes
    Materials& materials;
    bool any_thickness = false;  ///< see PlanRequest
};

/// One [lut.NAME]; nothing if it or its material has mistakes. With `quantity` = "both" it is that of the reflectance,
/// and is_of_pair.
std::optional<PlannedLut> read_lut(const Table& table, const Table::Entry& entry, const SceneParts& parts);

/// [lut], or one LUT per material in a scene without that table.
struct PlannedLuts {
    std::vector<std::string> names;  ///< of all that the scene has
    std::vector<PlannedLut> luts;    ///< those that are wanted
};
PlannedLuts plan_luts(const SceneParts& parts, const PlanRequest& request);

/// One LUT by its name, whether it is wanted or not.
struct NamedLut {
    bool exists = false;
    std::optional<PlannedLut> lut;  ///< nothing if it or its material has mistakes
};
NamedLut lut_named(const SceneParts& parts, const std::string& name);

/// [swatch].
struct PlannedSwatches {
    std::vector<std::string> names;  ///< of all that the scene has
    std::vector<PlannedSwatch> swatches;
};
/// @param lut_names  for the message about an unknown one
PlannedSwatches plan_swatches(const SceneParts& parts, const PlanRequest& request,
                              const std::vector<std::string>& lut_names);

/// What a plan allows although it is hardly meant.
std::vector<std::string> warnings_of(const Plan& plan);

/// The picked colours that their material does not show: those that were searched for, or, `if_given`, also those of
/// materials whose numbers are all given.
std::vector<Mistake> unmatched_pick_mistakes(const Plan& plan, bool if_given);

}  // namespace nacre
