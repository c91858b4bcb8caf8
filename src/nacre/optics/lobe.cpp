#include "nacre/optics/lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {

double lobe_reflectance(const Lobe& lobe, double wavelength_nm) {
    const double distance_nm = std::abs(wavelength_nm - lobe.peak_nm);
    // "!(a < b)" rather than "a >= b": a lobe of zero width is black at its own peak too.
    if (!(distance_nm < 0.5 * lobe.width_nm)) return lobe.floor;
    const double plateau_nm = lobe.flatness * lobe.width_nm;
    const double down_nm = std::max(distance_nm - 0.5 * plateau_nm, 0.0);
    return lobe.floor +
           (lobe.height - lobe.floor) * std::cos(std::numbers::pi * down_nm / (lobe.width_nm - plateau_nm));
}

}  // namespace nacre
