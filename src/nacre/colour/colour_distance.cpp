#include "nacre/colour/colour_distance.h"

#include "nacre/colour/difference.h"

namespace nacre {

double distance_at(const Xyz& one, const Xyz& other, double brightest) {
    if (!(brightest > black_luminance)) return 0.0;
    const auto lab = [&](const Xyz& colour) {
        return to_lab({colour.x / brightest, colour.y / brightest, colour.z / brightest}, d65_white);
    };
    return ciede2000(lab(one), lab(other));
}

}  // namespace nacre
