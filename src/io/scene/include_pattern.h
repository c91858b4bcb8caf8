#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nacre {

/// The files that `include = "pattern"` in a scene means.
///
/// A pattern with *, ? or [...] means all files that match, sorted by their paths, without the scene itself, unless
/// there is a file of exactly that name. Any other pattern means the file of that name, whether it exists or not.
/// @param scene  the file that includes; the pattern is relative to its folder
/// @return empty if nothing matches
std::vector<std::filesystem::path> included_files(const std::filesystem::path& scene, const std::string& pattern);

}  // namespace nacre
