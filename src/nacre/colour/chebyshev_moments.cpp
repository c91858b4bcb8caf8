#include "nacre/colour/chebyshev_moments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nacre/base/gauss_points.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "nacre/colour/chebyshev_moments.cpp"
// A group of points keeps registers in arrays, so that their size has to be known.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>  // compiles the rest of this file once per instruction set
#include <hwy/highway.h>

// So many points go through the degrees together: each waits for its own polynomials, but not for the others'.
#ifndef NACRE_COLOUR_CHEBYSHEV_MOMENTS_GROUP
#define NACRE_COLOUR_CHEBYSHEV_MOMENTS_GROUP
namespace nacre {
namespace {
constexpr std::size_t group = 4;
constexpr std::size_t most_lanes = 8;
}  // namespace
}  // namespace nacre
#endif

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Adds what a group of points at `at`, whose weights are x, y, z, is to the moments.
void add_group(const double* HWY_RESTRICT at, const double* HWY_RESTRICT x, const double* HWY_RESTRICT y,
               const double* HWY_RESTRICT z, size_t degrees, double* HWY_RESTRICT sum_x, double* HWY_RESTRICT sum_y,
               double* HWY_RESTRICT sum_z) {
    const hn::CappedTag<double, most_lanes> d;
    const size_t lanes = hn::Lanes(d);
    // T(n + s) = 2 T(s) T(n) - T(n - s): from one register to the next, s being its lanes. T(-n) = T(n).
    hn::Vec<decltype(d)> twice_stride[group], now[group], before[group];
    for (size_t p = 0; p < group; ++p) {
        double polynomials[2 * most_lanes];  // T(-s) ... T(s - 1)
        double* const from_0 = polynomials + lanes;
        from_0[0] = 1.0;
        from_0[1] = at[p];
        for (size_t n = 2; n < lanes; ++n) from_0[n] = 2.0 * at[p] * from_0[n - 1] - from_0[n - 2];
        polynomials[0] = 2.0 * at[p] * from_0[lanes - 1] - (lanes > 1 ? from_0[lanes - 2] : at[p]);
        for (size_t n = 1; n < lanes; ++n) polynomials[n] = from_0[lanes - n];
        twice_stride[p] = hn::Set(d, 2.0 * polynomials[0]);
        now[p] = hn::LoadU(d, from_0);
        before[p] = hn::LoadU(d, polynomials);
    }
    for (size_t n = 0; n < degrees; n += lanes) {
        auto in_x = hn::LoadU(d, sum_x + n);
        auto in_y = hn::LoadU(d, sum_y + n);
        auto in_z = hn::LoadU(d, sum_z + n);
        for (size_t p = 0; p < group; ++p) {
            in_x = hn::MulAdd(hn::Set(d, x[p]), now[p], in_x);
            in_y = hn::MulAdd(hn::Set(d, y[p]), now[p], in_y);
            in_z = hn::MulAdd(hn::Set(d, z[p]), now[p], in_z);
            const auto next = hn::MulSub(twice_stride[p], now[p], before[p]);
            before[p] = now[p];
            now[p] = next;
        }
        hn::StoreU(in_x, d, sum_x + n);
        hn::StoreU(in_y, d, sum_y + n);
        hn::StoreU(in_z, d, sum_z + n);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {
namespace {

HWY_EXPORT(add_group);

// The polynomial of the last degree turns so far within a cell, in radians, for rules of four and of eight points to
// err by 1e-8 and 1e-10 of it; beyond, a cell is divided.
constexpr double phase_of_four = 1.5;
constexpr double phase_of_eight = 6.0;

// An end of a cell.
struct CellEnd {
    double nm;
    double phi;  // x = cos(phi)
};

// What is added to: points until they are a group, then the moments.
class Summation {
public:
    Summation(const TristimulusWeights& weights, const WavenumberPanel& panel, ChebyshevMoments& moments)
        : weights_(weights), panel_(panel), moments_(moments) {}

    void add_cell(const CellEnd& left, const CellEnd& right) {
        const double phase = std::abs(right.phi - left.phi) * moments_.degrees();
        const std::vector<GaussPoint>& rule = phase <= phase_of_four ? four_ : eight_;
        const int parts = std::max(1, static_cast<int>(std::ceil(phase / phase_of_eight)));
        const double from_first_nm = std::max(0.5 * (left.nm + right.nm) - weights_.first_nm, 0.0);
        const auto cell = std::min(static_cast<std::size_t>(from_first_nm * weights_.cells_per_nm),
                                   static_cast<std::size_t>(weights_.count()) - 2);
        const double part_nm = (right.nm - left.nm) / parts;
        for (int part = 0; part < parts; ++part) {
            for (const GaussPoint& point : rule)
                add_point(cell, left.nm + (part + point.at) * part_nm, point.weight * part_nm);
        }
    }

private:
    void add_point(std::size_t cell, double nm, double length_nm) {
        const double along =
            std::clamp(nm * weights_.cells_per_nm - weights_.first_cell() - static_cast<double>(cell), 0.0, 1.0);
        const double share = length_nm * weights_.cells_per_nm;
        at_[points_] = panel_.x(1.0 / nm);
        x_[points_] = share * std::lerp(weights_.x[cell], weights_.x[cell + 1], along);
        y_[points_] = share * std::lerp(weights_.y[cell], weights_.y[cell + 1], along);
        z_[points_] = share * std::lerp(weights_.z[cell], weights_.z[cell + 1], along);
        if (++points_ < group) return;  // rules are whole groups
        HWY_DYNAMIC_DISPATCH(add_group)
        (at_, x_, y_, z_, moments_.x.size(), moments_.x.data(), moments_.y.data(), moments_.z.data());
        points_ = 0;
    }

    const TristimulusWeights& weights_;
    const WavenumberPanel& panel_;
    ChebyshevMoments& moments_;
    std::vector<GaussPoint> four_ = unit_gauss_legendre(4);
    std::vector<GaussPoint> eight_ = unit_gauss_legendre(8);
    std::size_t points_ = 0;
    double at_[group], x_[group], y_[group], z_[group];
};

}  // namespace

double WavenumberPanel::x(double wavenumber) const {
    return std::clamp((2.0 * wavenumber - (from + to)) / (to - from), -1.0, 1.0);
}

ChebyshevMoments chebyshev_moments(const TristimulusWeights& weights, const WavenumberPanel& panel, int degrees) {
    const auto size = (static_cast<std::size_t>(degrees) + most_lanes - 1) / most_lanes * most_lanes;
    ChebyshevMoments moments{std::vector<double>(size), std::vector<double>(size), std::vector<double>(size)};
    Summation summation(weights, panel, moments);
    const auto end_at = [&](double nm) { return CellEnd{nm, std::acos(panel.x(1.0 / nm))}; };
    const double per_nm = weights.cells_per_nm;
    const double longest_nm = 1.0 / panel.from;
    CellEnd left = end_at(std::max(1.0 / panel.to, static_cast<double>(weights.first_nm)));
    while (left.nm < longest_nm) {
        const CellEnd right = end_at(std::min((std::floor(left.nm * per_nm + 1e-9) + 1.0) / per_nm, longest_nm));
        summation.add_cell(left, right);
        left = right;
    }
    return moments;
}

}  // namespace nacre
#endif  // HWY_ONCE
