#pragma once

#include "nacre/pick/mechanism_search.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/scene/scene_context.h"
#include "nacre/scene/table.h"

namespace nacre {

/// Reads `picks` of a mechanism other than a palette, and looks for the mechanism that shows them best.
///
/// Picks are colours, or bands of reflectance whose colours are meant, each with angle_deg (of light that falls along
/// the normal, for gratings, which may have grating_u instead) and weight; or { measured = FILE }, the colours of
/// measured spectra.
/// @param search  what is given and what is free (FreeReader); its `wanted` is empty
ReadMechanism find_mechanism(const Table& table, const SceneContext& context, MechanismSearch search);

}  // namespace nacre
