#pragma once

#include <optional>
#include <string>

#include "nacre/optics/base.h"
#include "nacre/scene/scene_context.h"
#include "nacre/scene/table.h"

namespace nacre {

/// What the key `base` of a material says; nothing if it is "black" or missing.
///
/// A number; { rgb }; { spectrum }, of a file; { wavelength_nm, reflectance }; { pigment, scattering_per_um, share };
/// { metal }. Notes mistakes.
std::optional<Base> read_base(const Table& table, const SceneContext& context);

/// As a value in TOML; reads back as the same base.
std::string base_toml(const Base& base);

}  // namespace nacre
