#include "nacre/optics/palette.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>

namespace nacre {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

// Slope at an inner node: 0 at an extremum, else the weighted harmonic mean of the two secants, which never lets the
// cubic overshoot (Fritsch & Butland 1984, SIAM J. Sci. Stat. Comput. 5(2), equation 5).
double inner_slope(double left_step, double left_secant, double right_step, double right_secant) {
    if (!(left_secant * right_secant > 0.0)) return 0.0;
    const double left_weight = 2.0 * right_step + left_step;
    const double right_weight = right_step + 2.0 * left_step;
    return (left_weight + right_weight) / (left_weight / left_secant + right_weight / right_secant);
}

// The numbers that are interpolated alike.
constexpr std::array lobe_members{&Lobe::peak_nm, &Lobe::width_nm, &Lobe::height, &Lobe::floor, &Lobe::flatness};

// What a surface can have of them; the peak may be anywhere.
struct MemberRange {
    double Lobe::*member;
    double low;
    double high;
};
constexpr std::array member_ranges{MemberRange{&Lobe::width_nm, 0.0, std::numeric_limits<double>::infinity()},
                                   MemberRange{&Lobe::height, 0.0, 1.0}, MemberRange{&Lobe::floor, 0.0, 1.0},
                                   MemberRange{&Lobe::flatness, 0.0, largest_flatness}};

// Y(a) - Y(b) in which the cosines may cancel. Its rounding, 1e-16, is nothing beside steps of this length and more;
// shape_difference() is more expensive by two sines.
double plain_difference(double shape, const Incidence& a, const Incidence& b) {
    return (a.cos_theta - b.cos_theta) * (shape * (a.cos_theta + b.cos_theta) + (1.0 - shape));
}
constexpr double long_step = 0.01;

bool needs_clamping(const Lobe& lobe) {
    return std::any_of(member_ranges.begin(), member_ranges.end(), [&](const MemberRange& range) {
        return lobe.*range.member < range.low || lobe.*range.member > range.high;
    });
}

}  // namespace

double shape_difference(double shape, const Incidence& a, const Incidence& b) {
    const double half_sum = 0.5 * (a.theta_deg + b.theta_deg) * radians_per_degree;
    const double half_difference = 0.5 * (a.theta_deg - b.theta_deg) * radians_per_degree;
    const double cosines = -2.0 * std::sin(half_sum) * std::sin(half_difference);
    return cosines * (shape * (a.cos_theta + b.cos_theta) + (1.0 - shape));
}

PaletteCurve::PaletteCurve(const Palette& palette) {
    reset(palette);
}

// Where only lobes move, as along most axes, angles and steps are known.
bool PaletteCurve::has_angles_of(const Palette& palette) const {
    return palette.shape == shape_ &&
           std::equal(palette.picks.begin(), palette.picks.end(), nodes_.begin(), nodes_.end(),
                      [](const Pick& pick, const Node& node) { return pick.angle_deg == node.at.theta_deg; });
}

void PaletteCurve::reset(const Palette& palette) {
    assert(!palette.picks.empty());
    if (has_angles_of(palette)) {
        for (std::size_t i = 0; i < nodes_.size(); ++i) nodes_[i].lobe = palette.picks[i].lobe;
    } else {
        set_angles(palette);
    }
    set_slopes();
}

void PaletteCurve::set_angles(const Palette& palette) {
    shape_ = palette.shape;
    nodes_.clear();
    for (const Pick& pick : palette.picks)
        nodes_.push_back({Incidence::from_degrees(pick.angle_deg), pick.lobe, 0.0, {}});
    // Picks at one angle are equal, so their order does not matter.
    std::sort(nodes_.begin(), nodes_.end(),
              [](const Node& a, const Node& b) { return a.at.theta_deg < b.at.theta_deg; });
    const auto same_angle = [](const Node& a, const Node& b) { return a.at.theta_deg == b.at.theta_deg; };
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end(), same_angle), nodes_.end());
    const std::size_t last = nodes_.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        // By the very formula that differences from the node are taken with, so that a pick is met exactly.
        nodes_[i].step = plain_difference(shape_, nodes_[i + 1].at, nodes_[i].at);
        if (std::abs(nodes_[i].step) < long_step)
            nodes_[i].step = shape_difference(shape_, nodes_[i + 1].at, nodes_[i].at);
    }
}

void PaletteCurve::set_slopes() {
    const std::size_t last = nodes_.size() - 1;
    if (last < 2) return;
    for (const auto member : lobe_members) {
        const auto secant = [&](std::size_t i) {
            return (nodes_[i + 1].lobe.*member - nodes_[i].lobe.*member) / nodes_[i].step;
        };
        // At an end: the neighbouring secant, so that beyond it the curve goes on as the nearest two picks point.
        nodes_.front().slope.*member = secant(0);
        nodes_.back().slope.*member = secant(last - 1);
        for (std::size_t i = 1; i < last; ++i) {
            nodes_[i].slope.*member = inner_slope(nodes_[i - 1].step, secant(i - 1), nodes_[i].step, secant(i));
        }
    }
}

