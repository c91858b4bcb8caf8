#pragma once

#include "nacre/base/sampled_curve.h"
#include "nacre/colour/observer.h"
#include "nacre/colour/tristimulus.h"

namespace nacre {

/// Whether a lamp has nodes closer than one nanometre in a range: then its values at whole nanometres say too little.
bool has_fine_lines(const SampledCurve& illuminant, int first_nm, int last_nm);

/// The weights of a lamp, not yet normalised, and their cells_per_nm.
///
/// Of a lamp without fine lines they are its power times the colour matching functions at every whole nanometre. A lamp
/// with fine lines is linear between its own nodes, and the colour matching functions are linear between whole
/// nanometres. Its weights are the piecewise linear function over the cells that has the same integral as the product
/// of the two against every function that is linear within the cells (the L2 projection). A spectrum R that is straight
/// within every cell is integrated exactly; else the error is below |R''| / (12 cells_per_nm^2) of the light.
/// @pre first_nm and last_nm of the weights are set, and the illuminant covers them
void add_lamp_weights(Observer observer, const SampledCurve& illuminant, TristimulusWeights& weights);

}  // namespace nacre
