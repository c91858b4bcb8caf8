#pragma once

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/pick/band/exact_bands.h"

namespace nacre {

/// The colour that a surface shows in place of a picked one.
struct ShownColour {
    Xyz colour;              ///< relative to D65
    double luminance = 1.0;  ///< share of the picked colour's that is left, in [0, 1]
    double chroma = 1.0;     ///< share of the picked colour's Oklab chroma / lightness that is left, in [0, 1]

    bool is_as_picked() const { return luminance == 1.0 && chroma == 1.0; }
};

/// The picked colour, if a reflectance can have it. Else one of the same hue (of Oklab).
///
/// A colour that is too bright keeps its chromaticity and gets the highest luminance that there is. Outside the
/// spectral locus it first moves towards white: as the brightest colours at the locus are black, chroma and lightness
/// give way by the same share, at equal Oklab hue.
/// @param colour  relative to D65, Y = 1 for the perfect reflector; finite
ShownColour shown_colour(const ExactBands& bands, const Light& light, const Xyz& colour);

}  // namespace nacre
