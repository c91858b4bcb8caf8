#pragma once

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/cost/cost.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/encoding.h"

namespace nacre {

/// CIEDE2000 error of what a shader gets from the case's LUT, at any coordinate: the check that a bake makes of nacre's
/// own choice, made for any LUT. What the LUT is from the model is looked for everywhere, by a curve where the model's
/// colours take long; and the independent reference is asked at the points of measure().
double cost_error(const CostCase& cost, const Image<Rgb>& stored, const Encoding& encoding,
                  const AfterRow& after_step = {});

}  // namespace nacre
