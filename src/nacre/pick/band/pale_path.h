#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/optics/palette.h"
#include "nacre/pick/band/palette_bands.h"
#include "nacre/pick/picked_colour.h"

namespace nacre {

/// Two neighbouring picks between which a palette loses much of its chroma, and a pick between them.
struct PalePath {
    std::size_t from = 0;  ///< picks of the palette, in the order of their angles
    std::size_t to = 0;
    double chroma = 1.0;  ///< the least on the way, as a share of the paler pick's (in Oklab)
    double middle_deg = 0.0;
    /// Relative to D65: halfway in lightness and chroma, and in hue by the shorter way; as far as sRGB has it.
    Xyz middle;
    bool middle_helps = false;  ///< whether bands lead there and on; the way from a band to a notch is always grey
};

/// The paths of a palette on which less than two fifths of the chroma are left. Grey picks have none to lose.
std::vector<PalePath> pale_paths(const Palette& palette, const LobeColour& colour_of);

/// The same, with `middle_helps` found out by a palette that has the middle pick too.
/// @param picks  of the palette
/// @param bands  as palette_bands()
std::vector<PalePath> pale_paths_with_advice(
    const Palette& palette, const std::vector<ColourOrBand>& picks, const LobeColour& colour_of,
    const std::function<std::vector<Lobe>(const std::vector<ColourOrBand>&)>& bands);

/// `"#2060d0@30"`, as `nacre pick` takes it.
std::string middle_pick_text(const PalePath& path);

/// "between 0 and 60 deg the colour passes through grey (9 % of the chroma is left); the pick "#8d8600@30" between them
/// leads through other hues"
std::string pale_path_text(const PalePath& path, const Palette& palette);

}  // namespace nacre
