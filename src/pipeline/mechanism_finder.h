#pragma once

#include <functional>
#include <vector>

#include "nacre/colour/light.h"
#include "nacre/pick/mechanism_search.h"

namespace nacre {

/// Looks for mechanisms that show given colours (see nacre/pick/find_mechanism.h), and names the materials that nacre
/// brings along which they are nearly made of.
/// @param after_step  called every few designs; an exception from it ends the search
std::vector<FoundMechanism> find_with_materials(const MechanismSearch& search, const Light& light,
                                                const std::function<void()>& after_step);

}  // namespace nacre
