#include "io/image/font.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "nacre/base/error.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 8> font_files{
    "DejaVuSans.ttf",
    "LiberationSans-Regular.ttf",
    "NotoSans-Regular.ttf",
    "Arial Unicode.ttf",
    "Arial.ttf",
    "arial.ttf",
    "segoeui.ttf",
    "Helvetica.ttc",
};

// Folders that cannot be read are skipped. Links to folders are not followed, because they may form cycles.
template <typename Visit>
void for_each_file(const fs::path& folder, const Visit& visit) {
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    while (!error && entry != fs::recursive_directory_iterator()) {
        std::error_code not_a_file;
        if (entry->is_regular_file(not_a_file)) visit(entry->path());
        entry.increment(error);
    }
}

}  // namespace

std::vector<fs::path> usual_font_folders() {
    std::vector<fs::path> folders{"/usr/share/fonts", "/usr/local/share/fonts", "/opt/local/share/fonts",
                                  "/Library/Fonts",   "/System/Library/Fonts",  "C:/Windows/Fonts"};
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        for (const char* below : {".fonts", ".local/share/fonts", "Library/Fonts"}) {
            folders.push_back(fs::path(home) / below);
        }
    }
    return folders;
}

fs::path find_font(std::span<const fs::path> folders) {
    std::size_t best = font_files.size();
    fs::path found;
    for (const fs::path& folder : folders) {
        for_each_file(folder, [&](const fs::path& file) {
            const auto known = std::find(font_files.begin(), font_files.end(), file.filename().string());
            const auto rank = static_cast<std::size_t>(known - font_files.begin());
            // The path decides between equal names, because a folder lists its files in no defined order.
            if (rank < best || (rank == best && rank < font_files.size() && file < found)) {
                best = rank;
                found = file;
            }
        });
    }
    if (found.empty()) {
        throw IoError(
            "pictures need a font, and nacre found none; install the Debian package fonts-dejavu-core "
            "(DejaVuSans.ttf), or Liberation Sans or Noto Sans");
    }
    return found;
}

fs::path find_font() {
    const std::vector<fs::path> folders = usual_font_folders();
    return find_font(folders);
}

}  // namespace nacre
