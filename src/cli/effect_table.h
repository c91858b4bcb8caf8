#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/accuracy/settle.h"

namespace nacre {

/// One effect of a settled LUT, and what it has in the time that a bake takes.
struct EffectShare {
    EffectChoice choice;
    double time_share = 0.0;  ///< of a simulated one: what the bake would save without it, in [0, 1]; of one that is
                              ///< left out: what it would add, over the time with it
};

/// The material's effects, the dearest first, by baking a piece of the LUT with and without each.
std::vector<EffectShare> effect_shares(const SettledLut& settled);

/// A table of them that fits a terminal, and a line of those that are not in the scene.
std::vector<std::string> effect_lines(const std::string& lut, const std::vector<EffectShare>& effects);

/// All effects, absent ones too: { name, state, contribution, share, time_share }.
nlohmann::ordered_json effects_json(const std::vector<EffectShare>& effects);

}  // namespace nacre
