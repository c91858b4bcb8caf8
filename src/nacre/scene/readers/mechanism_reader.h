#pragma once

#include <string>
#include <vector>

#include "nacre/material/mechanism.h"
#include "nacre/scene/scene_context.h"
#include "nacre/scene/table.h"

namespace nacre {

/// Every numeric parameter that a mechanism has, in the order in which they are offered.
std::vector<Parameter> parameters_of(const Mechanism& mechanism);

/// Reads `mechanism`, that mechanism's keys, and its effects. Throws Error for anything that is wrong or unknown.
Mechanism read_mechanism(const Table& table, const SceneContext& context);

/// What the user wrote so as to get this mechanism: the lines below a [material.NAME] heading, in TOML.
std::string mechanism_toml(const Mechanism& mechanism);

}  // namespace nacre
