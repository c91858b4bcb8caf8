#include "nacre/fit/grating_glance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nacre {

GratingGlance::GratingGlance(const Light& light) : first_nm_(light.weights.first_nm) {
    const TristimulusWeights& weights = light.weights;
    Xyz sum;
    sums_.push_back(sum);
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(weights.count()); ++i) {
        sum.x += 0.5 * (weights.x[i] + weights.x[i + 1]);
        sum.y += 0.5 * (weights.y[i] + weights.y[i + 1]);
        sum.z += 0.5 * (weights.z[i] + weights.z[i + 1]);
        sums_.push_back(sum);
    }
}

Xyz GratingGlance::below(double wavelength_nm) const {
    const double last = static_cast<double>(sums_.size()) - 1.0;
    const double place = std::clamp(wavelength_nm - first_nm_, 0.0, last);
    const auto cell = std::min(static_cast<std::size_t>(place), sums_.size() - 2);
    const double share = place - static_cast<double>(cell);
    const Xyz& from = sums_[cell];
    const Xyz& to = sums_[cell + 1];
    return {std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share), std::lerp(from.z, to.z, share)};
}

Xyz GratingGlance::at(const Grating& grating, double u) const {
    const double across = u * share_across(grating);
    const double last_nm = first_nm_ + static_cast<double>(sums_.size()) - 1.0;
    const double path_nm = grating.period_nm * across;
    Xyz sum;
    // A line is seen if its box touches the light: orders half a groove's share beyond the range count too.
    const double flank = 0.5 / grating.grooves;
    const int least = std::max(1, static_cast<int>(std::ceil(path_nm / last_nm - flank)));
    const int most = static_cast<int>(std::floor(path_nm / first_nm_ + flank));
    for (int order = least; order <= most; ++order) {
        if (!grating.orders.empty() && !std::binary_search(grating.orders.begin(), grating.orders.end(), order))
            continue;
        const double from_nm = std::max(path_nm / (order + flank), first_nm_);
        const double to_nm = std::min(path_nm / (order - flank), last_nm);
        if (!(to_nm > from_nm)) continue;
        const double middle_nm = 0.5 * (from_nm + to_nm);
        const Xyz low = below(from_nm);
        const Xyz high = below(to_nm);
        // N (d / wavelength) over 1 / N of an order.
        const double scale = grating.grooves * grating.period_nm / middle_nm *
                             grating_efficiency(grating, order, middle_nm) *
                             std::exp(-azimuth_exponent(grating, u, middle_nm));
        sum = {sum.x + scale * (high.x - low.x), sum.y + scale * (high.y - low.y), sum.z + scale * (high.z - low.z)};
    }
    return sum;
}

}  // namespace nacre
