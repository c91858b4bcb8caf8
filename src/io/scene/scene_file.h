#pragma once

#include <string>

#include "nacre/scene/plan.h"
#include "nacre/scene/table.h"

namespace nacre {

/// Reads a scene file (TOML) and everything it includes, every value with file, line and column.
///
/// Limits, each with its own message: 64 MB per file, 16 levels of include, 64 levels of nesting. Throws Error for text
/// that is not TOML, IoError for a file that cannot be read.
/// @param path  as the user gave it; messages show it so
Table read_scene_file(const std::string& path);

/// The same for text in memory; `include` is not allowed in it.
/// @param name  what messages call it
Table parse_scene(const std::string& text, const std::string& name);

/// Reads tables of spectral power and materials that a scene names, relative to the scene's folder.
SceneFiles scene_files();

}  // namespace nacre
