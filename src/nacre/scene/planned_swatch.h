#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nacre/base/where.h"
#include "nacre/base/words.h"
#include "nacre/lut/axis_kinds.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/gamut.h"
#include "nacre/lut/job.h"
#include "nacre/pick/picked_colour.h"

namespace nacre {

/// What a swatch shows: see [swatch.NAME] in the documentation of scenes.
enum class SwatchKind { plane, palette, strip, sphere, bubble, disc, puddle, picks, contact_sheet, preview };

inline constexpr std::array swatch_words{
    Word<SwatchKind>{"plane", SwatchKind::plane, "peak wavelength against angle, with the picks"},
    Word<SwatchKind>{"palette", SwatchKind::palette, "width against height at a pick's peak"},
    Word<SwatchKind>{"strip", SwatchKind::strip, "the LUT with its axis"},
    Word<SwatchKind>{"sphere", SwatchKind::sphere, "a ball in a studio"},
    Word<SwatchKind>{"bubble", SwatchKind::bubble, "a hollow ball with thin walls that light shines through"},
    Word<SwatchKind>{"disc", SwatchKind::disc, "a grating as the circular grooves of a compact disc"},
    Word<SwatchKind>{"puddle", SwatchKind::puddle, "a puddle under an overcast sky"},
    Word<SwatchKind>{"picks", SwatchKind::picks, "picked colours beside those that are reached"},
    Word<SwatchKind>{"contact_sheet", SwatchKind::contact_sheet, "all LUTs of the scene, or of its variants, labelled"},
    Word<SwatchKind>{"preview", SwatchKind::preview, "a strip and an object in one picture, as beside every LUT"},
};

/// What a contact sheet shows of each LUT.
inline constexpr std::array sheet_words{
    Word<SwatchKind>{"strip", SwatchKind::strip, "the LUT with its axis"},
    Word<SwatchKind>{"sphere", SwatchKind::sphere, "a lit ball"},
};

/// The same for pictures, which have to show something.
inline constexpr std::array swatch_gamut_words{
    Word<Gamut>{"compress", Gamut::compress, "moved into the gamut of sRGB, so that neighbours stay distinct"},
    Word<Gamut>{"clip", Gamut::clip, "cut at what the display shows"},
};

/// The axis theta_deg.
const AxisKind& even_degrees();

/// One picture: <name>.png.
struct PlannedSwatch {
    std::string name;
    SwatchKind kind = SwatchKind::strip;
    std::string title;
    std::vector<Job> jobs;                  ///< one; of a palette one per pick shown, of a contact sheet one per LUT
    std::vector<std::string> labels;        ///< of a contact sheet, one per job
    SwatchKind panels = SwatchKind::strip;  ///< of a contact sheet: strip or sphere
    std::vector<PickedColour> picked;       ///< of the material, those that were given as colours
    LutColour colour;                       ///< of the LUT that it shows, or of the scene
    std::string display;                    ///< empty: the config's default
    std::string view;
    std::optional<double> exposure_ev;  ///< of strips and objects; none: automatic
    /// What a strip is even in, where it shows the angle to the normal: degrees.
    const AxisKind* shown_axis = &even_degrees();
    Gamut gamut = Gamut::compress;  ///< compress or clip: how colours that an sRGB display lacks are shown
    Where where;
};

/// The images that a swatch of a material is made of: a swatch is a bake, not a second renderer.
///
/// plane: peak wavelength (x) against angle (y). palette: width (x) against height (y), one job per pick, at the pick's
/// angle and with that pick as its material's only one. A contact sheet shows LUTs and no material. All others: the
/// default LUT, finely sampled.
std::vector<Job> swatch_jobs(SwatchKind kind, const Material& material, const std::shared_ptr<const Light>& light);

}  // namespace nacre
