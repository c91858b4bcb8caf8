#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "nacre/pick/colour_path.h"
#include "nacre/scene/plan.h"

namespace nacre {

/// What one mechanism makes of picked colours, to be compared with what others make of them.
struct MechanismAnswer {
    std::string mechanism;     ///< "stack"
    std::size_t answer = 0;    ///< which of its search's; of a palette 0
    std::string text;          ///< its free numbers, "index = 1.33, thickness_nm = 402.1"; of a palette empty
    std::vector<double> de00;  ///< CIEDE2000 per pick
    double error = 0.0;        ///< root of the weighted mean of their squares
    std::size_t numbers = 0;   ///< how many numbers were found for it
    ColourPath path;           ///< from the pick at the least angle to that at the greatest
};

/// The answers that a plan has for its only material, best first: of a palette one, of what was searched for several.
/// @param mechanism  the material's, by its name
std::vector<MechanismAnswer> mechanism_answers(const Plan& plan, const std::string& mechanism);

/// The first of other answers that is worth naming beside a palette: it meets every pick as well as the palette or to
/// `met_de00`; or it comes within `near_de00` and its way has a hue where that of the palette is grey. Null: none.
const MechanismAnswer* answer_beside(const MechanismAnswer& palette, const std::vector<MechanismAnswer>& others);

/// The best first: by their errors, below `as_good_as_met` by how few numbers they need.
void rank(std::vector<MechanismAnswer>& answers);

/// CIEDE2000 that is seen only when both colours are looked at side by side; chosen.
inline constexpr double near_de00 = 3.0;

}  // namespace nacre
