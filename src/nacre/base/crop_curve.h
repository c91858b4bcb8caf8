#pragma once

#include "nacre/base/sampled_curve.h"

namespace nacre {

/// Drops the nodes outside a range, except the neighbours from which its ends are interpolated. A curve that would keep
/// fewer than two nodes stays as it is.
void crop_curve(SampledCurve& curve, double first_nm, double last_nm);

}  // namespace nacre
