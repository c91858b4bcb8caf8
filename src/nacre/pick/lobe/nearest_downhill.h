#pragma once

#include <limits>

#include "nacre/colour/difference.h"
#include "nacre/pick/lobe/lobe_colours.h"

namespace nacre {

/// A lobe of any height, by the cube root of it: lightness is nearly straight in that.
struct DimmedLobe {
    static constexpr double least_root = 0.01;  ///< what searches stop at

    LobePlace place;
    double root = 1.0;    ///< in [0, 1]
    double square = 0.0;  ///< of CIEDE2000 to the colour that was asked for, to single precision

    double height() const { return root * root * root; }
};

/// From the opposite hue, in units of CIELAB, so that neither rounded numbers nor single precision change the side.
inline constexpr double opposite_hue_margin = 0.01;

/// Cube root of the Y that has a lightness; 0 below black.
double root_of_lightness(double lightness);

/// Walks downhill in CIEDE2000 from a lobe: a quadratic model of the squared difference in peak, width and root of the
/// height, made anew at every step, says where to go. Where the hue is nearly opposite to the colour's, CIEDE2000
/// jumps: there both sides are walked. Accuracy: 0.1 % of the difference, or 0.001, in valleys that are not too bent.
/// @param least  squared difference of the best that is known; what hardly falls below it is given up
/// @param margin  to keep from the opposite hue, in units of CIELAB. Fast colours are a little off: what ends there may
/// be nearer to it by exact ones
DimmedLobe nearest_downhill(const LobeColours& colours, const Lab& target, DimmedLobe start,
                            double least = std::numeric_limits<double>::infinity(),
                            double margin = opposite_hue_margin);

/// The lobe of a place that is as light as the target, as far as a surface goes.
DimmedLobe with_lightness(const LobeColours& colours, const Lab& target, LobePlace place);

}  // namespace nacre
