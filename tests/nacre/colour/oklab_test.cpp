#include "nacre/colour/oklab.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/rgb_space.h"

namespace nacre {
namespace {

void expect_near(const Oklab& one, const Oklab& other, double tolerance) {
    EXPECT_NEAR(one.lightness, other.lightness, tolerance);
    EXPECT_NEAR(one.a, other.a, tolerance);
    EXPECT_NEAR(one.b, other.b, tolerance);
}

// bottosson.github.io/posts/oklab, "Table of example XYZ and Oklab pairs": three decimals.
TEST(Oklab, OfTheColoursInOttossonsTableIsWhatHePrints) {
    constexpr double half_a_digit = 0.5001e-3;
    expect_near(xyz_to_oklab({0.950, 1.000, 1.089}), {1.000, 0.000, 0.000}, half_a_digit);
    expect_near(xyz_to_oklab({1.000, 0.000, 0.000}), {0.450, 1.236, -0.019}, half_a_digit);
    expect_near(xyz_to_oklab({0.000, 1.000, 0.000}), {0.922, -0.671, 0.263}, half_a_digit);
    expect_near(xyz_to_oklab({0.000, 0.000, 1.000}), {0.153, -1.415, -0.449}, half_a_digit);
}

// W3C, CSS Color 4, oklch() of the named colours red, lime and blue: five decimals.
TEST(Oklab, OfTheSrgbPrimariesIsWhatCssPrints) {
    struct Row {
        Rgb rgb;
        double lightness, chroma, hue_deg;
    };
    const glm::dmat3 xyz_of_rec709 = glm::inverse(xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene")));
    for (const Row& row : {Row{{1.0, 0.0, 0.0}, 0.62796, 0.25768, 29.234},
                           {{0.0, 1.0, 0.0}, 0.86644, 0.29483, 142.495},
                           {{0.0, 0.0, 1.0}, 0.45201, 0.31321, 264.052}}) {
        const Oklab lab = xyz_to_oklab(adapt(xyz_of_rec709, {row.rgb.r, row.rgb.g, row.rgb.b}));
        const double hue_deg = std::atan2(lab.b, lab.a) * 180.0 / std::numbers::pi;
        EXPECT_NEAR(lab.lightness, row.lightness, 1e-5);
        EXPECT_NEAR(std::hypot(lab.a, lab.b), row.chroma, 1e-5);
        EXPECT_NEAR(hue_deg < 0.0 ? hue_deg + 360.0 : hue_deg, row.hue_deg, 1e-3);
    }
}

TEST(Oklab, WhiteIsOneAndGreyIsItsCubeRoot) {
    expect_near(xyz_to_oklab(d65_white), {1.0, 0.0, 0.0}, 1e-15);
    expect_near(xyz_to_oklab(xyz_from_chromaticity(d65_chromaticity, 0.125)), {0.5, 0.0, 0.0}, 1e-15);
    EXPECT_EQ(xyz_to_oklab({}), Oklab{});
}

TEST(Oklab, ThereAndBackIsTheSameColourEvenAnImaginaryOne) {
    for (const Xyz& colour : {Xyz{0.3, 0.2, 0.1}, {1.7, 0.02, 9.0}, {0.0, 0.0, 1.0}, {-0.2, 0.4, 1.0}, {}}) {
        const Xyz back = oklab_to_xyz(xyz_to_oklab(colour));
        const double size = std::abs(colour.x) + std::abs(colour.y) + std::abs(colour.z);
        EXPECT_NEAR(back.x, colour.x, 1e-14 * size);
        EXPECT_NEAR(back.y, colour.y, 1e-14 * size);
        EXPECT_NEAR(back.z, colour.z, 1e-14 * size);
    }
}

}  // namespace
}  // namespace nacre
