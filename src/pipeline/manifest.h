#pragma once

#include <string>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/lut/axis.h"
#include "nacre/pick/picked_colour.h"
#include "pipeline/baked_lut.h"
#include "pipeline/json.h"

namespace nacre {

/// What tools should know about a LUT. No date, host or path.
Json manifest_json(const ChosenLut& lut, const BakedLut& baked);

/// The manifest as the text of a file, ending in a newline.
std::string manifest_text(const ChosenLut& lut, const BakedLut& baked);

/// { axis } or { parameter, from, to }.
Json axis_json(const Axis& axis);

/// { mean_de00, percentile_95_de00 }.
Json shift_json(const ColourShift& shift);

/// A pick that was given as a colour: { pick, angle_deg, colour, peak_nm, width_nm, height, de00, match, tolerance }.
Json picked_json(const PickedColour& picked);

}  // namespace nacre
