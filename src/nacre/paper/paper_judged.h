#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/layered.h"
#include "nacre/optics/palette.h"
#include "nacre/paper/paper.h"
#include "nacre/paper/paper_figures.h"
#include "nacre/paper/paper_stacks.h"

namespace nacre {

// A specimen's palette beside stacks of layers that are solved exactly: what the paper's approximation costs.

/// Reflectance spectra at the specimen's angles, every nanometre: columns palette_0, <stack>_0, palette_10, ...
Series judged_spectra(const Specimen& specimen, const std::vector<ExactStack>& stacks);

/// At every whole degree, of the palette and of each stack: peak, its error (palette less stack), width at half height,
/// height, Y, and CIEDE2000 between the two.
///
/// <stack>_de00 compares colours as they are. <stack>_scaled_de00 compares after the stack's colours, at all angles,
/// were multiplied by the one number that gives it the palette's Y at the first pick: how bright a specimen is
/// altogether is the artist's choice, and the pictures that heights are read off have no absolute scale.
/// <stack>_repicked_de00 and <stack>_repicked_error_nm are of another palette, repicked() from the stack itself: what
/// is left there is the error of the paper's approximation, whatever the specimen's picks are.
Series judged_angles(const Specimen& specimen, const std::vector<ExactStack>& stacks,
                     const std::shared_ptr<const Light>& light);

/// Largest and mean errors of judged_angles() by stack: at the specimen's angles (`_here`), over 0-60 and over 0-90
/// degrees.
Series judged_summary(const Specimen& specimen, const std::vector<ExactStack>& stacks, const Series& angles);

/// The palette whose picks are the stack's own bands at the specimen's two angles, with the specimen's shape.
/// @pre the stack has bands there
Palette repicked(const Specimen& specimen, const Stack& stack);

/// The rows of judged_angles() at the specimen's angles, one stack after the other: `stack` is 1, 2, ... in that order.
Series judged_table(const Specimen& specimen, const std::vector<ExactStack>& stacks, const Series& angles);

/// Colours at every whole degree, after adaptation.
std::vector<Xyz> colours_at_degrees(const Mechanism& mechanism, const std::shared_ptr<const Light>& light);

/// CIEDE2000 between colours of the one and `scale` times colours of the other, pair by pair; white is D65 with Y = 1.
std::vector<double> differences(const std::vector<Xyz>& some, const std::vector<Xyz>& others, double scale = 1.0);

}  // namespace nacre
