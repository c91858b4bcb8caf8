// Floor and flatness between picks and beyond them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/optics/palette.h"
#include "reference/number.h"
#include "reference/paper_palette.h"

namespace nacre {
namespace {

using reference::Number;

const Palette two_picks{{{0.0, {460.0, 70.0, 1.0, 0.05, 0.2}}, {40.0, {395.0, 60.0, 0.7, 0.3, 0.6}}}, 0.26};

// How far along the way from one pick to the next an angle is, by Y in 50 digits.
Number share_of_way(const Palette& palette, const Number& cos_theta) {
    const Number p(palette.shape);
    const Number first = reference::paper_shape(p, reference::cos_of_degrees(palette.picks[0].angle_deg));
    const Number second = reference::paper_shape(p, reference::cos_of_degrees(palette.picks[1].angle_deg));
    return (reference::paper_shape(p, cos_theta) - first) / (second - first);
}

// The angle at which that share is reached: the root of p c^2 + (1 - p) c = Y.
double angle_of_share(const Palette& palette, const Number& share) {
    const Number p(palette.shape);
    const Number first = reference::paper_shape(p, reference::cos_of_degrees(palette.picks[0].angle_deg));
    const Number second = reference::paper_shape(p, reference::cos_of_degrees(palette.picks[1].angle_deg));
    const Number y = first + share * (second - first);
    const Number cosine = 2 * y / (1 - p + sqrt((1 - p) * (1 - p) + 4 * p * y));
    return static_cast<double>(reference::degrees(acos(cosine)));
}

TEST(PaletteFloor, RunsOnAStraightLineAlongYWithFlatness) {
    for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 2.5) {
        const Incidence incidence = Incidence::from_degrees(theta_deg);
        const auto share = static_cast<double>(share_of_way(two_picks, reference::cos_of_degrees(theta_deg)));
        const Lobe unclamped = palette_lobe_unclamped(two_picks, incidence), lobe = palette_lobe(two_picks, incidence);
        EXPECT_NEAR(unclamped.floor, 0.05 + 0.25 * share, 1e-14) << theta_deg;
        EXPECT_NEAR(unclamped.flatness, 0.2 + 0.4 * share, 1e-14) << theta_deg;
        EXPECT_EQ(lobe.floor, std::clamp(unclamped.floor, 0.0, 1.0)) << theta_deg;
        EXPECT_EQ(lobe.flatness, std::clamp(unclamped.flatness, 0.0, 0.999)) << theta_deg;
    }
    // Beyond the second pick both run out of their ranges: what was clamped was seen.
    EXPECT_GT(palette_lobe_unclamped(two_picks, Incidence::from_degrees(90.0)).flatness, 1.2);
    EXPECT_EQ(palette_lobe(two_picks, Incidence::from_degrees(90.0)).flatness, 0.999);
}

TEST(PaletteFloor, OfSeveralPicksStaysBetweenItsNeighbours) {
    const Palette palette{{{0.0, {600.0, 90.0, 0.9, 0.0, 0.1}},
                           {25.0, {560.0, 120.0, 0.5, 0.4, 0.8}},
                           {50.0, {530.0, 80.0, 0.6, 0.45, 0.2}},
                           {80.0, {480.0, 100.0, 0.2, 0.9, 0.9}}}};
    for (std::size_t i = 0; i < palette.picks.size(); ++i) {
        EXPECT_EQ(palette_lobe(palette, Incidence::from_degrees(palette.picks[i].angle_deg)), palette.picks[i].lobe);
        if (i == 0) continue;
        const Pick &a = palette.picks[i - 1], &b = palette.picks[i];
        for (double t = 0.0; t <= 1.0; t += 0.05) {
            const Lobe lobe = palette_lobe(palette, Incidence::from_degrees(std::lerp(a.angle_deg, b.angle_deg, t)));
            const auto [low, high] = std::minmax(a.lobe.floor, b.lobe.floor);
            EXPECT_TRUE(lobe.floor >= low - 1e-15 && lobe.floor <= high + 1e-15) << i << ' ' << t;
            const auto [least, most] = std::minmax(a.lobe.flatness, b.lobe.flatness);
            EXPECT_TRUE(lobe.flatness >= least - 1e-15 && lobe.flatness <= most + 1e-15) << i << ' ' << t;
        }
    }
}

// Heights and widths that stay in their ranges, so that only floor or flatness can be clamped.
Palette with(double floor_1, double floor_2, double flatness_1, double flatness_2) {
    return {{{20.0, {530.0, 110.0, 0.5, floor_1, flatness_1}}, {60.0, {460.0, 110.0, 0.5, floor_2, flatness_2}}}};
}

void expect_clamped_above(const Palette& palette, const Number& share) {
    const double expected_deg = angle_of_share(palette, share);
    ASSERT_GT(expected_deg, 60.0);
    ASSERT_LT(expected_deg, 89.0);
    const ClampBounds bounds = palette_clamp_bounds(palette);
    EXPECT_FALSE(bounds.below_deg);
    ASSERT_TRUE(bounds.above_deg);
    EXPECT_NEAR(*bounds.above_deg, expected_deg, 1e-12);
    const auto bends = palette_bends_deg(palette);
    EXPECT_TRUE(std::any_of(bends.begin(), bends.end(), [&](double deg) {
        return std::abs(deg - expected_deg) < 1e-12;
    })) << expected_deg;
    EXPECT_EQ(bends.size(), 3u) << "the picks, and where clamping begins";
}

TEST(PaletteFloor, ClampingOfFloorAndFlatnessBeginsWhereTheLineLeavesTheRange) {
    expect_clamped_above(with(0.5, 0.1, 0.0, 0.0), Number(5) / 4);      // the floor reaches 0
    expect_clamped_above(with(0.4, 0.9, 0.0, 0.0), Number("1.2"));      // 1
    expect_clamped_above(with(0.0, 0.0, 0.6, 0.1), Number("1.2"));      // the flatness reaches 0
    expect_clamped_above(with(0.0, 0.0, 0.2, 0.8), Number(799) / 600);  // 0.999
    const ClampBounds below = palette_clamp_bounds(with(0.02, 0.9, 0.0, 0.0));
    ASSERT_TRUE(below.below_deg);
    EXPECT_NEAR(*below.below_deg, angle_of_share(with(0.02, 0.9, 0.0, 0.0), Number(-2) / 88), 1e-11);
    const ClampBounds none = palette_clamp_bounds(with(0.3, 0.32, 0.4, 0.42));
    EXPECT_FALSE(none.below_deg || none.above_deg);
}

TEST(PaletteFloor, LeavesPeakWidthAndHeightAsTheyWereBitByBit) {
    Palette plain = two_picks;
    for (Pick& pick : plain.picks) pick.lobe.floor = pick.lobe.flatness = 0.0;
    for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 0.5) {
        const Incidence incidence = Incidence::from_degrees(theta_deg);
        const Lobe one = palette_lobe(two_picks, incidence), other = palette_lobe(plain, incidence);
        EXPECT_EQ(one.peak_nm, other.peak_nm);
        EXPECT_EQ(one.width_nm, other.width_nm);
        EXPECT_EQ(one.height, other.height);
        EXPECT_EQ(other.floor, 0.0);
        EXPECT_EQ(other.flatness, 0.0);
    }
}

}  // namespace
}  // namespace nacre
