#pragma once

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

/// Linear light in the primaries of sRGB and Rec.709 (IEC 61966-2-1); may be negative.
Rgb linear_rec709(Xyz colour);

/// The colour that a picture for an sRGB display shows instead of one that sRGB lacks.
///
/// The curve of the ACES Reference Gamut Compression (Academy TB-2021-001; here in Rec.709 and without a limit): each
/// component's distance from the largest one is compressed so that it stays below 1. The largest component is kept, and
/// so is every colour that lies 10 % or more inside the gamut. Clipping instead turns all greens from 510 to 550 nm
/// into one flat band. GamutCompression, which a LUT may ask for, keeps hue and lightness; but then chroma follows the
/// gamut's edge, and a rainbow has bright lines at the three primaries and a dull gap from 465 to 495 nm. This is for
/// pictures, not for LUTs.
Xyz fit_to_srgb(Xyz colour);
Image<Xyz> fit_to_srgb(const Image<Xyz>& image);

}  // namespace nacre
