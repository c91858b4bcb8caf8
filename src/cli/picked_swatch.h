#pragma once

#include <string>

#include "cli/console.h"
#include "cli/pick_words.h"

namespace nacre {

/// Throws Error for the name of a swatch that does not end in .png.
void check_swatch_name(const PickOptions& options);

/// Writes the first swatch of a scene that `nacre pick` prints, to options.swatch. Throws IoError where it cannot be
/// written.
void write_picked_swatch(const PickOptions& options, const std::string& scene, Console& console);

}  // namespace nacre
