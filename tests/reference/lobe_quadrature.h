#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <vector>

#include "reference/number.h"
#include "reference/weights.h"

namespace nacre::reference {

/// Integrals over one nanometre from nm: of the lobe, and of (wavelength - nm) times the lobe.
struct CellMoments {
    int nm = 0;
    Number zeroth, first;
};

/// Moments of cos(pi (nm - peak) / width), |nm - peak| < width / 2, for every nanometre of [first_nm, last_nm] that
/// it touches.
///
/// A cell that holds an end of the lobe is cut there, so that every integrand is smooth.
/// Accuracy: adaptive 15-point Gauss-Kronrod, bisected until the estimated relative error is below 1e-25.
inline std::vector<CellMoments> lobe_moments(double peak_nm, double width_nm, int first_nm = 360, int last_nm = 830) {
    using Quadrature = boost::math::quadrature::gauss_kronrod<Number, 15>;
    constexpr unsigned most_bisections = 15;
    const Number tolerance("1e-25");

    std::vector<CellMoments> cells;
    if (!(width_nm > 0.0)) return cells;
    const Number peak(peak_nm), width(width_nm);
    for (int nm = first_nm; nm < last_nm; ++nm) {
        const Number from = std::max<Number>(Number(nm), peak - width / 2);
        const Number to = std::min<Number>(Number(nm + 1), peak + width / 2);
        if (from >= to) continue;
        const auto lobe = [&](const Number& wavelength) { return Number(cos(pi() * (wavelength - peak) / width)); };
        const auto ramp = [&](const Number& wavelength) { return Number((wavelength - nm) * lobe(wavelength)); };
        cells.push_back({nm, Quadrature::integrate(lobe, from, to, most_bisections, tolerance),
                         Quadrature::integrate(ramp, from, to, most_bisections, tolerance)});
    }
    return cells;
}

/// Integral of the lobe times the piecewise linear function through the values.
inline Number integral_of(const std::vector<CellMoments>& cells, const std::vector<Number>& values, int first_nm) {
    Number sum = 0;
    for (const CellMoments& cell : cells) {
        const int i = cell.nm - first_nm;
        if (i < 0 || i + 1 >= static_cast<int>(values.size())) continue;
        const auto node = static_cast<std::size_t>(i);
        sum += values[node] * (cell.zeroth - cell.first) + values[node + 1] * cell.first;
    }
    return sum;
}

/// Tristimulus values of height times the lobe whose moments are given; Y = 1 for R = 1.
inline XyzNumbers reference_lobe_to_xyz(const Weights& weights, const std::vector<CellMoments>& cells, double height) {
    const Number scale = Number(height) / integral_of(weights.y);
    return {scale * integral_of(cells, weights.x, weights.first_nm),
            scale * integral_of(cells, weights.y, weights.first_nm),
            scale * integral_of(cells, weights.z, weights.first_nm)};
}

inline XyzNumbers reference_lobe_to_xyz(const Weights& weights, double peak_nm, double width_nm, double height) {
    return reference_lobe_to_xyz(weights, lobe_moments(peak_nm, width_nm, weights.first_nm, weights.last_nm()), height);
}

}  // namespace nacre::reference
