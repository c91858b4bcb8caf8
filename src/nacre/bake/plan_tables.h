#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nacre/bake/plan.h"

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
    LutSize size;
};
/// @param table  null: nothing is said
AccuracySettings read_accuracy(const Table* table);

/// The wish of a LUT that says nothing itself.
AccuracyWish default_wish(const AccuracySettings& accuracy, bool has_y);

/// Gives a LUT its wish, and what the wish insists on.
void take_wish(const AccuracyWish& wish, PlannedLut& lut);

/// The material that the key `material` names, or the only one that there is.
const Material& material_of(const Table& table, const std::vector<Material>& materials);

/// One [lut.NAME].
PlannedLut read_lut(const Table& table, const Table::Entry& entry, const std::vector<Material>& materials,
                    const std::shared_ptr<const Light>& light, const AccuracySettings& accuracy);

/// One [swatch.NAME]. @param plan  with its materials, LUTs and light
PlannedSwatch read_swatch(const Table& table, const Table::Entry& entry, const Plan& plan);

}  // namespace nacre
