#include "nacre/base/crop_curve.h"

#include <algorithm>
#include <iterator>

namespace nacre {

void crop_curve(SampledCurve& curve, double first_nm, double last_nm) {
    auto& [nm, value] = curve;
    const auto after = std::upper_bound(nm.begin(), nm.end(), first_nm);
    const auto begin = after == nm.begin() ? 0 : std::distance(nm.begin(), after) - 1;
    const auto last = std::lower_bound(nm.begin(), nm.end(), last_nm);
    const auto end = last == nm.end() ? std::distance(nm.begin(), last) : std::distance(nm.begin(), last) + 1;
    if (end - begin < 2) return;
    nm = {nm.begin() + begin, nm.begin() + end};
    value = {value.begin() + begin, value.begin() + end};
}

}  // namespace nacre
