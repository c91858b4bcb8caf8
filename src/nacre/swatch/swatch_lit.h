#pragma once

#include <string>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/material/mechanism.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch_panel.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// A ball, bubble, disc or puddle of the material. Without a fixed exposure the brightest component in linear Rec.709
/// becomes `lit_brightest`; of gratings 2.5 times that, because their first orders glare. The rim of a ball, from 60
/// degrees on, does not count. A picture says its exposure unless it is 0, and the ends of a second axis.
/// @pre planned.kind is one of these, and the material suits it
Swatch draw_lit(const PlannedSwatch& planned);

/// The object alone, for pictures that hold more than it.
struct LitImage {
    Image<Xyz> image;
    double exposure_ev = 0.0;
    std::string second_axis;  ///< what it is: "thickness"; empty: there is none
    std::string second_ends;  ///< "20 nm at the top, 1200 nm at the bottom"
};
/// @param side         in pixels
/// @param most_effort  of its colours, as of bake_panel()
LitImage lit_image(const PlannedSwatch& planned, int side, double most_effort = most_panel_effort);

/// The object that a material is easiest to recognise as: a disc of a grating, a puddle of a film on water, a bubble of
/// a free film, else a sphere; of a transmittance always a sphere.
SwatchKind object_of(const Material& material);

inline constexpr double lit_brightest = 0.92;

/// "exposure +1.32 EV"; empty at 0.
std::string exposure_text(double exposure_ev);

}  // namespace nacre
