#pragma once

#include "pipeline/decide.h"

namespace nacre {

/// Seconds that baking a chosen LUT will take on this machine and one thread: computed, converted, measured, encoded;
/// not written.
///
/// Found by doing it in memory: all of a LUT of up to 32768 texels, some rows of a larger one. So it costs a few
/// milliseconds, and holds for the machine that it ran on.
double rehearse(const DecidedLut& lut);

}  // namespace nacre
