// Where a palette asks for what no surface can do.
#include <gtest/gtest.h>

#include <algorithm>

#include "nacre/optics/palette.h"
#include "reference/number.h"
#include "reference/paper_palette.h"

namespace nacre {
namespace {

using reference::Number;

// The paper's Morpho with p = 0.2: it asks for less than nothing at grazing. (With the default p its height stops at
// 0.23.)
const Palette dim_morpho{{{0.0, {460.0, 70.0, 1.0}}, {40.0, {395.0, 60.0, 0.7}}}, 0.2};
// The paper's beetle asks for more than everything beyond its second pick, at any p.
const Palette beetle{{{10.0, {530.0, 110.0, 0.73}}, {60.0, {460.0, 110.0, 1.0}}}};

Lobe lobe_at(const Palette& palette, double theta_deg) {
    return palette_lobe_unclamped(palette, Incidence::from_degrees(theta_deg));
}

TEST(Palette, BeyondThePicksIsClampedToWhatASurfaceCanReflect) {
    EXPECT_LT(lobe_at(dim_morpho, 90.0).height, -0.05);
    EXPECT_GT(lobe_at(beetle, 80.0).height, 1.05);
    const Palette narrow{{{0.0, {460.0, 70.0, 1.0}}, {40.0, {440.0, 30.0, 0.9}}}};
    EXPECT_LT(lobe_at(narrow, 90.0).width_nm, -10.0);
    for (const Palette& palette : {dim_morpho, beetle, narrow}) {
        const PaletteCurve curve(palette);
        for (double theta_deg = 0.0; theta_deg <= 90.0; theta_deg += 0.5) {
            const Incidence incidence = Incidence::from_degrees(theta_deg);
            const Lobe wanted = palette_lobe_unclamped(palette, incidence), lobe = palette_lobe(palette, incidence);
            EXPECT_EQ(lobe.peak_nm, wanted.peak_nm) << theta_deg;
            EXPECT_EQ(lobe.height, std::clamp(wanted.height, 0.0, 1.0)) << theta_deg;
            EXPECT_EQ(lobe.width_nm, std::max(wanted.width_nm, 0.0)) << theta_deg;
            EXPECT_EQ(curve.at(incidence), lobe) << theta_deg;
            EXPECT_EQ(curve.unclamped(incidence), wanted) << theta_deg;
        }
    }
}

/// The angle at which two picks reach a height, from the root of p c^2 + (1 - p) c = Y in 50 digits.
double angle_of_height(const Palette& palette, double height) {
    const Pick& one = palette.picks.at(0);
    const Pick& two = palette.picks.at(1);
    const Number p(palette.shape), t = (Number(height) - one.lobe.height) / (Number(two.lobe.height) - one.lobe.height);
    const Number shape_1 = reference::paper_shape(p, reference::cos_of_degrees(one.angle_deg));
    const Number shape_2 = reference::paper_shape(p, reference::cos_of_degrees(two.angle_deg));
    const Number target = shape_1 + t * (shape_2 - shape_1);
    const Number cos_theta = 2 * target / (1 - p + sqrt((1 - p) * (1 - p) + 4 * p * target));
    return static_cast<double>(reference::degrees(acos(cos_theta)));
}

TEST(Palette, ClampingBeginsWhereTheStraightLineLeavesTheRange) {
    const ClampBounds morpho_bounds = palette_clamp_bounds(dim_morpho);
    EXPECT_FALSE(morpho_bounds.below_deg);
    ASSERT_TRUE(morpho_bounds.above_deg);
    EXPECT_GT(*morpho_bounds.above_deg, 80.0);
    // Height rounds to 1.1e-16 and changes by 0.006 per degree there: 2e-14 degrees, and a bit of 90 is 1.4e-14.
    EXPECT_NEAR(*morpho_bounds.above_deg, angle_of_height(dim_morpho, 0.0), 1e-13);

    const Palette bright{{{20.0, {530.0, 110.0, 0.95}}, {60.0, {460.0, 110.0, 0.6}}}};
    ASSERT_TRUE(palette_clamp_bounds(bright).below_deg);
    EXPECT_GT(*palette_clamp_bounds(bright).below_deg, 1.0);
    // At 9 degrees the height changes by 0.002 per degree: 1e-13 degrees, three times over.
    EXPECT_NEAR(*palette_clamp_bounds(bright).below_deg, angle_of_height(bright, 1.0), 3e-13);

    const ClampBounds beetle_bounds = palette_clamp_bounds(beetle);  // its second pick reflects all
    ASSERT_TRUE(beetle_bounds.above_deg);
    EXPECT_NEAR(*beetle_bounds.above_deg, 60.0, 1e-13);
    EXPECT_FALSE(beetle_bounds.below_deg);

    const ClampBounds constant = palette_clamp_bounds({{{30.0, {500.0, 70.0, 1.0}}}});
    EXPECT_FALSE(constant.below_deg || constant.above_deg);
}

}  // namespace
}  // namespace nacre
