#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/colour/light.h"
#include "nacre/lut/axis.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/band/pale_path.h"
#include "nacre/pick/fit_shape.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/pick/picked_colour.h"
#include "nacre/scene/scene_context.h"
#include "nacre/scene/table.h"

namespace nacre {

/// A mechanism as a scene gives it, and what its picks became.
struct ReadMechanism {
    Mechanism mechanism;
    std::vector<PickedColour> picked{};      ///< every pick that is a colour
    std::optional<ShapeFit> shape_fit{};     ///< of a palette that left its shape open
    std::vector<PalePath> pale_paths{};      ///< of a palette of colours
    std::optional<MaterialSearch> search{};  ///< what picks of other mechanisms led to; the material's name is empty
};

/// Reads `mechanism`, that mechanism's keys, and its effects. Notes mistakes or throws SceneError; what comes back can
/// be used only if the table is good. The caller looks for unknown keys.
ReadMechanism read_mechanism(const Table& table, const SceneContext& context);

/// The names of those that picks can lead to, the palette first.
std::vector<std::string> mechanisms_with_picks();

/// Why a surface cannot have both.
inline constexpr std::string_view two_reliefs = "tilt_deg and roughness both say how the facets lean";

/// Every numeric parameter that a mechanism has, in the order in which they are offered.
std::vector<Parameter> parameters_of(const Mechanism& mechanism);

/// What the user wrote so as to get this mechanism: the lines below a [material.NAME] heading, in TOML.
std::string mechanism_toml(const Mechanism& mechanism);

/// What is allowed although it is hardly meant: a grating without visible orders; empty if there is nothing to say.
std::string mechanism_warning(const Mechanism& mechanism, const LightSettings& light);

/// Throws Error if the mechanism means nothing somewhere on an axis, although its ends are allowed.
void check_axis(const Axis& axis, const Mechanism& mechanism, const Table& table, const Where& where);

}  // namespace nacre
