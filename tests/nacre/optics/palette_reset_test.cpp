// A palette curve that becomes another palette's, and the angles at which a palette turns sharply.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "nacre/optics/palette.h"
#include "reference/number.h"
#include "reference/paper_palette.h"

namespace nacre {
namespace {

using reference::Number;

const Pick green{10.0, {530.0, 110.0, 0.73}}, blue{60.0, {460.0, 110.0, 1.0}};
const Pick red{35.0, {640.0, 20.0, 0.2}}, violet{80.0, {410.0, 90.0, 0.1}};

Palette with_lobe(Palette palette, std::size_t pick, const Lobe& lobe) {
    palette.picks[pick].lobe = lobe;
    return palette;
}

TEST(PaletteCurve, ThatBecameAnothersPaletteKeepsNothingOfItsOwn) {
    const Palette two{{green, blue}, 0.9};
    const Palette three{{green, red, blue}, 0.9};
    const std::vector<Palette> palettes{
        two,
        with_lobe(two, 1, {300.0, 5.0, 0.4}),                    // the same angles: only a lobe moved
        with_lobe(with_lobe(two, 0, red.lobe), 1, violet.lobe),  // both
        {two.picks, 0.1},                                        // the same picks along another Y
        three,                                                   // one more pick, in between
        with_lobe(three, 1, {500.0, 60.0, 0.9}),                 // its slopes change
        {{red, blue, violet, green}, 0.9},                       // not by ascending angle
        with_lobe({{red, blue, violet, green}, 0.9}, 3, violet.lobe),
        {{green, green, blue}, 0.9},  // an angle twice
        two,                          // and back
        {{violet}, 0.9},              // the same lobe at every angle
        {{red}, 0.9},
        {{{20.0, red.lobe}, {20.0 + 1e-6, blue.lobe}}, 0.9},  // so near that cosines cancel
        {{{20.0, blue.lobe}, {20.0 + 1e-6, red.lobe}}, 0.9},
        {{violet, red}, 0.0},
        {{red, violet}, 0.0},
    };
    PaletteCurve reused(palettes.front());
    for (std::size_t i = 0; i < palettes.size(); ++i) {
        reused.reset(palettes[i]);
        const PaletteCurve fresh(palettes[i]);
        for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 1.25) {
            const Incidence incidence = Incidence::from_degrees(theta_deg);
            EXPECT_EQ(reused.unclamped(incidence), fresh.unclamped(incidence)) << i << ' ' << theta_deg;
            EXPECT_EQ(reused.at(incidence), fresh.at(incidence)) << i << ' ' << theta_deg;
        }
    }
}

TEST(PaletteCurve, ThatBecameAnothersPaletteIsThePapersModel) {
    PaletteCurve curve(Palette{{violet, red, green}, 0.5});
    for (const double peak_nm : {400.0, 461.0, 700.0}) {  // as along the axis picks[1].peak_nm
        const Palette palette{{green, {60.0, {peak_nm, 80.0, 0.9}}}, 0.26};
        curve.reset(palette);
        const reference::PaperPick one{10.0, 530.0, 110.0, 0.73}, two{60.0, peak_nm, 80.0, 0.9};
        for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 7.5) {
            const reference::LobeNumbers exact =
                reference::paper_lobe(one, two, 0.26, reference::cos_of_degrees(theta_deg));
            const Lobe lobe = curve.unclamped(Incidence::from_degrees(theta_deg));
            // Some ten roundings, t up to 2 in size.
            EXPECT_LT(reference::relative_distance(lobe.peak_nm, exact.peak_nm), 1e-14) << theta_deg;
            EXPECT_LT(reference::relative_distance(lobe.width_nm, exact.width_nm), 1e-14) << theta_deg;
            EXPECT_LT(reference::distance(lobe.height, exact.height), 1e-14) << theta_deg;
        }
    }
}

/// The angle at which two picks reach a number, from the root of p c^2 + (1 - p) c = Y in 50 digits.
double angle_of(const Palette& palette, double Lobe::*member, double value) {
    const Pick& one = palette.picks.at(0);
    const Pick& two = palette.picks.at(1);
    const Number p(palette.shape);
    const Number t = (Number(value) - one.lobe.*member) / (Number(two.lobe.*member) - one.lobe.*member);
    const Number shape_1 = reference::paper_shape(p, reference::cos_of_degrees(one.angle_deg));
    const Number shape_2 = reference::paper_shape(p, reference::cos_of_degrees(two.angle_deg));
    const Number target = shape_1 + t * (shape_2 - shape_1);
    const Number cos_theta = 2 * target / (1 - p + sqrt((1 - p) * (1 - p) + 4 * p * target));
    return static_cast<double>(reference::degrees(acos(cos_theta)));
}

