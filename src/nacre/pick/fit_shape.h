#pragma once

#include <optional>
#include <vector>

#include "nacre/optics/palette.h"
#include "nacre/pick/picked_colour.h"

namespace nacre {

/// The shape with which the paper's material comes nearest to more picks than it can pass through.
struct ShapeFit {
    double shape = Palette::default_shape;  ///< p of (3.2.5), in [0, 1], four decimals
    std::vector<double> de00;               ///< by which the straight lines miss each pick, four decimals
};

/// Fits p of Y(theta) = p cos^2 + (1 - p) cos so that straight lines in Y (the paper's own model: one for the peak, the
/// width and the height; and for floor and flatness, if a pick has them) come nearest to all picks.
///
/// The distance is the sum of squares of CIEDE2000. For every p the lines are found by Levenberg and
/// Marquardt's method; p itself is scanned in twentieths and refined by golden-section search, in a few milliseconds.
/// No result where p makes no difference: with picks at fewer than three angles, and where all are equal or black.
/// @param picks  as of a palette
std::optional<ShapeFit> fit_shape(const std::vector<Pick>& picks, const LobeColour& colour_of);

}  // namespace nacre
