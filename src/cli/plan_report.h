#pragma once

#include <string>
#include <vector>

#include "pipeline/decide.h"
#include "pipeline/effect_shares.h"
#include "pipeline/json.h"

namespace nacre {

/// A LUT of `nacre plan`.
struct PlanRow {
    const DecidedLut* lut = nullptr;
    double seconds = 0.0;  ///< what baking it will take, see seconds_of_bake()
    std::vector<EffectShare> effects;
};

/// The table: axes, size, format, sampling, expected error and time of each LUT.
std::vector<std::string> plan_lines(const std::vector<PlanRow>& rows);

/// "errors of morpho: interpolation 0.089, storage 0.032", the largest first.
std::vector<std::string> error_lines(const DecidedLut& lut);

/// Everything that is known about a LUT before it is baked.
Json plan_json(const PlanRow& row);

}  // namespace nacre
