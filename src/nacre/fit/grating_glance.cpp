#include "nacre/fit/grating_glance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace nacre {
namespace {

bool counts(const Grating& grating, int order) {
    return grating.orders.empty() || std::binary_search(grating.orders.begin(), grating.orders.end(), order);
}

void add(double density, const Xyz& low, const Xyz& high, Xyz& sum) {
    sum = {sum.x + density * (high.x - low.x), sum.y + density * (high.y - low.y), sum.z + density * (high.z - low.z)};
}

}  // namespace

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
    Xyz sum;
    add_boxes(grating, u, sum);
    add_flanks(grating, u, sum);
    return sum;
}

void GratingGlance::add_boxes(const Grating& grating, double u, Xyz& sum) const {
    // The integral of sinc^2 over half a line's width to either side.
    constexpr double in_box = 0.7737;
    const double last_nm = first_nm_ + static_cast<double>(sums_.size()) - 1.0;
    const double path_nm = grating.period_nm * u * share_across(grating);
    // A line is seen if its box touches the light: orders half a groove's share beyond the range count too.
    const double half = 0.5 / grating.grooves;
    const int least = std::max(1, static_cast<int>(std::ceil(path_nm / last_nm - half)));
    const int most = static_cast<int>(std::floor(path_nm / first_nm_ + half));
    for (int order = least; order <= most; ++order) {
        if (!counts(grating, order)) continue;
        const double from_nm = std::max(path_nm / (order + half), first_nm_);
        const double to_nm = std::min(path_nm / (order - half), last_nm);
        if (!(to_nm > from_nm)) continue;
        const double middle_nm = 0.5 * (from_nm + to_nm);
        const Xyz low = below(from_nm);
        const Xyz high = below(to_nm);
        // N (d / wavelength) over 1 / N of an order.
        const double scale = in_box * grating.grooves * grating.period_nm / middle_nm *
                             grating_efficiency(grating, order, middle_nm) *
                             std::exp(-azimuth_exponent(grating, u, middle_nm));
        add(scale, low, high, sum);
    }
}

void GratingGlance::add_flanks(const Grating& grating, double u, Xyz& sum) const {
    constexpr double step_nm = 10.0;
    constexpr int orders_beside = 2;
    constexpr double mean_of_sine_squared = 0.5;
    const double last_nm = first_nm_ + static_cast<double>(sums_.size()) - 1.0;
    const double path_nm = grating.period_nm * u * share_across(grating);
    const double half = 0.5 / grating.grooves;
    for (double from_nm = first_nm_; from_nm < last_nm; from_nm += step_nm) {
        const double nm = std::min(from_nm + 0.5 * step_nm, last_nm);
        const double place = path_nm / nm;
        const int nearest = static_cast<int>(std::lround(place));
        double density = 0.0;
        for (int order = std::max(1, nearest - orders_beside); order <= nearest + orders_beside; ++order) {
            const double distance = std::abs(place - order);
            if (distance <= half || !counts(grating, order)) continue;
            const double argument = std::numbers::pi * distance;
            density +=
                grating_efficiency(grating, order, nm) * mean_of_sine_squared / (grating.grooves * argument * argument);
        }
        density *= grating.period_nm / nm * std::exp(-azimuth_exponent(grating, u, nm));
        add(density, below(from_nm), below(std::min(from_nm + step_nm, last_nm)), sum);
    }
}

}  // namespace nacre
