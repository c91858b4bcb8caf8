#pragma once

#include <filesystem>
#include <string>

#include "io/ocio/colour_transform.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {

/// A swatch as the bytes of a PNG.
/// @param space    of the scene's LUTs
/// @param display  what the picture is for
std::string swatch_bytes(const PlannedSwatch& swatch, const ColourTransform& space, const ColourTransform& display,
                         const std::filesystem::path& font);

}  // namespace nacre
