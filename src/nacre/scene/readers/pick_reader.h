#pragma once

#include <functional>
#include <optional>
#include <string>

#include "nacre/base/where.h"
#include "nacre/colour/colour_types.h"
#include "nacre/optics/measured_spectra.h"
#include "nacre/pick/picked_colour.h"
#include "nacre/scene/table.h"

namespace nacre {

/// How the core asks for a colour's XYZ, relative to D65 and Y = 1 for the perfect reflector.
/// @param space  of the scene's OpenColorIO config; empty: its role color_picking
/// Throws Error with `where`.
using ColourReader = std::function<Xyz(const Rgb& colour, const std::string& space, const Where& where)>;

/// The lobe of a colour under the scene's light.
using LobeReader = std::function<LobeMatch(const Xyz& colour)>;

/// The colour of measured spectra at an angle, relative to D65.
using MeasuredColourReader = std::function<Xyz(const MeasuredSpectra& spectra, double angle_deg)>;

/// What it takes to read picks that are colours.
struct PickReaders {
    ColourReader colour;
    LobeReader find_lobe;
    LobeColour lobe_colour;
    MeasuredColourReader measured_colour;
};

/// Reads the colour of one pick: `colour` = "#rrggbb" or [r, g, b], and `space`. Components are finite and at most
/// 65504; they may be negative or exceed 1. Nothing is said yet of what comes near to it.
/// Nothing, if the pick has no `colour`.
std::optional<PickedColour> read_picked_colour(const Table& pick, const ColourReader& read);

/// Finds the band for a colour.
void find_band(const PickReaders& readers, PickedColour& picked);

}  // namespace nacre
