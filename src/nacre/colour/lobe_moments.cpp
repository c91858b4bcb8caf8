#include "nacre/colour/lobe_moments.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "nacre/colour/lobe_moments.cpp"
#include <hwy/foreach_target.h>  // compiles the rest of this file once per instruction set
#include <hwy/highway.h>

#include "nacre/colour/colour_types.h"

#ifndef NACRE_LOBE_TERMS
#define NACRE_LOBE_TERMS
namespace nacre {

// What a lobe is summed from: the table's nodes at its ends, and their factors.
struct LobeTerms {
    std::array<double, LobeMoments::powers> power;  // of (moment at last - moment at first)
    const LobeMoments::Node* first = nullptr;       // of the whole cells
    const LobeMoments::Node* last = nullptr;
    const LobeMoments::Node* before = nullptr;  // beyond the cells that the lobe's ends cut
    const LobeMoments::Node* after = nullptr;
    double at_first = 0.0;  // of the weights at these nodes
    double at_last = 0.0;
    double at_before = 0.0;
    double at_after = 0.0;
};

}  // namespace nacre
#endif

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// X, Y and Z side by side.
void sum_terms(const LobeTerms& terms, double* HWY_RESTRICT sum) {
    const hn::CappedTag<double, 4> d;
    const size_t lanes = hn::Lanes(d);
    for (size_t i = 0; i < 4; i += lanes) {
        const auto row = [&](const std::array<double, 4>& values) { return hn::LoadU(d, values.data() + i); };
        const auto term = [&](size_t m, auto so_far) {
            const auto difference = hn::Sub(row(terms.last->moment[m]), row(terms.first->moment[m]));
            return hn::MulAdd(hn::Set(d, terms.power[m]), difference, so_far);
        };
        // Two independent sums hide the latency of one.
        auto even = hn::Mul(hn::Set(d, terms.at_first), row(terms.first->weight));
        auto odd = hn::Mul(hn::Set(d, terms.at_last), row(terms.last->weight));
        even = hn::MulAdd(hn::Set(d, terms.at_before), row(terms.before->weight), even);
        odd = hn::MulAdd(hn::Set(d, terms.at_after), row(terms.after->weight), odd);
        for (size_t m = 0; m < LobeMoments::powers; m += 2) even = term(m, even);
        for (size_t m = 1; m < LobeMoments::powers; m += 2) odd = term(m, odd);
        hn::StoreU(hn::Add(even, odd), d, sum + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {
namespace {

HWY_EXPORT(sum_terms);

using Row = std::array<double, 4>;

// cos(pi u), |u| <= 1/2, as a polynomial in u^2: least squares over the interval (normal equations in 30 digits). It
// errs by up to 1.7e-5, but its error is orthogonal to every polynomial of degree 7: smooth weights do not see it.
constexpr std::array cosine{0.99999528268977207, -4.9341204061485167, 4.0436205188788770, -1.2293417005184344};

// Integral over one cell of (left + (right - left) s) t(s)^power, s from 0 to 1: Gauss-Legendre with 4 nodes is exact
// up to degree 7 (Abramowitz & Stegun, table 25.4).
void add_cell(const Row& left, const Row& right, double t_left, double t_step, LobeMoments::Node& node) {
    constexpr std::array<double, 2> abscissa{0.339981043584856265, 0.861136311594052575};
    constexpr std::array<double, 2> share{0.652145154862546143, 0.347854845137453857};
    for (std::size_t g = 0; g < 2; ++g) {
        for (const double sign : {-1.0, 1.0}) {
            const double s = 0.5 + 0.5 * sign * abscissa[g];
            double power = 0.5 * share[g];
            for (Row& moment : node.moment) {
                for (std::size_t i = 0; i < moment.size(); ++i)
                    moment[i] += power * (left[i] + s * (right[i] - left[i]));
                power *= t_left + s * t_step;
            }
        }
    }
}

// The polynomial about the lobe's peak, in powers of t.
//
// @param per_t   widths per unit of t
// @param peak_t  the peak
std::array<double, LobeMoments::powers> shifted_cosine(double per_t, double peak_t) {
    const double q = per_t * per_t;
    const double a1 = cosine[1] * q;
    const double a2 = cosine[2] * (q * q);
    const double a3 = cosine[3] * (q * q * q);
    const double p = peak_t * peak_t;
    return {cosine[0] + p * (a1 + p * (a2 + p * a3)),
            -peak_t * (2.0 * a1 + p * (4.0 * a2 + p * (6.0 * a3))),
            a1 + p * (6.0 * a2 + p * (15.0 * a3)),
            -peak_t * (4.0 * a2 + p * (20.0 * a3)),
            a2 + p * (15.0 * a3),
            -6.0 * peak_t * a3,
            a3};
}

// The cell that a lobe's end cuts: integral of sin(k s) times the weight over s in [0, length], from the end inwards,
// by the sine's first two terms. Gives the factors of the weights at the cell's nodes.
struct EndFactors {
    double inner;  // inside the lobe
    double outer;  // beyond its end
};
EndFactors end_factors(double k, double length) {
    const double square = length * length;
    const double kl2 = k * k * square;
    const double even = k * square * (0.5 - kl2 * (1.0 / 24.0));
    const double first = k * square * length * (1.0 / 3.0 - kl2 * (1.0 / 30.0));  // times s
    const double outer = length * even - first;
    return {even - outer, outer};
}

}  // namespace

LobeMoments make_lobe_moments(const TristimulusWeights& weights) {
    LobeMoments result;
    result.first_nm = weights.first_nm;
    result.last_nm = weights.last_nm;
    result.centre_nm = 0.5 * (weights.first_nm + weights.last_nm);
    result.half_range_nm = 0.5 * (weights.last_nm - weights.first_nm);
    result.per_half_range = 1.0 / result.half_range_nm;
    const auto count = static_cast<std::size_t>(weights.count());
    result.nodes.resize(count);
    LobeMoments::Node running{};
    for (std::size_t i = 0; i < count; ++i) {
        running.weight = {weights.x[i], weights.y[i], weights.z[i], 0.0};
        if (i > 0) {
            const double left_nm = weights.first_nm + static_cast<double>(i - 1);
            add_cell(result.nodes[i - 1].weight, running.weight, (left_nm - result.centre_nm) / result.half_range_nm,
                     1.0 / result.half_range_nm, running);
        }
        result.nodes[i] = running;
    }
    return result;
}

Xyz lobe_to_xyz_fast(const TristimulusWeights& weights, const LobeMoments& moments, double peak_nm, double width_nm,
                     double height) {
    assert(moments.first_nm == weights.first_nm && moments.last_nm == weights.last_nm);
    if (!(width_nm >= narrowest_fast_lobe_nm)) return lobe_to_xyz(weights, peak_nm, width_nm, height);
    // In nodes from here on.
    const double range = moments.last_nm - moments.first_nm;
    const double from = peak_nm - 0.5 * width_nm - moments.first_nm;
    const double to = peak_nm + 0.5 * width_nm - moments.first_nm;
    if (!(from < range && to > 0.0)) return {};

    const double per_width = 1.0 / width_nm;
    const double k = std::numbers::pi * per_width;
    const LobeMoments::Node* nodes = moments.nodes.data();
    LobeTerms terms;
    int first = 0;
    int last = moments.last_nm - moments.first_nm;
    if (from > 0.0) {
        const int cut = static_cast<int>(from);
        first = cut + 1;
        const EndFactors factors = end_factors(k, first - from);
        terms.at_first = factors.inner;
        terms.at_before = factors.outer;
        terms.before = nodes + cut;
    } else {
        terms.before = nodes;
    }
    if (to < range) {
        last = static_cast<int>(to);
        const EndFactors factors = end_factors(k, to - last);
        terms.at_last = factors.inner;
        terms.at_after = factors.outer;
        terms.after = nodes + last + 1;
    } else {
        terms.after = nodes + last;
    }
    if (last < first) return lobe_to_xyz(weights, peak_nm, width_nm, height);  // the range shows less than a cell of it
    terms.first = nodes + first;
    terms.last = nodes + last;
    terms.power =
        shifted_cosine(moments.half_range_nm * per_width, (peak_nm - moments.centre_nm) * moments.per_half_range);
    alignas(32) std::array<double, 4> sum;
    HWY_DYNAMIC_DISPATCH(sum_terms)(terms, sum.data());
    return {height * sum[0], height * sum[1], height * sum[2]};
}

}  // namespace nacre
#endif  // HWY_ONCE
