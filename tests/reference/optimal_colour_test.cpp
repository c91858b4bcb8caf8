// The linear program is judged before it judges: by reflectances that are known to be optimal.
#include "reference/optimal_colour.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/dice.h"
#include "reference/lobe_integral.h"

namespace nacre::reference {
namespace {

class ReferenceOptimalColours : public testing::TestWithParam<const char*> {
protected:
    const ModelLight& light_ = ModelLight::of(GetParam(), 2);
    OptimalColours optimal_{light_};
    LobeIntegral integral_{light_};
};

Triple mixed(double share, const Triple& one, double other_share, const Triple& other) {
    Triple sum{};
    for (std::size_t c = 0; c < 3; ++c) sum[c] = share * one[c] + other_share * other[c];
    return sum;
}

TEST_P(ReferenceOptimalColours, WhiteIsTheBrightestGrey) {
    EXPECT_NEAR(optimal_.brightest_share(integral_.white()), 1.0, 1e-6);
    EXPECT_NEAR(optimal_.brightest_share(mixed(0.25, integral_.white(), 0.0, {})), 4.0, 4e-6);
    EXPECT_EQ(optimal_.brightest_share({}), 0.0);
}

// Schroedinger 1920: reflectances of 0 and 1 with two jumps are the brightest of their chromaticity, where the spectral
// locus is convex. The printed tables are not at its ends, where their last digit counts.
TEST_P(ReferenceOptimalColours, ReflectancesWithTwoJumpsAreOptimal) {
    Dice dice(11);
    for (int i = 0; i < 100; ++i) {
        const double from = dice.between(450.0, 540.0), to = dice.between(from + 20.0, 600.0);
        const Triple box = integral_(0.5 * (from + to), to - from, 1.0 - 1e-12);
        const Triple notch = mixed(1.0, integral_.white(), -1.0, box);
        EXPECT_NEAR(optimal_.brightest_share(box), 1.0, 1e-6) << from << ' ' << to;
        EXPECT_NEAR(optimal_.brightest_share(notch), 1.0, 1e-6) << from << ' ' << to;
        EXPECT_NEAR(optimal_.brightest_share(mixed(0.3, notch, 0.0, {})), 1.0 / 0.3, 4e-6) << from << ' ' << to;
    }
}

TEST_P(ReferenceOptimalColours, NoReflectanceIsBeyondTheBound) {
    Dice dice(12);
    for (int i = 0; i < 100; ++i) {
        const double floor = dice.unit(), height = dice.unit();
        const Triple band = integral_(dice.between(400.0, 700.0), dice.between(10.0, 300.0), dice.between(0.0, 0.9));
        const Triple other = integral_(dice.between(400.0, 700.0), dice.between(10.0, 300.0), dice.between(0.0, 0.9));
        const Triple one = mixed(floor, integral_.white(), height - floor, band);
        const Triple two = mixed(1.0 - floor, integral_.white(), floor - height, other);
        EXPECT_GE(optimal_.brightest_share(mixed(0.5, one, 0.5, two)), 1.0 - 1e-6);
    }
}

TEST_P(ReferenceOptimalColours, NothingIsOutsideTheSpectralLocus) {
    for (const auto& [x, y] : {std::pair{0.0, 0.9}, {0.8, 0.3}, {0.1, 0.0}, {0.3, -0.1}, {0.05, 0.2}, {0.45, 0.1}})
        EXPECT_NEAR(optimal_.brightest_share(from_chromaticity(x, y == 0.0 ? 1e-3 : y)), 0.0, 1e-5) << x << ' ' << y;
}

INSTANTIATE_TEST_SUITE_P(Lights, ReferenceOptimalColours, testing::Values("D65", "A", "E"),
                         [](const auto& light) { return std::string(light.param); });

}  // namespace
}  // namespace nacre::reference
