#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nacre/lut/planned_lut.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {

// The parts of plan_scene(): one function per kind of table. All throw Error for what is wrong in it.

/// Names become file names on every system that an artist's files pass through.
/// @param parent  the table that holds the name, for the message
void check_name(const std::string& name, const Table& parent, const Where& where);

/// `size`: a number, or [width, height] where there are two axes. Powers of two, 2 ... largest_lut_size.
struct LutSize {
    std::optional<int> width;
    std::optional<int> height;
};
LutSize read_lut_size(const Table& table);

/// [accuracy]: what holds for every LUT that does not say otherwise.
struct AccuracySettings {
    std::optional<double> max_de00;
    std::optional<int> wavelengths;
    std::optional<Integral> integral;
    std::optional<NodeCounts> nodes;
    std::optional<int> realisations;
    QuadratureWish points;
    bool may_drop_effects = true;
    EffectSet without;
    LutSize size;
};
/// @param table  null: nothing is said
AccuracySettings read_accuracy(const Table* table);

/// The wish of a LUT that says nothing itself.
AccuracyWish default_wish(const AccuracySettings& accuracy, bool has_y);

/// Gives a LUT its wish, and what the wish insists on.
void take_wish(const AccuracyWish& wish, PlannedLut& lut);

/// The materials of a scene, each read when it is asked for.
class Materials {
public:
    using Check = std::function<void(const Table&, const Mechanism&)>;
    /// @param table    of all materials; has to outlive this
    /// @param check    called for every one that is read; throws Error
    Materials(const Table& table, SceneContext context, Check check);
    Materials(const Materials&) = delete;
    Materials& operator=(const Materials&) = delete;

    const std::vector<std::string>& names() const { return names_; }
    const SceneMaterial& named(const std::string& name);
    /// Those that were asked for, in the scene's order.
    std::vector<SceneMaterial> read() const;
    /// Of these, what picks led to.
    const std::vector<MaterialSearch>& searches() const { return searches_; }

private:
    const Table& table_;
    SceneContext context_;
    Check check_;
    std::vector<PickedColour> picked_;   // of the material that is being read
    std::optional<ShapeFit> shape_fit_;  // likewise
    std::vector<MaterialSearch> searches_;
    std::vector<std::string> names_;
    std::map<std::string, SceneMaterial> read_;
};

/// The material that the key `material` names, or the only one that there is.
const SceneMaterial& material_of(const Table& table, Materials& materials);

/// One [lut.NAME].
PlannedLut read_lut(const Table& table, const Table::Entry& entry, Materials& materials,
                    const std::shared_ptr<const Light>& light, const AccuracySettings& accuracy);

/// How a swatch asks for the LUT that it shows: null if there is none of that name; then `known` has those that there
/// are.
using LutFinder = std::function<const PlannedLut*(const std::string& name, std::vector<std::string>& known)>;

/// One [swatch.NAME].
/// @param find_lut  a LUT by its name, null if there is none
PlannedSwatch read_swatch(const Table& table, const Table::Entry& entry, Materials& materials,
                          const std::shared_ptr<const Light>& light, const LutFinder& find_lut);

}  // namespace nacre
