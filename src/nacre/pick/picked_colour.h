#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "nacre/base/where.h"
#include "nacre/colour/colour_types.h"
#include "nacre/optics/lobe.h"
#include "nacre/pick/band/shown_colour.h"
#include "nacre/pick/tolerance.h"

namespace nacre {

/// A picked colour of a material, and the colour that the material shows.
struct PickedColour {
    std::size_t pick = 0;  ///< which of the material's picks
    double angle_deg = 0.0;
    std::string text;  ///< as the user wrote it: "#3a6fd0", "[0.1, 0.2, 0.4] in lin_rec709"
    Xyz colour;        ///< relative to D65
    double weight = 1.0;
    Xyz reached;                     ///< the colour that the material shows there, relative to D65
    double de00 = 0.0;               ///< between the two, both beside D65 white
    std::optional<Lobe> lobe;        ///< of a palette: its band
    ShownColour shown;               ///< of a palette: what its band has exactly
    bool looks_like_bytes = false;   ///< whether its components look like 0 to 255
    std::string mechanism = "band";  ///< what was searched: "band", "film"
    bool is_searched =
        true;  ///< whether anything was free: else the scene has all numbers, and picks are compared with
    std::optional<ColourShift> tolerance{};  ///< how far the colour moves within the search's tolerance
    Where where;

    /// Whether it is shown: by a band exactly, by anything else to `met_de00`.
    bool is_met() const;
};

/// A film, stack, grating or crystal with at most this error meets a picked colour.
inline constexpr double met_de00 = 0.5;

/// "exact", "met, CIEDE2000 0.03", "misses by CIEDE2000 4.7, because ...", or of a band "is dimmed to 62 % of its
/// luminance, because ...; CIEDE2000 4.7"
std::string match_text(const PickedColour& picked);

/// For a pick that is not met: "the best film found misses by CIEDE2000 4.7, because ...", "is dimmed to ..."
std::string unmatched_text(const PickedColour& picked);

/// The colours of a material as the user wrote them, and what they became: "#3a6fd0 at 0 deg: exact; ...".
std::string picked_text(const std::vector<PickedColour>& picked);

/// The colour of a lobe, relative to D65.
using LobeColour = std::function<Xyz(const Lobe& lobe)>;

}  // namespace nacre
