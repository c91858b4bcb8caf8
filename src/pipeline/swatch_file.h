#pragma once

#include <filesystem>
#include <string>

#include "nacre/lut/colour_space.h"
#include "nacre/scene/planned_swatch.h"

namespace nacre {

/// A swatch as the bytes of a PNG.
/// @param space    of the scene's LUTs
/// @param display  what the picture is for
std::string swatch_bytes(const PlannedSwatch& swatch, const ColourSpace& space, const ColourSpace& display,
                         const std::filesystem::path& font);

}  // namespace nacre
