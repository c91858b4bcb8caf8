#pragma once

#include <functional>
#include <string>

#include "nacre/bake/fit_shape.h"
#include "nacre/bake/index.h"
#include "nacre/bake/light.h"
#include "nacre/bake/picked_colour.h"
#include "nacre/optics/measured_spectra.h"

namespace nacre {

/// How the core asks for a table of spectra at several angles. What comes back keeps MeasuredSpectra's promises. Throws
/// Error (with the line and column in that file) or IoError.
using SpectraReader = std::function<MeasuredSpectra(const std::string& file, const Where& where)>;

/// What reading a material may need of the world around its table.
struct SceneContext {
    IndexReader index;
    CurveReader read_curve;
    SpectraReader read_spectra;
    ColourReader read_colour{};
    LobeReader find_lobe{};
    /// Called for every pick that is a colour.
    std::function<void(const PickedColour&)> note_picked{};
    /// Empty: shapes are not fitted.
    LobeColour lobe_colour{};
    /// Called for a palette whose shape was fitted.
    std::function<void(const ShapeFit&)> note_shape{};
};

}  // namespace nacre
