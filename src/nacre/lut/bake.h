#pragma once

#include <functional>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/job.h"
#include "nacre/shade/work.h"

namespace nacre {

/// Called after every row of a bake; what it throws ends the bake.
using AfterRow = std::function<void()>;

/// Every texel of a LUT: XYZ relative to D65 (after adaptation), Y = 1 for the perfect reflector.
///
/// Texel (i, j) is the value at coordinates (i / (width - 1), j / (height - 1)); the first row is the smallest y.
/// @param work  what it took is added to it
/// @pre the sampling of a job that samples spectra is decided (see accuracy/choose_sampling.h)
Image<Xyz> bake(const Job& job, const AfterRow& after_row = {}, Work* work = nullptr);

}  // namespace nacre
