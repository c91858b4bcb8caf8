#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/optics/refractive_index.h"
#include "nacre/scene/lists.h"

namespace nacre {

/// The names of the shipped materials, in alphabetical order: the files of configs/materials, which are compiled in.
std::vector<std::string> shipped_material_names();

/// The same with half a line about each.
std::vector<ListedName> shipped_material_list();

/// A material of that list, parsed anew by every call; null for any other name.
std::shared_ptr<const IndexCurve> shipped_material(std::string_view name);

/// The material that a scene names: a file if the name ends in .yml, .yaml or .csv, otherwise a shipped material.
///
/// Throws Error for an unknown name, a file that cannot be read (`WHERE: file: why not`), and a mistake in a file
/// (`file:line: ...`, see material_file.h).
/// @param folder  what a file is relative to; empty: the working folder
/// @param where   the place in the scene, for messages
std::shared_ptr<const IndexCurve> find_material(const std::string& name, const std::string& folder,
                                                const std::string& where);

}  // namespace nacre
