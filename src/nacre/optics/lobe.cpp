#include "nacre/optics/lobe.h"

#include <cmath>
#include <numbers>

namespace nacre {

double lobe_reflectance(const Lobe& lobe, double wavelength_nm) {
    const double distance_nm = std::abs(wavelength_nm - lobe.peak_nm);
    // "!(a < b)" rather than "a >= b": a lobe of zero width is black at its own peak too.
    if (!(distance_nm < 0.5 * lobe.width_nm)) return 0.0;
    return lobe.height * std::cos(std::numbers::pi * distance_nm / lobe.width_nm);
}

}  // namespace nacre
