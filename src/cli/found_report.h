#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "nacre/bake/mechanism_search.h"

namespace nacre {

/// "index = 1.334, thickness_nm = 312 (dE00 0.02, 0.01; near to water, dE00 0.4 of it)": one answer to a search.
std::string answer_text(const MaterialSearch& search, std::size_t answer);

/// All answers.
nlohmann::ordered_json found_json(const MaterialSearch& search);

}  // namespace nacre
