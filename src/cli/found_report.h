#pragma once

#include <cstddef>
#include <string>

#include "nacre/pick/mechanism_search.h"
#include "pipeline/compare_mechanisms.h"
#include "pipeline/json.h"

namespace nacre {

/// One answer to a search: "index = 1.334, thickness_nm = 312 (dE00 0.2, 0.1, together 0.16; with the nearest
/// materials, index water, together 0.4)", where together is the root of the weighted mean square.
std::string answer_text(const MaterialSearch& search, std::size_t answer);

/// "--mechanism stack --choose 2: dE00 0.35 and 1, through cyan and blue": what to type for an answer.
std::string mechanism_answer_text(const MechanismAnswer& answer);

/// "stack: film = 1.21, ... (dE00 0.35 and 1, through cyan and blue)": an answer among those of other mechanisms.
std::string mechanism_answer_line(const MechanismAnswer& answer);

Json mechanism_answer_json(const MechanismAnswer& answer);

/// All answers.
Json found_json(const MaterialSearch& search);

}  // namespace nacre
