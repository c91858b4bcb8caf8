#pragma once

#include <variant>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/shade/grating_colour.h"
#include "nacre/shade/layered_colour.h"
#include "nacre/shade/measured_colour.h"
#include "nacre/shade/palette_colour.h"
#include "nacre/shade/scatter_colour.h"
#include "nacre/shade/spectral_sampling.h"
#include "nacre/shade/work.h"

namespace nacre {

/// The colour of a mechanism at many angles, without its tilt.
using PreparedColour = std::variant<PaletteColour, LayeredColour, GratingColour, ScatterColour, MeasuredColour>;

/// @param light     has to outlive the result
/// @param sampling  decided, if the mechanism needs it
PreparedColour prepare_colour(const Mechanism& mechanism, const SpectralSampling& sampling, const Light& light);

/// Before adaptation. @param work  what it takes is added
Xyz colour_at(PreparedColour& prepared, const Geometry& geometry, Work& work);

}  // namespace nacre
