#include "nacre/pick/unmatched_picks.h"

#include <algorithm>
#include <cstddef>

namespace nacre {

std::vector<UnmatchedPick> unmatched_picks(const std::vector<PickedColour>& picks) {
    constexpr std::size_t most_said = 4;
    std::vector<UnmatchedPick> unmatched;
    for (const PickedColour& picked : picks) {
        if (!picked.is_met()) unmatched.push_back({picked, unmatched_text(picked)});
    }
    if (unmatched.size() <= most_said) return unmatched;
    const auto worst =
        std::max_element(unmatched.begin(), unmatched.end(),
                         [](const UnmatchedPick& a, const UnmatchedPick& b) { return a.picked.de00 < b.picked.de00; });
    return {{worst->picked,
             worst->text + "; " + std::to_string(unmatched.size() - 1) + " more picks are not matched either"}};
}

}  // namespace nacre
