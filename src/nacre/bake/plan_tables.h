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

inline constexpr int default_lut_width = 256;
inline constexpr int default_lut_height = 64;

/// The material that the key `material` names, or the only one that there is.
const Material& material_of(const Table& table, const std::vector<Material>& materials);

/// One [lut.NAME]. @param size  of [accuracy]: what holds where the LUT does not say
PlannedLut read_lut(const Table& table, const Table::Entry& entry, const std::vector<Material>& materials,
                    const std::shared_ptr<const Light>& light, const LutSize& size);

/// One [swatch.NAME]. @param plan  with its materials, LUTs and light
PlannedSwatch read_swatch(const Table& table, const Table::Entry& entry, const Plan& plan);

}  // namespace nacre
