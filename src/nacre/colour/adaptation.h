#pragma once

#include <glm/mat3x3.hpp>

#include "nacre/colour/colour_types.h"

namespace nacre {

enum class Adaptation { bradford, cat16, none };

/// The matrix that takes XYZ seen under one white to the corresponding colour under another (von Kries scaling
/// of cone responses, complete adaptation). `none` is the identity.
///
/// Cone matrices: Bradford as in Lam 1985 and the ICC profile specification; CAT16 from Li et al. 2017.
/// @pre both whites have positive cone responses
glm::dmat3 adaptation_matrix(Adaptation method, Xyz from_white, Xyz to_white);

/// Whether a white can be adapted from: every cone responds to it. Lights of a few wavelengths may fail.
bool can_adapt_from(Adaptation method, Xyz white);

/// matrix * colour
Xyz adapt(const glm::dmat3& matrix, Xyz colour);

}  // namespace nacre
