#pragma once

#include <cstddef>
#include <string>

#include "nacre/pick/mechanism_search.h"
#include "pipeline/json.h"

namespace nacre {

/// One answer to a search: "index = 1.334, thickness_nm = 312 (dE00 0.2, 0.1, together 0.16; with the nearest
/// materials, index water, together 0.4)", where together is the root of the weighted mean square.
std::string answer_text(const MaterialSearch& search, std::size_t answer);

/// All answers.
Json found_json(const MaterialSearch& search);

}  // namespace nacre
