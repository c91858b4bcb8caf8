#pragma once

#include <string>
#include <vector>

#include "pipeline/effect_shares.h"
#include "pipeline/json.h"

namespace nacre {

/// A table of a LUT's effects that fits a terminal, and a line of those that are not in the scene.
std::vector<std::string> effect_lines(const std::string& lut, const std::vector<EffectShare>& effects);

/// All effects, absent ones too: { name, state, contribution, share, time_share }.
Json effects_json(const std::vector<EffectShare>& effects);

}  // namespace nacre
