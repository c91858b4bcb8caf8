#pragma once

#include <string>

#include "cli/console.h"
#include "cli/pick_scene.h"

namespace nacre {

/// Writes the first swatch of a scene that `nacre pick` prints, to options.swatch. Throws Error for a name that is no
/// PNG's, IoError where it cannot be written.
void write_picked_swatch(const PickOptions& options, const std::string& scene, Console& console);

}  // namespace nacre