double PaletteCurve::difference_from(const Node& node, const Incidence& incidence) const {
    return std::abs(node.step) < long_step ? shape_difference(shape_, incidence, node.at)
                                           : plain_difference(shape_, incidence, node.at);
}

Lobe PaletteCurve::unclamped(const Incidence& incidence) const {
    if (nodes_.size() == 1) return nodes_.front().lobe;
    std::size_t i = 0;
    while (i + 2 < nodes_.size() && incidence.theta_deg > nodes_[i + 1].at.theta_deg) ++i;
    const Node& left = nodes_[i];
    const Node& right = nodes_[i + 1];
    const double t = difference_from(left, incidence) / left.step;
    Lobe lobe;
    for (const auto member : lobe_members) {
        const double v0 = left.lobe.*member;
        const double v1 = right.lobe.*member;
        const double m0 = left.slope.*member * left.step;  // per unit of t
        const double m1 = right.slope.*member * left.step;
        if (nodes_.size() == 2) {
            lobe.*member = std::lerp(v0, v1, t);
        } else if (t <= 0.0) {
            lobe.*member = v0 + t * m0;
        } else if (t >= 1.0) {
            lobe.*member = v1 + (t - 1.0) * m1;
        } else {
            const double rest = 1.0 - t;
            lobe.*member =
                v0 * rest * rest * (1.0 + 2.0 * t) + v1 * t * t * (3.0 - 2.0 * t) + t * rest * (m0 * rest - m1 * t);
        }
    }
    return lobe;
}

Lobe PaletteCurve::at(const Incidence& incidence) const {
    Lobe lobe = unclamped(incidence);
    for (const MemberRange& range : member_ranges)
        lobe.*range.member = std::clamp(lobe.*range.member, range.low, range.high);
    return lobe;
}

Lobe palette_lobe_unclamped(const Palette& palette, const Incidence& incidence) {
    return PaletteCurve(palette).unclamped(incidence);
}

Lobe palette_lobe(const Palette& palette, const Incidence& incidence) {
    return PaletteCurve(palette).at(incidence);
}

namespace {

// Beyond an outer pick all numbers are monotone in the angle, so bisection finds the one crossing.
//
// @param is_beyond  what no surface can do, false at inside_deg
// @return the first angle found beyond; nothing if not even outside_deg is
template <typename IsBeyond>
std::optional<double> crossing_deg(const PaletteCurve& curve, double inside_deg, double outside_deg,
                                   IsBeyond is_beyond) {
    const auto beyond = [&](double angle_deg) {
        return is_beyond(curve.unclamped(Incidence::from_degrees(angle_deg)));
    };
    if (!beyond(outside_deg)) return std::nullopt;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle_deg = 0.5 * (inside_deg + outside_deg);
        (beyond(middle_deg) ? outside_deg : inside_deg) = middle_deg;
    }
    return outside_deg;
}

struct OuterPicks {
    double first_deg, last_deg;
};

OuterPicks outer_picks(const Palette& palette) {
    const auto [first, last] =
        std::minmax_element(palette.picks.begin(), palette.picks.end(),
                            [](const Pick& a, const Pick& b) { return a.angle_deg < b.angle_deg; });
    return {first->angle_deg, last->angle_deg};
}

}  // namespace

ClampBounds palette_clamp_bounds(const Palette& palette) {
    const PaletteCurve curve(palette);
    const OuterPicks outer = outer_picks(palette);
    return {crossing_deg(curve, outer.first_deg, 0.0, needs_clamping),
            crossing_deg(curve, outer.last_deg, 90.0, needs_clamping)};
}

std::vector<double> palette_bends_deg(const Palette& palette) {
    const PaletteCurve curve(palette);
    const OuterPicks outer = outer_picks(palette);
    std::vector<double> kinks_deg;
    for (const Pick& pick : palette.picks) kinks_deg.push_back(pick.angle_deg);
    const auto add_crossings = [&](auto is_beyond) {
        if (const auto below = crossing_deg(curve, outer.first_deg, 0.0, is_beyond)) kinks_deg.push_back(*below);
        if (const auto above = crossing_deg(curve, outer.last_deg, 90.0, is_beyond)) kinks_deg.push_back(*above);
    };
    for (const MemberRange& range : member_ranges) {
        add_crossings([&](const Lobe& lobe) { return lobe.*range.member < range.low; });
        add_crossings([&](const Lobe& lobe) { return lobe.*range.member > range.high; });
    }
    return kinks_deg;
}

}  // namespace nacre
