#pragma once

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/job.h"

namespace nacre {

/// bake() for pictures, from a few percent of the colours if they are smooth: polynomials along rows and from row to
/// row, on parts that are halved until colours between their nodes agree.
///
/// Accuracy: 0.1 codes of an 8-bit sRGB picture of one row, 0.2 of more. What is narrower than 12 pixels, with nothing
/// wide beside it, may be missed.
/// @pre as of bake()
Image<Xyz> bake_smoothly(const Job& job);

}  // namespace nacre
