#pragma once

#include <string>
#include <vector>

#include "nacre/base/where.h"
#include "nacre/scene/edit_scene.h"
#include "nacre/scene/table.h"

namespace nacre {

/// A scene with other values: one row of [variants].
struct Variant {
    std::string name;
    Where where;
    std::vector<SceneEdit> edits;
};

/// The variants of a scene, in their order: the keys of [variants], or the rows of the CSV that `variants` names. Empty
/// if the scene has none.
///
/// Throws Error for names that no file can have, and for a CSV whose first column is not `name`.
/// @param scene  includes resolved
std::vector<Variant> read_variants(const Table& scene);

}  // namespace nacre
