#pragma once

#include <functional>
#include <vector>

#include "io/scene/variants.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/table.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// How a scene that has no variants is planned.
using PlanTable = std::function<Plan(const Table& scene, const SceneRequest& request)>;

/// A plan for each variant: of a scene of its own, which is the given one with the edits of the variant.
///
/// Its LUT has the name of the variant, its polarisations VARIANT_s and VARIANT_p; of several LUTs each is named
/// VARIANT_LUT, and so is each swatch. A contact sheet keeps its name, belongs to the first plan and shows the LUTs of
/// all variants. Throws one Error with the mistakes of all variants, each once.
/// @param request  `only` are the new names
std::vector<Plan> plan_variants(const Table& scene, const std::vector<Variant>& variants, const SceneRequest& request,
                                const PlanTable& plan_table);

/// Writes into a plan what was changed in its scene.
void add_edits(Plan& plan, const std::vector<SceneEdit>& edits);

}  // namespace nacre
