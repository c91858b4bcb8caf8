#pragma once

#include <memory>
#include <string>

#include "cli/figures/paper_pictures.h"
#include "nacre/colour/light.h"
#include "nacre/paper/paper.h"

namespace nacre {

/// "stacks_morpho": a specimen's palette beside exactly solved stacks, as plots, tables and a verdict.
PaperFigure stacks_figure(const Specimen& specimen, const std::shared_ptr<const Light>& light);

}  // namespace nacre
