#include "nacre/base/sampled_curve.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace nacre {

double SampledCurve::at(double nm) const {
    assert(!wavelength_nm.empty() && wavelength_nm.size() == value.size());
    if (!(nm >= wavelength_nm.front() && nm <= wavelength_nm.back())) return 0.0;
    const auto next = std::upper_bound(wavelength_nm.begin(), wavelength_nm.end(), nm);
    const auto right = static_cast<std::size_t>(next - wavelength_nm.begin());
    if (right == wavelength_nm.size()) return value.back();
    const std::size_t left = right - 1;
    const double t = (nm - wavelength_nm[left]) / (wavelength_nm[right] - wavelength_nm[left]);
    // Both products, so that the value at a node is exact to the bit.
    return (1.0 - t) * value[left] + t * value[right];
}

}  // namespace nacre
