#pragma once

#include <vector>

#include "cli/console.h"
#include "cli/options.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// --preview and --no-preview.
struct PreviewFlags {
    bool all = false;
    bool none = false;
};
std::vector<Option> preview_options(PreviewFlags& flags);

/// What else decides which LUTs get a preview.
enum class PreviewRule {
    if_few,   ///< of a bake: all LUTs, unless they are more than `most_automatic_previews`
    if_bare,  ///< of pictures: LUTs that --only names, and those of scenes without swatches
};

/// Notes in the scenes which LUTs get a preview. Throws Error if two files would have one name.
/// @param has_only  whether --only is given
void choose_previews(std::vector<LoadedScene>& scenes, const PreviewFlags& flags, PreviewRule rule, bool has_only);

/// Opens the displays that previews need. One that is missing is a warning if nobody asked for them, and then there are
/// none; throws Error if somebody did.
void open_displays_of_previews(std::vector<LoadedScene>& scenes, Console& console);

/// Chosen: a preview takes some tenths of a second, so a bake of so many takes some seconds longer.
inline constexpr std::size_t most_automatic_previews = 32;

}  // namespace nacre
