#pragma once

#include <memory>
#include <string>

#include "cli/paper_pictures.h"
#include "nacre/bake/light.h"
#include "nacre/bake/paper.h"

namespace nacre {

/// "stacks_morpho": a specimen's palette beside exactly solved stacks, as plots, tables and a verdict.
PaperFigure stacks_figure(const Specimen& specimen, const std::shared_ptr<const Light>& light);

}  // namespace nacre
