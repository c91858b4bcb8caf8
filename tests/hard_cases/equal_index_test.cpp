// Where nothing is to be seen, or hardly anything, or nothing else: equal indices, no thickness, tiny steps, k from
// 1e-12 to 1e6.
#include <gtest/gtest.h>

#include "hard_cases/hard_case.h"

namespace nacre::hard_cases {
namespace {

void expect_nothing(const HardCase& hard_case) {
    for (const Four& got : {scalar_response(hard_case), solver_response(hard_case)}) {
        // No face reflects, at any angle, grazing included: only roundings are left, some per layer.
        EXPECT_NEAR(got[0], 0.0, base_tolerance) << hard_case.name << " at " << hard_case.theta_deg;
        EXPECT_NEAR(got[1], 0.0, base_tolerance) << hard_case.name << " at " << hard_case.theta_deg;
        EXPECT_NEAR(got[2], 1.0, base_tolerance) << hard_case.name << " at " << hard_case.theta_deg;
        EXPECT_NEAR(got[3], 1.0, base_tolerance) << hard_case.name << " at " << hard_case.theta_deg;
    }
}

TEST(EqualIndices, ReflectNothingAtAnyAngle) {
    for (const double theta_deg : angles_to_grazing()) {
        for (const double n : {1.0, 1.52, 2.4}) {
            expect_nothing({"no layer", Stack(n, n), theta_deg});
            expect_nothing({"one layer", Stack(n, n).layer(n, 137.0), theta_deg});
            expect_nothing({"two layers", Stack(n, n).layer(n, 137.0).layer(n, 1e6), theta_deg});
            expect_nothing(
                {"a group", Stack(n, n).begin_group(1000).layer(n, 137.0).layer(n, 0.0).end_group(), theta_deg});
            expect_nothing({"incoherent", Stack(n, n).incoherent_layer(n, 1e6), theta_deg});
        }
    }
}

TEST(EqualIndices, TheIncidentMediumAsALayerIsAWayOnly) {
    Family family;
    for (const double theta_deg : angles_to_grazing()) {
        for (const double n : {1.0, 1.52}) {
            family.expect_exact({"before a film", Stack(n, 2.0).layer(n, 1e5).layer(1.7, 90.0), theta_deg});
            family.expect_exact(
                {"between films", Stack(n, n).layer(1.8, 90.0).layer(n, 300.0).layer(1.8, 90.0), theta_deg});
            family.expect_exact({"as the substrate", Stack(n, n).layer(1.8, 90.0), theta_deg});
        }
    }
}

TEST(ZeroThickness, IsAsIfTheLayerWereNotThere) {
    const RefractiveIndex silver{0.05, 3.9};
    for (const double theta_deg : angles_to_grazing()) {
        const HardCase without{"without", Stack(1.0, 1.52).layer(1.38, 90.0), theta_deg};
        for (const RefractiveIndex ghost : {RefractiveIndex(2.4), RefractiveIndex(1.0), silver}) {
            const HardCase with{"with", Stack(1.0, 1.52).layer(ghost, 0.0).layer(1.38, 90.0).layer(ghost, 0.0),
                                theta_deg};
            expect_equal(with, scalar_response(with), scalar_response(without), "scalar");
            expect_equal(with, solver_response(with), solver_response(without), "solver");
        }
    }
}

TEST(ZeroThickness, IsExact) {
    Family family;
    for (const double theta_deg : angles_to_grazing()) {
        for (const double thickness_nm : {0.0, 1e-300, 1e-9, 1e-3}) {
            family.expect_exact({"ghost", Stack(1.0, 1.52).layer(2.4, thickness_nm), theta_deg});
            family.expect_exact(
                {"ghosts", Stack(1.0, 1.52).begin_group(1000).layer({0.05, 3.9}, thickness_nm).end_group(), theta_deg});
        }
    }
}

TEST(TinySteps, OfTheIndexAreExact) {
    Family family;
    for (const double theta_deg : angles_to_grazing()) {
        for (const double step : {1e-15, 1e-12, 1e-9, 1e-6, -1e-9}) {
            family.expect_exact({"step", Stack(1.0, 1.0 + step), theta_deg});
            family.expect_exact({"layer", Stack(1.5, 1.5).layer(1.5 + step, 200.0), theta_deg});
            family.expect_exact({"rugate",
                                 Stack(1.5, 1.5).begin_group(5000).layer(1.5 + step, 83.0).layer(1.5, 84.0).end_group(),
                                 theta_deg});
        }
    }
}

TEST(ExtremeAbsorption, FromOneInABillionToAPerfectConductorIsExact) {
    Family family;
    for (const double theta_deg : angles_to_grazing()) {
        for (const double k : {1e-300, 1e-12, 1e-6, 1.0, 1e3, 1e6}) {
            const RefractiveIndex index{1.5, k};
            family.expect_exact({"substrate", Stack(1.0, index).layer(1.38, 90.0), theta_deg});
            family.expect_exact({"film", Stack(1.0, 1.52).layer(index, 40.0), theta_deg});
            family.expect_exact({"thin film", Stack(1.0, 1.52).layer(index, 1e-4), theta_deg});
            family.expect_exact({"a millimetre", Stack(1.0, 1.52).layer(index, 1e6), theta_deg});
            family.expect_exact({"under air", Stack(1.0, index).layer(1.0, 250.0).layer(index, 20.0), theta_deg});
        }
    }
}

}  // namespace
}  // namespace nacre::hard_cases
