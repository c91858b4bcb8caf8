#pragma once

#include <filesystem>
#include <span>
#include <vector>

namespace nacre {

/// Where fonts usually are: the system's folders and the user's own, on Linux, macOS and Windows. Some may not exist.
std::vector<std::filesystem::path> usual_font_folders();

/// A sans serif font with Greek letters and the degree sign, looked for in the folders and below them.
///
/// DejaVu Sans first, wherever it lies, then Liberation Sans, Noto Sans and what macOS and Windows bring along: the
/// same fonts give the same picture. OpenImageIO's own search looks one folder deep and knows other names, so it is not
/// used.
/// @throws IoError naming the package to install
std::filesystem::path find_font(std::span<const std::filesystem::path> folders);
std::filesystem::path find_font();

}  // namespace nacre
