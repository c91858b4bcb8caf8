#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/colour_config.h"
#include "io/lut_file.h"
#include "nacre/bake/bake.h"
#include "nacre/bake/gamut.h"
#include "nacre/bake/plan.h"

namespace nacre {

/// The version of this program: "0.1.0".
std::string_view nacre_version();

/// A LUT's pixels in the target space, and what its file will say of itself.
struct BakedLut {
    Image<Rgb> image;
    LutHeader header;
    GamutReport gamut;    ///< before [colour] gamut was applied
    ClampBounds clamped;  ///< beyond these angles the picks ask for what no surface can do
};

/// Where the target space comes from, for the header.
struct ColourSource {
    std::string config;  ///< description, without a folder
    std::string hash;
};

/// XYZ of every texel, through the colour transform and the gamut's rule, with its header.
/// Throws Error if the space cannot hold the colours (not finite).
BakedLut bake_lut(const PlannedLut& lut, const ColourSettings& colour, const ColourSource& source,
                  const ColourTransform& transform, const AfterRow& after_row = {});

/// The manifest: JSON for tools, ending in a newline. No date, host or path.
std::string manifest_json(const PlannedLut& lut, const BakedLut& baked);

}  // namespace nacre
