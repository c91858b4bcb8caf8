#pragma once

#include <memory>

#include "nacre/optics/refractive_index.h"

namespace nacre {

/// The largest component of f0 that a scene may give: k is 2000 there, and infinite at 1.
inline constexpr double most_f0 = 0.999999;

/// The n + ik that a metal of this colour has at every whole nanometre of the CIE's tables, linear between them.
///
/// The reflectance R at normal incidence from vacuum is the smooth one whose colour under D65, adapted to the white of
/// Rec.709 and seen by the CIE 1931 observer, is f0 (smooth_rgb.h), whatever the light of the scene. The edge tint g is
/// the smooth curve of that colour, and metal_index(R, g) the index. Without a tint it is metal_index(R), n = 1: the
/// shipped metals have n from 0.05 to 3 in the visible, and aluminium about 1; it gives black an index of 1, too.
///
/// Accuracy: every component of the colour within 1e-9 (`ColouredMetal.HasTheColourThatItWasMadeFor`).
std::shared_ptr<const IndexCurve> coloured_metal(const MetalColour& colour);

/// The same metal with an f0 whose largest component is `level`, in the same proportions; of black the grey.
MetalColour with_f0(const MetalColour& colour, double level);

}  // namespace nacre
