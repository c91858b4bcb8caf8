#pragma once

#include <cstddef>
#include <vector>

#include "nacre/material/mechanism.h"
#include "nacre/optics/measured_spectra.h"
#include "nacre/pick/fit_palette.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/scene/plan.h"

namespace nacre {

/// An answer to picks, its numbers rounded so that a scene can be read.
/// @param answer  which of search.found
Mechanism rounded_answer(const MaterialSearch& search, std::size_t answer);

/// How a material whose picks are measured spectra compares with these. The peak is the material's band near the
/// measured one, NaN where it has none.
std::vector<AngleFit> compare_with_measured(const MeasuredSpectra& spectra, const SceneMaterial& material);

/// The palette of that many picks that comes nearest to measured spectra under the default light, its numbers rounded
/// so that a scene can be read.
/// @pre 1 <= count <= number of angles
PaletteFit fit_readable_palette(const MeasuredSpectra& spectra, std::size_t count);

}  // namespace nacre
