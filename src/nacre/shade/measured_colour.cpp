#include "nacre/shade/measured_colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nacre/colour/xyz_sums.h"

namespace nacre {
namespace {

// Per nanometre.
Xyz weight_at(const TristimulusWeights& weights, double nm) {
    const double position = nm * weights.cells_per_nm - weights.first_cell();
    const auto cell = static_cast<std::size_t>(std::clamp(std::floor(position), 0.0, weights.count() - 2.0));
    const double t = position - static_cast<double>(cell);
    const auto at = [&](const std::vector<double>& weight) {
        return std::lerp(weight[cell], weight[cell + 1], t) * weights.cells_per_nm;
    };
    return {at(weights.x), at(weights.y), at(weights.z)};
}

// A wavelength's shares in the two of the spectra that it lies between; beyond them the nearest has all.
struct Shares {
    std::size_t left;
    double right_share;
};
Shares shares_at(const std::vector<double>& wavelength_nm, double nm) {
    if (nm <= wavelength_nm.front()) return {0, 0.0};
    if (nm >= wavelength_nm.back()) return {wavelength_nm.size() - 2, 1.0};
    const auto right = std::upper_bound(wavelength_nm.begin(), wavelength_nm.end(), nm);
    const auto left = static_cast<std::size_t>(right - wavelength_nm.begin()) - 1;
    return {left, (nm - wavelength_nm[left]) / (wavelength_nm[left + 1] - wavelength_nm[left])};
}

void add_at(const std::vector<double>& wavelength_nm, double nm, const Xyz& weight, std::vector<Xyz>& sums) {
    const Shares shares = shares_at(wavelength_nm, nm);
    add(sums[shares.left], 1.0 - shares.right_share, weight);
    add(sums[shares.left + 1], shares.right_share, weight);
}

// Between all borders of cells and wavelengths of the spectra the product is a parabola: Simpson's rule is exact.
std::vector<Xyz> exact_weights(const std::vector<double>& wavelength_nm, const TristimulusWeights& weights) {
    std::vector<double> borders;
    for (int cell = weights.first_cell(); cell <= weights.last_cell(); ++cell)
        borders.push_back(static_cast<double>(cell) / weights.cells_per_nm);
    for (const double nm : wavelength_nm) {
        if (nm > weights.first_nm && nm < weights.last_nm) borders.push_back(nm);
    }
    std::sort(borders.begin(), borders.end());
    std::vector<Xyz> sums(wavelength_nm.size());
    for (std::size_t i = 1; i < borders.size(); ++i) {
        const double from = borders[i - 1];
        const double to = borders[i];
        const double middle = 0.5 * (from + to);
        for (const auto& [nm, share] : {std::pair{from, 1.0 / 6.0}, {middle, 4.0 / 6.0}, {to, 1.0 / 6.0}}) {
            Xyz weight;
            add(weight, share * (to - from), weight_at(weights, nm));
            add_at(wavelength_nm, nm, weight, sums);
        }
    }
    return sums;
}

std::vector<Xyz> grid_weights(const std::vector<double>& wavelength_nm, const Light& light) {
    std::vector<Xyz> sums(wavelength_nm.size());
    for (int node = 0; node < light.grid.count; ++node) {
        const auto i = static_cast<std::size_t>(node);
        add_at(wavelength_nm, light.grid.wavelength_nm(node),
               {light.grid_weights.x[i], light.grid_weights.y[i], light.grid_weights.z[i]}, sums);
    }
    return sums;
}

}  // namespace

MeasuredColour::MeasuredColour(const MeasuredSpectra& spectra, const Light& light)
    : curve_(spectra),
      weights_(light.settings.wavelengths ? grid_weights(spectra.wavelength_nm, light)
                                          : exact_weights(spectra.wavelength_nm, light.weights)) {}

Xyz MeasuredColour::at(const Incidence& incidence, Work* work) const {
    std::vector<double> reflectance;
    curve_.at(incidence.theta_deg, reflectance);
    Xyz sum;
    for (std::size_t i = 0; i < weights_.size(); ++i) add(sum, reflectance[i], weights_[i]);
    if (work != nullptr) {
        ++work->spectra;
        work->samples += weights_.size();
    }
    return sum;
}

}  // namespace nacre
