#pragma once

#include "cli/console.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// What `nacre plan` says of a scene below its table: what picked colours became, the shapes that were fitted, beyond
/// which angles picks are clamped, what measurements cover, and which pictures there are.
void note_scene(const LoadedScene& scene, Console& console);

}  // namespace nacre