/// Whether the angles are these, in whatever order, each to a tolerance.
void expect_angles(std::vector<double> angles_deg, std::vector<double> expected_deg, double tolerance_deg) {
    std::sort(angles_deg.begin(), angles_deg.end());
    std::sort(expected_deg.begin(), expected_deg.end());
    ASSERT_EQ(angles_deg.size(), expected_deg.size());
    for (std::size_t i = 0; i < angles_deg.size(); ++i) EXPECT_NEAR(angles_deg[i], expected_deg[i], tolerance_deg);
}

// Bisection to the last bits of an angle: 1.4e-14 of 90. Height rounds to 1.1e-16 and changes by some 0.005 per degree,
// width to 1.4e-14 and by 0.5 per degree: 3e-14.
constexpr double bisected_deg = 3e-13;

TEST(PaletteBends, AreThePicksAloneWhereASurfaceCanDoItAll) {
    expect_angles(palette_bends_deg({{{60.0, {460.0, 100.0, 0.7}}, green}, 0.9}), {60.0, 10.0}, 0.0);
    expect_angles(palette_bends_deg({{green, red, {50.0, {500.0, 70.0, 0.5}}, {85.0, {450.0, 70.0, 0.5}}}, 0.9}),
                  {10.0, 35.0, 50.0, 85.0}, 0.0);
    expect_angles(palette_bends_deg({{red}, 0.9}), {35.0}, 0.0);
}

TEST(PaletteBends, AreWhereTheHeightLeavesItsRangeOnEitherSide) {
    const Palette rising{{{20.0, {530.0, 110.0, 0.02}}, {60.0, {460.0, 110.0, 0.95}}}, 0.3};
    expect_angles(palette_bends_deg(rising),
                  {20.0, 60.0, angle_of(rising, &Lobe::height, 0.0), angle_of(rising, &Lobe::height, 1.0)},
                  bisected_deg);
    const Palette falling{{{20.0, {530.0, 110.0, 0.99}}, {60.0, {460.0, 110.0, 0.1}}}, 0.3};
    expect_angles(palette_bends_deg(falling),
                  {20.0, 60.0, angle_of(falling, &Lobe::height, 1.0), angle_of(falling, &Lobe::height, 0.0)},
                  bisected_deg);
}

TEST(PaletteBends, AreWhereTheWidthEndsBeforeTheHeightDoesAndAfterIt) {
    const Palette both{{{0.0, {460.0, 70.0, 1.0}}, {40.0, {395.0, 20.0, 0.25}}}, 0.2};
    const double no_height_deg = angle_of(both, &Lobe::height, 0.0);
    const double no_width_deg = angle_of(both, &Lobe::width_nm, 0.0);
    EXPECT_LT(no_height_deg, no_width_deg - 1.0);
    expect_angles(palette_bends_deg(both), {0.0, 40.0, no_height_deg, no_width_deg}, bisected_deg);
}

TEST(PaletteBends, OfTheBeetleAreWhereItReflectsAllAtItsSecondPick) {
    // Its second pick has height 1: clamping begins there, to the bisection's last bits.
    expect_angles(palette_bends_deg({{green, blue}, 0.91}), {10.0, 60.0, 60.0}, bisected_deg);
}

TEST(PaletteBends, BeyondManyPicksAreWhereTheOuterTwoPoint) {
    const Palette outer{{{50.0, {480.0, 40.0, 0.6}}, {70.0, {430.0, 10.0, 0.4}}}, 0.88};
    const Palette many{{{0.0, {600.0, 70.0, 0.5}}, {25.0, {560.0, 60.0, 0.5}}, outer.picks[0], outer.picks[1]}, 0.88};
    // Width ends beyond 70 degrees; nothing else leaves its range.
    expect_angles(palette_bends_deg(many), {0.0, 25.0, 50.0, 70.0, angle_of(outer, &Lobe::width_nm, 0.0)},
                  bisected_deg);
}

}  // namespace
}  // namespace nacre
