#include "nacre/colour/xyz_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace nacre {
namespace {

XyzCurve::Difference luminance_within(double tolerance) {
    return [=](const Xyz& one, const Xyz& other) { return std::abs(one.y - other.y) / tolerance; };
}

TEST(XyzCurveColours, AreCountedAsTheyAreComputed) {
    std::size_t asked = 0;
    const XyzCurve curve(
        [&](double x) {
            ++asked;
            const double wave = 0.5 + 0.5 * std::sin(40.0 * x);
            return Xyz{wave, wave, wave};
        },
        {0.0, 0.3, 1.0}, luminance_within(1e-6));
    EXPECT_EQ(curve.colours(), asked);
    EXPECT_GT(asked, 80U);  // 13 half waves, six points each at least
}

}  // namespace
}  // namespace nacre
