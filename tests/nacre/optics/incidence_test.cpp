#include "nacre/optics/incidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/number.h"

namespace nacre {
namespace {

using reference::Number;
using reference::relative_distance;

// A conversion is one exact or nearly exact subtraction, one product with pi / 180 and one library function:
// a handful of roundings of 1.1e-16 each.
constexpr double few_roundings = 1e-15;

/// Numbers in [0, 1] that crowd towards both ends: 2^-k, 1 - 2^-k, and an even spread.
std::vector<double> numbers_from_0_to_1() {
    std::vector<double> numbers;
    for (int k = 1; k <= 52; ++k) {
        numbers.push_back(std::ldexp(1.0, -k));
        numbers.push_back(1.0 - std::ldexp(1.0, -k));
        numbers.push_back(std::ldexp(1.2345, -k));
        numbers.push_back(1.0 - std::ldexp(1.2345, -k - 1));
    }
    reference::Uniform uniform(2);
    for (int i = 0; i < 1000; ++i) numbers.push_back(uniform.between(0.0, 1.0));
    return numbers;
}

TEST(Incidence, GrazingIsExactlyZeroCosineAndNormalExactlyOne) {
    EXPECT_EQ(Incidence::from_degrees(90.0).cos_theta, 0.0);
    EXPECT_EQ(Incidence::from_cos(0.0).theta_deg, 90.0);
    EXPECT_EQ(Incidence::from_sqrt_cos(0.0).theta_deg, 90.0);
    EXPECT_EQ(Incidence::from_sqrt_cos(0.0).cos_theta, 0.0);
    EXPECT_EQ(Incidence::from_degrees(0.0).cos_theta, 1.0);
    EXPECT_EQ(Incidence::from_cos(1.0).theta_deg, 0.0);
    EXPECT_EQ(Incidence::from_sqrt_cos(1.0).theta_deg, 0.0);
    EXPECT_EQ(Incidence::from_sqrt_cos(1.0).cos_theta, 1.0);
}

TEST(Incidence, KeepsTheNumberThatItWasMadeFrom) {
    for (const double u : numbers_from_0_to_1()) {
        EXPECT_EQ(Incidence::from_degrees(90.0 * u).theta_deg, 90.0 * u);
        EXPECT_EQ(Incidence::from_cos(u).cos_theta, u);
    }
}

TEST(Incidence, CosineOfDegreesKeepsAllDigitsUpToGrazing) {
    for (const double u : numbers_from_0_to_1()) {
        const double theta_deg = 90.0 * u;
        EXPECT_LT(relative_distance(Incidence::from_degrees(theta_deg).cos_theta, reference::cos_of_degrees(theta_deg)),
                  few_roundings)
            << theta_deg;
    }
}

TEST(Incidence, AngleOfACosineKeepsAllDigitsDownToTheNormal) {
    for (const double cos_theta : numbers_from_0_to_1()) {
        EXPECT_LT(
            relative_distance(Incidence::from_cos(cos_theta).theta_deg, reference::degrees(acos(Number(cos_theta)))),
            few_roundings)
            << cos_theta;
    }
}

TEST(Incidence, SquareRootOfTheCosineKeepsAllDigitsAtBothEnds) {
    for (const double root : numbers_from_0_to_1()) {
        const Incidence incidence = Incidence::from_sqrt_cos(root);
        const Number cos_theta = Number(root) * root;
        EXPECT_LT(relative_distance(incidence.cos_theta, cos_theta), few_roundings) << root;
        EXPECT_LT(relative_distance(incidence.theta_deg, reference::degrees(acos(cos_theta))), few_roundings) << root;
    }
}

TEST(Incidence, StaysWithinItsRanges) {
    for (const double u : numbers_from_0_to_1()) {
        for (const Incidence& incidence :
             {Incidence::from_degrees(90.0 * u), Incidence::from_cos(u), Incidence::from_sqrt_cos(u)}) {
            EXPECT_GE(incidence.theta_deg, 0.0);
            EXPECT_LE(incidence.theta_deg, 90.0);
            EXPECT_GE(incidence.cos_theta, 0.0);
            EXPECT_LE(incidence.cos_theta, 1.0);
        }
    }
}

}  // namespace
}  // namespace nacre
