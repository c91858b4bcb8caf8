#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/image/lut_file.h"
#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/measure.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/colour_space.h"
#include "nacre/lut/encoding.h"
#include "nacre/lut/gamut.h"
#include "nacre/optics/palette.h"
#include "nacre/pick/picked_colour.h"
#include "nacre/scene/plan.h"
#include "nacre/shade/work.h"

namespace nacre {

/// A LUT's pixels in the target space, and what its file will say of itself.
struct BakedLut {
    Image<Rgb> image;  ///< as stored: every component is one of the format's numbers
    LutHeader header;
    std::optional<double>
        reached;  ///< what it errs by at most, rounded up to three digits; nothing where it cannot be known
    std::optional<Measured> measured;  ///< the same unrounded, and where it comes from
    Work work;                         ///< baking and measuring, without choosing
    double computing_seconds = 0.0;    ///< of one thread: the colours of its texels
    double measuring_seconds = 0.0;    ///< likewise: comparing them with the independent reference
    GamutReport gamut;                 ///< before [colour] gamut was applied
    GamutReport left;                  ///< after it, of the numbers as stored
    /// Where negative components are kept: what clipping them would change. Nothing if it cannot be known.
    std::optional<ClippingLoss> clipping;
    std::vector<PickedColour> picked;  ///< of the material's picks those that were given as colours
    ClampBounds clamped;               ///< beyond these angles the picks ask for what no surface can do
};

/// Where the target space comes from, for the header.
struct ColourSource {
    std::string config;  ///< description, without a folder
    std::string hash;
    std::string name{};  ///< the config in a word, for lines about a LUT
};

/// How LUTs are encoded in a space under a gamut rule. Refers to the space, which has to outlive it.
/// @throws Error if the rule needs a linear space and this is none
Encoding lut_encoding(const ColourSpace& space, Gamut gamut);

/// XYZ of every texel, through the colour space and the gamut's rule, measured, with its header.
/// @param plan  of the scene that the LUT is from: what picks became
/// Throws Error if the space or the format cannot hold the colours.
BakedLut bake_lut(const ChosenLut& lut, const Plan& plan, const ColourSource& source, const ColourSpace& space,
                  const AfterRow& after_row = {});

}  // namespace nacre
