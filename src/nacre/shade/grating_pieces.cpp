#include "nacre/shade/grating_pieces.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "nacre/colour/xyz_sums.h"

namespace nacre {
namespace {

// A parabola over a piece is wrong by (change / 2)^3 / 15.6 of a sine whose phase changes so much: 1.4e-6 here, of half
// the efficiency, a profile's depth being what makes phases.
constexpr double most_phase_change = 0.07;

// The light's weights within a cell, at `along` from 0 to 1, per nanometre.
Xyz weight_at(const TristimulusWeights& weights, int cell, double along) {
    const auto i = static_cast<std::size_t>(cell);
    const auto between = [&](const std::vector<double>& weight) {
        return ((1.0 - along) * weight[i] + along * weight[i + 1]) * weights.cells_per_nm;
    };
    return {between(weights.x), between(weights.y), between(weights.z)};
}

// The parabola over a piece, by its values at both ends and in the middle, that has the integral and the first two
// moments of the light's weights times wavelength.
std::array<Xyz, 3> weights_over(const TristimulusWeights& weights, double from_nm, double to_nm) {
    const double middle = 0.5 * (1.0 / from_nm + 1.0 / to_nm), half = 0.5 * (1.0 / to_nm - 1.0 / from_nm);
    const double per_nm = weights.cells_per_nm;
    const auto at = [&](double nm) {
        const double position = (nm - weights.first_nm) * per_nm;
        const int cell = std::clamp(static_cast<int>(position), 0, weights.count() - 2);
        return scaled(weight_at(weights, cell, nm * per_nm - (weights.first_cell() + cell)), nm);
    };
    // Within a cell weights are straight, and their own values make the parabola.
    if (to_nm * per_nm <= std::floor(from_nm * per_nm) + 1.0) return {at(from_nm), at(1.0 / middle), at(to_nm)};
    Xyz zeroth, first, second;
    // Simpson's rule cell by cell, in s.
    for (double left_nm = from_nm; left_nm < to_nm;) {
        const double right_nm = std::min((std::floor(left_nm * per_nm) + 1.0) / per_nm, to_nm);
        const double left = (1.0 / left_nm - middle) / half, right = (1.0 / right_nm - middle) / half;
        for (const auto& [s, share] : {std::pair{left, 1.0}, {0.5 * (left + right), 4.0}, {right, 1.0}}) {
            const double part = share * (right - left) / 6.0;
            const Xyz weight = at(std::clamp(1.0 / (middle + half * s), left_nm, right_nm));
            add(zeroth, part, weight);
            add(first, part * s, weight);
            add(second, part * s * s, weight);
        }
        left_nm = right_nm;
    }
    // By Legendre's polynomials.
    Xyz even = scaled(zeroth, 0.5), bend = scaled(second, 15.0 / 4.0), slope = scaled(first, 1.5);
    add(bend, -5.0 / 4.0, zeroth);
    std::array<Xyz, 3> parabola{even, even, even};
    for (std::size_t j = 0; j < 3; ++j) {
        const double s = static_cast<double>(j) - 1.0;
        add(parabola[j], s, slope);
        add(parabola[j], 1.5 * s * s - 0.5, bend);
    }
    return parabola;
}

}  // namespace

double profile_phase_per_nm(double depth_nm, double first_nm) {
    return 4.0 * std::numbers::pi * depth_nm / (first_nm * first_nm);
}

GratingPieces grating_pieces(const TristimulusWeights& weights, int nm, double depth_nm) {
    assert(nm >= 1 && weights.count() >= 2);
    GratingPieces result;
    result.nm = nm;
    const double most_change = nm > 1 ? most_coarse_phase_change : most_phase_change;
    result.per_nm.push_back(1.0 / weights.first_nm);
    for (int begin_nm = weights.first_nm; begin_nm < weights.last_nm; begin_nm += nm) {
        const int length_nm = std::min(nm, weights.last_nm - begin_nm);
        const double first_nm = begin_nm;
        const double change = length_nm * profile_phase_per_nm(depth_nm, first_nm);
        const int pieces = std::max(1, static_cast<int>(std::ceil(change / most_change)));
        for (int i = 0; i < pieces; ++i) {
            const double from_nm = first_nm + length_nm * (static_cast<double>(i) / pieces);
            const double to_nm = first_nm + length_nm * (static_cast<double>(i + 1) / pieces);
            const double middle_nm = 2.0 * from_nm * to_nm / (from_nm + to_nm);  // in 1 / nm
            result.per_nm.push_back(1.0 / middle_nm);
            result.per_nm.push_back(1.0 / to_nm);
            result.weights.push_back(weights_over(weights, from_nm, to_nm));
        }
    }
    return result;
}

}  // namespace nacre
