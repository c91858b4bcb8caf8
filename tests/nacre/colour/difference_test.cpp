#include "nacre/colour/difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

#include "reference/csv.h"

namespace nacre {
namespace {

TEST(Ciede2000, ThePublishedPairsHaveThePublishedDistancesInBothOrders) {
    const reference::Csv pairs = reference::read_csv("ciede2000_sharma34.csv");
    ASSERT_EQ(pairs.rows.size(), 34U);
    for (std::size_t i = 0; i < pairs.rows.size(); ++i) {
        const auto number = [&](const char* name) { return *pairs.number(i, name); };
        const Lab one{number("L1"), number("a1"), number("b1")};
        const Lab other{number("L2"), number("a2"), number("b2")};
        EXPECT_NEAR(ciede2000(one, other), number("dE00"), 1e-4) << "pair " << i + 1;
        EXPECT_NEAR(ciede2000(other, one), number("dE00"), 1e-4) << "pair " << i + 1;
        EXPECT_EQ(ciede2000(one, one), 0.0);
    }
}

TEST(Ciede2000, NeverExceedsItsBoundByTheEuclideanDistance) {
    std::mt19937_64 generator(2000);
    const auto within = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(generator() >> 11U) * 0x1p-53;
    };
    double largest = 0.0;
    for (int i = 0; i < 200000; ++i) {
        const Lab one{within(-1.0, 101.0), within(-130.0, 130.0), within(-130.0, 130.0)};
        const double step = std::pow(10.0, within(-6.0, 1.5));
        const Lab other{one.l + step * within(-1.0, 1.0), one.a + step * within(-1.0, 1.0),
                        one.b + step * within(-1.0, 1.0)};
        const double distance =
            std::sqrt((one.l - other.l) * (one.l - other.l) + (one.a - other.a) * (one.a - other.a) +
                      (one.b - other.b) * (one.b - other.b));
        largest = std::max(largest, ciede2000(one, other) / distance);
    }
    EXPECT_LT(largest, most_ciede2000_per_lab);
    EXPECT_GT(largest, 1.0);  // or the random colours miss what matters
}

TEST(Ciede2000, OfColoursTooNearToTellApartKeepsItsDigits) {
    // Scaling a small step scales the difference: what is left of it after rounding must not drown.
    const Lab one{40.0, 30.0, -50.0};
    const auto at = [&](double step) { return ciede2000(one, {one.l + step, one.a - 2.0 * step, one.b + step}); };
    EXPECT_NEAR(at(1e-7) / at(1e-5), 1e-2, 1e-8);
}

TEST(Lab, WhiteIsHundredBlackIsZeroAndBelowBlackGoesOnStraight) {
    const Lab white = to_lab(d65_white, d65_white);
    EXPECT_NEAR(white.l, 100.0, 1e-13);
    EXPECT_NEAR(white.a, 0.0, 1e-13);
    EXPECT_NEAR(white.b, 0.0, 1e-13);
    EXPECT_NEAR(to_lab({}, d65_white).l, 0.0, 1e-14);
    // CIE 15: L* = 903.3 Y below 0.008856, exactly (29/3)^3.
    const double per_luminance = std::pow(29.0 / 3.0, 3.0);
    for (const double y : {0.0088, 1e-4, -1e-3})
        EXPECT_NEAR(to_lab({y * d65_white.x, y, y * d65_white.z}, d65_white).l, per_luminance * y, 1e-12);
    EXPECT_NEAR(to_lab({0.18 * d65_white.x, 0.18, 0.18 * d65_white.z}, d65_white).l, 116.0 * std::cbrt(0.18) - 16.0,
                1e-12);
}

TEST(Lab, GoesBackToItsColour) {
    for (const Xyz& colour :
         {Xyz{}, d65_white, {0.3, 0.12, 0.3}, {0.001, 0.002, 0.003}, {1.8, 2.5, 0.9}, {-0.02, 0.01, -0.3}}) {
        const Xyz back = from_lab(to_lab(colour, d65_white), d65_white);
        EXPECT_NEAR(back.x, colour.x, 1e-14);
        EXPECT_NEAR(back.y, colour.y, 1e-14);
        EXPECT_NEAR(back.z, colour.z, 1e-14);
    }
}

}  // namespace
}  // namespace nacre
