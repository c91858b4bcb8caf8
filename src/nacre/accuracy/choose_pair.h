#pragma once

#include <array>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {

/// The LUTs of a material's reflectance and of its transmittance.
using ChosenPair = std::array<ChosenLut, 2>;

/// Chooses two LUTs that go together: of one size, format and sampling, and with the same effects, so that their sum is
/// white wherever the layers absorb nothing. Each has what it needs alone, or what the other needs more of. Both are
/// baked and measured, too: where one errs by more than was predicted, both are chosen again with more care.
/// @pre they differ in what is observed, and in their names
ChosenPair choose_pair(const std::array<PlannedLut, 2>& luts, const Encoding& encoding,
                       const AfterRow& after_step = {});

}  // namespace nacre
