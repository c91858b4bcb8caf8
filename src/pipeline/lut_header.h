#pragma once

#include "io/image/lut_file.h"
#include "nacre/accuracy/choose_lut.h"
#include "nacre/lut/colour_space.h"
#include "pipeline/baked_lut.h"

namespace nacre {

/// What the file of a baked LUT says about itself. Everything that the LUT can be derived from again is in it.
/// @param baked  measured; its header is not read
LutHeader lut_header(const ChosenLut& chosen, const ColourSource& source, const ColourSpace& space,
                     const BakedLut& baked);

}  // namespace nacre
