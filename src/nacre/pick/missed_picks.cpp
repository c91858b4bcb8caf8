#include "nacre/pick/missed_picks.h"

#include <algorithm>
#include <cstddef>

namespace nacre {

std::vector<MissedPick> missed_picks(const std::vector<PickedColour>& picks) {
    constexpr std::size_t most_said = 4;
    std::vector<MissedPick> missed;
    for (const PickedColour& picked : picks) {
        if (!picked.is_met()) missed.push_back({picked, miss_text(picked)});
    }
    if (missed.size() <= most_said) return missed;
    const auto worst = std::max_element(missed.begin(), missed.end(), [](const MissedPick& a, const MissedPick& b) {
        return a.picked.de00 < b.picked.de00;
    });
    return {
        {worst->picked, worst->text + "; " + std::to_string(missed.size() - 1) + " more picks are not matched either"}};
}

}  // namespace nacre
