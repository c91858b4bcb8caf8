// Films whose answer a textbook gives: sliced films, thick glass, Brewster's angle, antireflection, absentee layers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hard_cases/hard_case.h"

namespace nacre::hard_cases {
namespace {

TEST(Slices, TenThousandOfAFilmAreTheFilm) {
    // Slices of 1/16 nm, so that their sum is the film's thickness to the last bit.
    Family family;
    for (const RefractiveIndex index : {RefractiveIndex(1.9), RefractiveIndex(1.9, 0.02), RefractiveIndex(0.05, 3.9)}) {
        Stack sliced(1.0, 1.52);
        for (int i = 0; i < 10000; ++i) sliced.layer(index, 0.0625);
        for (const double theta_deg : {0.0, 50.0, 89.9999, 90.0}) {
            const HardCase slices{"slices", sliced, theta_deg};
            const HardCase whole{"whole", Stack(1.0, 1.52).layer(index, 625.0), theta_deg};
            const HardCase group{"group", Stack(1.0, 1.52).begin_group(10000).layer(index, 0.0625).end_group(),
                                 theta_deg};
            family.expect_exact(whole);
            family.expect_exact(group);
            // As many layers as the group has, and so as many roundings.
            expect_equal(group, scalar_response(slices), exact_four(whole), "scalar");
            expect_equal(group, solver_response(slices), exact_four(whole), "solver");
        }
    }
}

TEST(ThickGlass, TenMillimetresAreExact) {
    // 60 000 waves: a half-ulp of anything is 1e-11 of a fringe.
    Family family;
    for (const double k : {0.0, 1e-8, 1e-6, 1e-3}) {
        for (const double theta_deg : angles_to_grazing()) {
            family.expect_exact({"glass", Stack(1.0, 1.0).layer({1.52, k}, 1e7), theta_deg, 550.0});
            family.expect_exact({"coated glass",
                                 Stack(1.0, 1.0).layer(1.38, 100.0).layer({1.52, k}, 1e7).layer(2.0, 70.0), theta_deg,
                                 550.0});
        }
    }
}

TEST(ThickGlass, UpToAMetreIsExact) {
    // Phases beyond a million radians, where sines are computed another way; in the first, in some lanes only.
    Family family;
    for (const double thickness_nm : {3.18e7, 1e9}) {
        for (const double theta_deg : {0.0, 20.0, 70.0, 89.9999}) {
            family.expect_exact({"glass", Stack(1.0, 1.7).layer(1.5, thickness_nm), theta_deg});
            family.expect_exact({"slightly absorbing", Stack(1.0, 1.7).layer({1.5, 1e-9}, thickness_nm), theta_deg});
        }
    }
}

TEST(BrewstersAngle, ReflectsNothingOfP) {
    Family family;
    for (const double n : {1.33, 1.52, 2.4, 4.0}) {
        const double brewster_deg = std::atan(n) * 180.0 / std::numbers::pi;
        const HardCase surface{"surface", Stack(1.0, n), brewster_deg};
        family.expect_exact(surface);
        // The rounding of the angle, squared; four roundings of the fields, squared.
        EXPECT_LT(scalar_response(surface)[1], 1e-28) << n;
        EXPECT_LT(solver_response(surface)[1], 1e-28) << n;
        // A plate at Brewster's angle has two such faces and no fringes.
        const HardCase plate{"plate", Stack(1.0, 1.0).layer(n, 1234.5), brewster_deg};
        family.expect_exact(plate);
        EXPECT_LT(scalar_response(plate)[1], 1e-28) << n;
        EXPECT_LT(solver_response(plate)[1], 1e-28) << n;
    }
}

TEST(Antireflection, AQuarterWaveOfTheRootReflectsNothing) {
    Family family;
    for (const double substrate : {1.52, 2.4, 4.0}) {
        const double film = std::sqrt(substrate);
        const HardCase coated{"coated", Stack(1.0, substrate).layer(film, 550.0 / (4.0 * film)), 0.0, 550.0};
        family.expect_exact(coated);
        for (const Four& got : {scalar_response(coated), solver_response(coated)}) {
            EXPECT_LT(got[0], 1e-30) << substrate;  // a few roundings of the amplitude, squared
            EXPECT_LT(got[1], 1e-30) << substrate;
            EXPECT_NEAR(got[2], 1.0, 1e-15) << substrate;
        }
    }
}

TEST(HalfWaves, AreAbsent) {
    Family family;
    for (const double film : {1.38, 2.4, 4.0}) {
        for (const int halves : {1, 2, 1000}) {
            const HardCase with{"with", Stack(1.0, 1.52).layer(film, halves * 550.0 / (2.0 * film)), 0.0, 550.0};
            const HardCase without{"without", Stack(1.0, 1.52), 0.0, 550.0};
            family.expect_exact(with);
            expect_equal(with, scalar_response(with), exact_four(without), "scalar");
            expect_equal(with, solver_response(with), exact_four(without), "solver");
        }
    }
}

TEST(PrismIncidence, AnythingButAirIsExactToo) {
    Family family;
    for (const double prism : {1.33, 1.52, 2.4}) {
        for (const double theta_deg : angles_to_grazing()) {
            const Stack coated = Stack(prism, 1.7).layer(1.38, 90.0).layer({2.4, 0.01}, 55.0);
            family.expect_exact({"into flint", coated, theta_deg});
            family.expect_exact({"into air", Stack(prism, 1.0).layer(2.4, 55.0).layer(1.38, 90.0), theta_deg});
            family.expect_exact({"into silver", Stack(prism, {0.05, 3.9}).layer(1.38, 90.0), theta_deg});
        }
    }
}

}  // namespace
}  // namespace nacre::hard_cases
