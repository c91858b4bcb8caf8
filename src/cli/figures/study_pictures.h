#pragma once

#include "cli/figures/paper_pictures.h"

namespace nacre {

/// "study": moves of an automatic user to a given picture, with picks and with physical parameters.
PaperFigure study_figure();

}  // namespace nacre
