#pragma once

#include <string>

#include "cli/console.h"
#include "cli/pick_scene.h"

namespace nacre {

/// Throws Error for a name of a swatch that is no PNG's.
void check_swatch_name(const PickOptions& options);

/// Writes the first swatch of a scene that `nacre pick` prints, to options.swatch. Throws IoError where it cannot be
/// written.
void write_picked_swatch(const PickOptions& options, const std::string& scene, Console& console);

}  // namespace nacre
