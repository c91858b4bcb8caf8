#pragma once

#include <memory>

#include "nacre/lut/colour_spaces.h"

namespace nacre {

/// The linear spaces of nacre's own OpenColorIO config, and srgb_rec709 in which it picks colours, without OpenColorIO:
/// the same names, matrices and curve, so that a scene means the same in the page as in the program.
/// @throws Error if a scene names another config
std::shared_ptr<const ColourSpaces> page_spaces(const ColourConfigChoice& choice);

}  // namespace nacre
