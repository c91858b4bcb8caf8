#include "nacre/pick/lobe/lobe_colours.h"

#include <algorithm>

namespace nacre {

Xyz LobeColours::exact(LobePlace place) const {
    return adapt(adaptation_, lobe_to_xyz(weights_, place.peak_nm, place.width_nm(), 1.0));
}

// The fast integral's error is that of white's parts: too much of a narrow lobe's dark colour, and of what the ends of
// the spectrum show of a wide one.
Xyz LobeColours::fast(LobePlace place) const {
    constexpr double narrow = 0.2;  // 40 nm
    constexpr double dark = 0.02;
    if (place.spread < narrow) return exact(place);
    const Xyz colour = lobe_to_xyz_fast(weights_, moments_, place.peak_nm, place.width_nm(), 1.0);
    return colour.y < dark ? exact(place) : adapt(adaptation_, colour);
}

LobePlace LobeColours::clamped(LobePlace place) const {
    return {std::clamp(place.peak_nm, first_nm(), last_nm()),
            std::clamp(place.spread, LobePlace::narrowest_spread, 1.0)};
}

}  // namespace nacre
