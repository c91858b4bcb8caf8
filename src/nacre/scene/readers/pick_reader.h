#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/base/where.h"
#include "nacre/colour/colour_types.h"
#include "nacre/optics/lobe.h"
#include "nacre/optics/measured_spectra.h"
#include "nacre/pick/band/palette_bands.h"
#include "nacre/pick/band/shown_colour.h"
#include "nacre/pick/picked_colour.h"
#include "nacre/scene/table.h"

namespace nacre {

/// How the core asks for a colour's XYZ, relative to D65 and Y = 1 for the perfect reflector.
/// @param space  of the scene's OpenColorIO config; empty: its role color_picking
/// Throws Error with `where`.
using ColourReader = std::function<Xyz(const Rgb& colour, const std::string& space, const Where& where)>;

/// The colour that the picked one is shown as, and the bands of a palette's picks, under the scene's light.
struct BandReader {
    std::function<ShownColour(const Xyz& colour)> shown;
    std::function<std::vector<Lobe>(const std::vector<ColourOrBand>& picks)> bands;
};

/// The colour of measured spectra at an angle, relative to D65.
using MeasuredColourReader = std::function<Xyz(const MeasuredSpectra& spectra, double angle_deg)>;

/// What it takes to read picks that are colours.
struct PickReaders {
    ColourReader colour;
    BandReader find;
    LobeColour lobe_colour;
    MeasuredColourReader measured_colour;
    bool wants_pale_paths = false;  ///< PlanRequest
};

inline constexpr Allowed allowed_pick_angle{0.0, 90.0, "degrees"};

/// The keys of a band of reflectance.
struct LobeKey {
    std::string_view key;
    std::string_view description;
    Allowed allowed;
    double Lobe::*member;
    bool may_be_left_out = false;  ///< then it is 0
};
inline constexpr std::array lobe_keys{
    LobeKey{"peak_nm", "peak wavelength", {100.0, 2000.0, "nm"}, &Lobe::peak_nm},
    LobeKey{"width_nm", "width", {0.0, 1000.0, "nm"}, &Lobe::width_nm},
    LobeKey{"height", "height", {0.0, 1.0}, &Lobe::height},
    LobeKey{"floor", "floor", {0.0, 1.0}, &Lobe::floor, true},
    LobeKey{"flatness", "flatness", {0.0, largest_flatness}, &Lobe::flatness, true},
};

/// `picks` as an array of at least one and at most 100.
const Value::Array& read_pick_list(const Table& table, const Value& picks);

/// peak_nm, width_nm, height, floor and flatness of a pick without a colour. Notes mistakes.
Lobe read_lobe(const Table& pick);

/// Reads the colour of one pick: `colour` = "#rrggbb" or [r, g, b], and `space`. Components are finite and at most
/// 65504; they may be negative or exceed 1. Nothing is said yet of what comes near to it.
/// Nothing, if the pick has no `colour`.
std::optional<PickedColour> read_picked_colour(const Table& pick, const ColourReader& read);

}  // namespace nacre
