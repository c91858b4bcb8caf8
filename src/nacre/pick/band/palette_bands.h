#pragma once

#include <optional>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/optics/lobe.h"
#include "nacre/pick/band/exact_bands.h"

namespace nacre {

/// One pick of a palette: a colour that a reflectance can have (see shown_colour()), or a band that is given.
struct ColourOrBand {
    double angle_deg = 0.0;
    std::optional<Xyz> colour;  ///< relative to D65
    Lobe band;                  ///< if there is no colour
};

/// The bands of a palette's picks; each has exactly its pick's colour.
///
/// One pick alone takes, of all bands that have its colour, one with floor 0, else a notch with height 0; of these the
/// one with the least flatness, then the greatest width. Of several picks the bands are chosen together so that
///
///     the length of the path in Oklab between neighbours, and per pick
///     + 0.3 (floor of a band, height of a notch) + 0.05 flatness + 0.03 if it is a notch, and per pair of neighbours
///     + 0.02 per 100 nm that the peak moves + 0.08 per 100 nm that it rises with the angle
///
/// is least, among bands with several floors each (dynamic programming over the picks in the order of their angles).
/// Black and grey say nothing about peak and width: they take those of a neighbour.
/// @return a band per pick, in the order of the picks; those of colours rounded to 1e-5 nm and 1e-8
std::vector<Lobe> palette_bands(const ExactBands& bands, const Light& light, const std::vector<ColourOrBand>& picks);

}  // namespace nacre
