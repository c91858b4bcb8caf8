// The ends of the angle: at grazing a cosine vanishes and every front face becomes a mirror within fractions of a
// degree; at the normal s and p become one.
#include <gtest/gtest.h>

#include <vector>

#include "hard_cases/hard_case.h"

namespace nacre::hard_cases {
namespace {

std::vector<HardCase> everyday_stacks() {
    const RefractiveIndex silver{0.05, 3.9}, titania{2.4, 1e-4};
    return {
        {"bare glass", Stack(1.0, 1.52)},
        {"film on glass", Stack(1.0, 1.52).layer(1.38, 100.0)},
        {"film on a lighter substrate", Stack(1.0, 1.2).layer(2.4, 83.0)},
        {"soap film", Stack(1.0, 1.0).layer(1.33, 320.0)},
        {"silver", Stack(1.0, silver)},
        {"oxide on silver", Stack(1.0, silver).layer(1.77, 120.0)},
        {"five layers", Stack(1.0, 1.52)
                            .layer(titania, 51.0)
                            .layer(1.46, 86.0)
                            .layer(titania, 51.0)
                            .layer(1.46, 172.0)
                            .layer(titania, 51.0)},
        {"forty pairs", Stack(1.0, 1.52).begin_group(40).layer(titania, 60.0).layer(1.46, 90.0).end_group()},
        {"from glass into air through a film", Stack(1.52, 1.0).layer(2.0, 61.0)},
        {"air layer as the first", Stack(1.0, 1.52).layer(1.0, 700.0).layer(2.0, 61.0)},
    };
}

TEST(Grazing, EverydayStacksAreExactFromTheNormalToNinetyDegrees) {
    Family family;
    for (HardCase hard_case : everyday_stacks()) {
        for (const double theta_deg : angles_to_grazing()) {
            hard_case.theta_deg = theta_deg;
            family.expect_exact(hard_case);
        }
    }
}

TEST(Grazing, AtNinetyDegreesEverythingIsAMirror) {
    for (HardCase hard_case : everyday_stacks()) {
        hard_case.theta_deg = 90.0;
        for (const Four& got : {scalar_response(hard_case), solver_response(hard_case)}) {
            // The limit is 1 and 0; four roundings may stand beside it.
            EXPECT_NEAR(got[0], 1.0, 1e-15) << hard_case.name;
            EXPECT_NEAR(got[1], 1.0, 1e-15) << hard_case.name;
            EXPECT_NEAR(got[2], 0.0, 1e-15) << hard_case.name;
            EXPECT_NEAR(got[3], 0.0, 1e-15) << hard_case.name;
        }
    }
}

TEST(Grazing, TransmittanceVanishesWithTheCosine) {
    // Far below 1e-12, where only a relative measure sees anything: T goes as cos(theta).
    Family family(Measure::relative_in_transmittance);
    for (HardCase hard_case : everyday_stacks()) {
        for (const double theta_deg : {89.0, 89.9999, 89.999999999, 89.9999999999}) {
            hard_case.theta_deg = theta_deg;
            family.expect_exact(hard_case);
        }
    }
}

TEST(Grazing, AtTheNormalSAndPAreOne) {
    for (const HardCase& hard_case : everyday_stacks()) {
        for (const Four& got : {scalar_response(hard_case), solver_response(hard_case)}) {
            // Two roads of the same some hundred roundings.
            EXPECT_NEAR(got[0], got[1], 1e-13) << hard_case.name;
            EXPECT_NEAR(got[2], got[3], 1e-13) << hard_case.name;
        }
    }
}

}  // namespace
}  // namespace nacre::hard_cases
