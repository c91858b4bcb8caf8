#pragma once

#include <string>

#include "pipeline/bake_task.h"
#include "pipeline/json.h"

namespace nacre {

/// What became of a task that succeeded, in one line: files, size and format, space, error, gamut, effects left out.
std::string bake_line(const BakeTask& task, const BakeOutcome& outcome);

/// "morpho: 24 % of texels have negative components ...", where dropping these components would change colours by more
/// than the LUT may err, or by nobody knows how much; else empty.
std::string gamut_warning(const BakeTask& task, const BakedLut& baked);

/// The same for --json: a LUT's manifest with `unchanged`, `seconds` and `work`; of a picture its file, display and
/// view.
Json bake_json(const BakeTask& task, const BakeOutcome& outcome);

}  // namespace nacre
