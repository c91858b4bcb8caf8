// Waves that cannot go on: total reflection, tunnelling through gaps, and the angle at which a wave runs along its
// layer (q = 0), where half of all formulas divide by nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "hard_cases/hard_case.h"

namespace nacre::hard_cases {
namespace {

/// In degrees, rounded; the reference knows the angle that the double is.
double critical_angle(double from, double into) {
    return std::asin(into / from) * 180.0 / std::numbers::pi;
}

std::vector<double> around(double value, double relative) {
    return {value, value * (1.0 + relative), value * (1.0 - relative)};
}

TEST(TotalReflection, FromGlassIntoAirIsExactOnBothSidesOfTheCriticalAngle) {
    // At the critical angle R leaves 1 as the root of the distance: conditioning is 1e-8 there.
    Family family;
    const double critical_deg = critical_angle(1.52, 1.0);
    for (const double relative : {0.0, 1e-15, 1e-14, 1e-12, 1e-9, 1e-6, 1e-3, 0.1}) {
        for (const double theta_deg : around(critical_deg, relative)) {
            family.expect_exact({"glass", Stack(1.52, 1.0), theta_deg});
            family.expect_exact({"coated glass", Stack(1.52, 1.0).layer(2.0, 61.0).layer(1.38, 90.0), theta_deg});
            family.expect_exact(
                {"mirror", Stack(1.52, 1.0).begin_group(20).layer(2.0, 61.0).layer(1.38, 90.0).end_group(), theta_deg});
        }
    }
}

TEST(TotalReflection, ReflectsEverything) {
    for (const double theta_deg : {42.0, 60.0, 89.0, 90.0}) {
        const HardCase glass{"glass", Stack(1.52, 1.0).layer(2.0, 61.0), theta_deg};
        for (const Four& got : {scalar_response(glass), solver_response(glass)}) {
            EXPECT_NEAR(got[0], 1.0, 1e-14) << theta_deg;
            EXPECT_NEAR(got[1], 1.0, 1e-14) << theta_deg;
            EXPECT_EQ(got[2], 0.0) << theta_deg;
            EXPECT_EQ(got[3], 0.0) << theta_deg;
        }
    }
}

TEST(FrustratedTotalReflection, GapsFromNothingToAMillimetreAreExact) {
    // T falls to exp(-20 000): every digit of it counts as long as a double can hold it.
    Family family(Measure::relative_in_transmittance);
    for (const double gap_nm : {0.0, 1e-6, 1.0, 50.0, 500.0, 2e3, 2e4, 1e5, 1e6}) {
        for (const double theta_deg : {41.2, 45.0, 60.0, 85.0, 89.9999, 90.0}) {
            family.expect_exact({"gap", Stack(1.52, 1.52).layer(1.0, gap_nm), theta_deg});
            family.expect_exact({"gap and film", Stack(1.52, 1.7).layer(1.0, gap_nm).layer(2.0, 70.0), theta_deg});
            family.expect_exact(
                {"two gaps", Stack(1.52, 1.52).layer(1.0, gap_nm).layer(1.52, 300.0).layer(1.0, gap_nm), theta_deg});
        }
    }
}

TEST(FrustratedTotalReflection, AResonanceBetweenTwoGapsIsExact) {
    // A waveguide mode coupled through two gaps: T = 1 in a line of relative width exp(-2 Im a) in the midst of R = 1.
    Family family;
    for (const double gap_nm : {300.0, 900.0, 1500.0}) {
        for (double theta_deg = 50.0; theta_deg < 60.0; theta_deg += 0.37) {
            family.expect_exact(
                {"guide", Stack(1.8, 1.8).layer(1.0, gap_nm).layer(1.8, 700.0).layer(1.0, gap_nm), theta_deg});
        }
    }
}

TEST(WaveAlongALayer, ALayerAtItsCriticalAngleIsExact) {
    // 30 degrees and indices 2 : 1 are q = 0 up to the rounding of pi alone; others up to that of the angle.
    Family family;
    for (const double n : {1.0, 1.2, 1.46}) {
        const double incident = 2.0 * n;
        for (const double relative : {0.0, 1e-16, 1e-14, 1e-12, 1e-8}) {
            for (const double index : around(n, relative)) {
                for (const double thickness_nm : {1.0, 70.0, 5e3, 1e6}) {
                    family.expect_exact({"layer", Stack(incident, incident).layer(index, thickness_nm), 30.0});
                    family.expect_exact(
                        {"under a film", Stack(incident, 1.9).layer(2.3, 50.0).layer(index, thickness_nm), 30.0});
                    family.expect_exact({"in a group",
                                         Stack(incident, incident)
                                             .begin_group(50)
                                             .layer(index, thickness_nm)
                                             .layer(2.3, 50.0)
                                             .end_group(),
                                         30.0});
                }
            }
        }
    }
}

TEST(WaveAlongALayer, TheLayersCriticalAngleIsExact) {
    Family family;
    const double critical_deg = critical_angle(1.52, 1.33);
    for (const double relative : {0.0, 2e-16, 1e-14, 1e-12, 1e-9, 1e-5}) {
        for (const double theta_deg : around(critical_deg, relative)) {
            for (const double thickness_nm : {10.0, 1e3, 1e5}) {
                family.expect_exact({"water", Stack(1.52, 1.52).layer(1.33, thickness_nm), theta_deg});
                family.expect_exact(
                    {"weakly absorbing water", Stack(1.52, 1.52).layer({1.33, 1e-9}, thickness_nm), theta_deg});
            }
        }
    }
}

TEST(WaveAlongALayer, GrazingInTheIncidentMediumIsAlongLayersOfItsIndex) {
    Family family;
    for (const double step : {0.0, 1e-14, -1e-14, 1e-9, -1e-9}) {
        for (const double theta_deg : {89.9999, 89.999999999, 90.0}) {
            family.expect_exact({"air layer", Stack(1.0, 1.52).layer(1.0 + step, 400.0).layer(1.38, 90.0), theta_deg});
            family.expect_exact(
                {"air gap", Stack(1.0, 1.0).layer(1.38, 90.0).layer(1.0 + step, 400.0).layer(1.38, 90.0), theta_deg});
        }
    }
}

}  // namespace
}  // namespace nacre::hard_cases
