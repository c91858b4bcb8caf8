#pragma once

#include <filesystem>
#include <string>

#include "nacre/scene/plan.h"
#include "nacre/scene/table.h"

namespace nacre {

/// Reads a scene file (TOML) and everything it includes, every value with file, line and column.
///
/// A key that two files give is a mistake, unless one of them is included with `override = true`: then the other
/// counts. Limits, each with its own message: 64 MB per file, 16 levels of include, 64 levels of nesting. Throws Error
/// for text that is not TOML, IoError for a file that cannot be read.
/// @param path  as the user gave it; messages show it so
Table read_scene_file(const std::string& path);

/// The same for text in memory; `include` is not allowed in it.
/// @param name  what messages call it
Table parse_scene(const std::string& text, const std::string& name);

/// The folder that the names of files in a scene are relative to: that of the file in which they stand. Of a value that
/// has no line, because it is from the command line, the working directory.
std::filesystem::path folder_of(const Where& where);

/// Reads tables of spectral power and materials that a scene names, relative to the scene's folder.
SceneFiles scene_files();

}  // namespace nacre
