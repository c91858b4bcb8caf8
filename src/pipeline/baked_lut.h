#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/image/lut_file.h"
#include "io/ocio/colour_config.h"
#include "nacre/accuracy/measure.h"
#include "nacre/accuracy/settle.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/gamut.h"
#include "nacre/scene/plan.h"

namespace nacre {

/// The version of this program: "0.1.0".
std::string_view nacre_version();

/// A LUT's pixels in the target space, and what its file will say of itself.
struct BakedLut {
    Image<Rgb> image;  ///< as stored: every component is one of the format's numbers
    LutHeader header;
    std::optional<double>
        reached;        ///< largest error found, rounded up to three digits; nothing where it cannot be known
    Work work;          ///< baking and measuring; settling not counted
    GamutReport gamut;  ///< before [colour] gamut was applied
    GamutReport left;   ///< after it, of the numbers as stored
    std::vector<PickedColour> picked;  ///< of the material's picks those that were given as colours
    ClampBounds clamped;               ///< beyond these angles the picks ask for what no surface can do
};

/// Where the target space comes from, for the header.
struct ColourSource {
    std::string config;  ///< description, without a folder
    std::string hash;
};

/// How LUTs are encoded in a space under a gamut rule. Refers to the transform, which has to outlive it.
/// @throws Error if the rule needs a linear space and this is none
Encoding lut_encoding(const ColourTransform& transform, Gamut gamut);

/// XYZ of every texel, through the colour transform and the gamut's rule, measured, with its header.
/// @param plan  of the scene that the LUT is from: its colour settings, and what picks became
/// Throws Error if the space or the format cannot hold the colours.
BakedLut bake_lut(const SettledLut& lut, const Plan& plan, const ColourSource& source, const ColourTransform& transform,
                  const AfterRow& after_row = {});

/// A pick that was given as a colour, for manifests and --json.
nlohmann::ordered_json picked_json(const PickedColour& picked);

/// The manifest: JSON for tools, ending in a newline. No date, host or path.
std::string manifest_json(const SettledLut& lut, const BakedLut& baked);

}  // namespace nacre
