#pragma once

#include <filesystem>
#include <span>
#include <vector>

namespace nacre {

/// The usual font folders of the system and the user, on Linux, macOS and Windows. Some may not exist.
std::vector<std::filesystem::path> usual_font_folders();

/// A sans serif font with Greek letters and the degree sign, looked for in the folders and below them.
///
/// DejaVu Sans comes first, then Liberation Sans, Noto Sans and the fonts of macOS and Windows: the same fonts give the
/// same picture. The search of OpenImageIO is one folder deep and knows other names, so it is not used.
/// @throws IoError naming the package to install
std::filesystem::path find_font(std::span<const std::filesystem::path> folders);
std::filesystem::path find_font();

}  // namespace nacre
