#pragma once

#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/find_lut.h"

namespace nacre {

/// What was found, with the share that each source has in its error and, if the bound is not kept, the limiting factor.
/// @param work  what finding it took; the result's includes what explaining takes
ChosenLut explain_lut(const LutSearch& search, FoundLut found, Work work);

}  // namespace nacre
