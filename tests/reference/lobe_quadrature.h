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

/// Moments of a band of height 1 with a plateau: 1 where |nm - peak| <= flatness width / 2, then a quarter of a cosine
/// down to 0 where |nm - peak| = width / 2 (Lobe in nacre/optics/lobe.h).
///
/// By antiderivatives in 50 digits, of which cancellation takes 15 at most for widths up to 1e5 nm; a cell that holds
/// the end of a piece is cut there. Judged by lobe_moments() and quadrature in tests/reference/palette_test.cpp.
class FlatBandMoments {
public:
    FlatBandMoments(double peak_nm, double width_nm, double flatness)
        : peak_(peak_nm), half_plateau_(Number(flatness) * width_nm / 2), half_width_(Number(width_nm) / 2) {}

    std::vector<CellMoments> cells(int first_nm = 360, int last_nm = 830) const {
        std::vector<CellMoments> found;
        if (!(half_width_ > 0)) return found;
        const Number left = peak_ - half_plateau_, right = peak_ + half_plateau_;
        add_shoulder(left, peak_ - half_width_, left, first_nm, last_nm, found);
        for_each_piece(left, right, first_nm, last_nm, [&](int nm, const Number& from, const Number& to) {
            const Number a = from - nm, b = to - nm;
            found.push_back({nm, b - a, (b - a) * (b + a) / 2});
        });
        add_shoulder(right, right, peak_ + half_width_, first_nm, last_nm, found);
        return found;
    }

private:
    template <typename Do>
    static void for_each_piece(const Number& from, const Number& to, int first_nm, int last_nm, const Do& act) {
        for (int nm = first_nm; nm < last_nm; ++nm) {
            const Number low = std::max<Number>(Number(nm), from), high = std::min<Number>(Number(nm + 1), to);
            if (low < high) act(nm, low, high);
        }
    }

    // Of cos(turns (nm - centre)): sin / turns, and (nm - cell) sin / turns + cos / turns^2.
    void add_shoulder(const Number& centre, const Number& begin, const Number& end, int first_nm, int last_nm,
                      std::vector<CellMoments>& found) const {
        const Number turns = pi() / (2 * (half_width_ - half_plateau_));
        const Number turn_cos = cos(turns), turn_sin = sin(turns);
        Number known(-1), known_cos, known_sin;  // of the place that the last piece ended at
        for_each_piece(begin, end, first_nm, last_nm, [&](int nm, const Number& from, const Number& to) {
            const Number from_cos = known == from ? known_cos : Number(cos(turns * (from - centre)));
            const Number from_sin = known == from ? known_sin : Number(sin(turns * (from - centre)));
            const bool is_whole = to - from == 1;
            known = to;
            known_cos =
                is_whole ? Number(from_cos * turn_cos - from_sin * turn_sin) : Number(cos(turns * (to - centre)));
            known_sin =
                is_whole ? Number(from_sin * turn_cos + from_cos * turn_sin) : Number(sin(turns * (to - centre)));
            found.push_back(
                {nm, (known_sin - from_sin) / turns,
                 ((to - nm) * known_sin - (from - nm) * from_sin) / turns + (known_cos - from_cos) / (turns * turns)});
        });
    }

    Number peak_, half_plateau_, half_width_;
};

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
