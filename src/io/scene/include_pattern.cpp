#include "io/scene/include_pattern.h"

#include <glob.h>

#include <algorithm>
#include <cstddef>
#include <system_error>

namespace nacre {
namespace {

constexpr const char* wildcards = "*?[";

// The folder of a scene is a name, whatever its letters are.
std::string escaped(const std::string& name) {
    std::string text;
    for (const char c : name) {
        if (std::string(wildcards).find(c) != std::string::npos || c == '\\') text += '\\';
        text += c;
    }
    return text;
}

std::vector<std::filesystem::path> matches(const std::string& pattern) {
    glob_t found{};
    std::vector<std::filesystem::path> files;
    if (glob(pattern.c_str(), 0, nullptr, &found) == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    globfree(&found);
    return files;
}

}  // namespace

std::vector<std::filesystem::path> included_files(const std::filesystem::path& scene, const std::string& pattern) {
    const std::filesystem::path folder = scene.parent_path();
    std::error_code ignored;
    if (pattern.find_first_of(wildcards) == std::string::npos || std::filesystem::exists(folder / pattern, ignored))
        return {folder / pattern};
    std::vector<std::filesystem::path> files =
        matches((std::filesystem::path(escaped(folder.string())) / pattern).string());
    std::erase_if(files, [&](const auto& file) { return std::filesystem::equivalent(file, scene, ignored); });
    // In the order of their bytes, whatever the locale.
    std::sort(files.begin(), files.end(),
              [](const auto& one, const auto& other) { return one.native() < other.native(); });
    return files;
}

}  // namespace nacre
