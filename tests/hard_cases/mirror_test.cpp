// Quarter-wave mirrors of 50 to 50 000 pairs. At the band's edge the eigenvalues of a period coincide: closed forms
// are nothing over nothing there, and R turns from 1 to fringes within 1 / pairs^2.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "hard_cases/hard_case.h"

namespace nacre::hard_cases {
namespace {

constexpr double centre_nm = 550.0;

Stack mirror(RefractiveIndex high, RefractiveIndex low, int pairs) {
    return Stack(1.0, 1.52)
        .begin_group(pairs)
        .layer(high, centre_nm / (4.0 * high.real()))
        .layer(low, centre_nm / (4.0 * low.real()))
        .end_group();
}

/// Both, at normal incidence: there cos(phase of a quarter wave) = +-(high - low) / (high + low).
/// Macleod, Thin-Film Optical Filters, 4th ed., section 6.2: the width of the high-reflectance zone.
std::vector<double> band_edges_nm(double high, double low) {
    const double phase = std::acos((high - low) / (high + low));
    return {centre_nm * std::numbers::pi / (2.0 * phase),
            centre_nm * std::numbers::pi / (2.0 * (std::numbers::pi - phase))};
}

struct Materials {
    const char* name;
    RefractiveIndex high, low;
};
const std::vector<Materials> materials{{"lossless", 2.3, 1.38},
                                       {"absorbing a little", {2.3, 1e-6}, {1.38, 1e-9}},
                                       {"weak contrast", 1.5, 1.46},
                                       {"weak contrast, absorbing", {1.5, 1e-4}, 1.46}};

TEST(QuarterWaveMirrors, AreExactAtTheCentreOfTheBand) {
    Family family(Measure::relative_in_transmittance);
    for (const Materials& of : materials) {
        for (const int pairs : {50, 500, 5000, 50000}) {
            for (const double theta_deg : {0.0, 40.0, 90.0}) {
                family.expect_exact({of.name, mirror(of.high, of.low, pairs), theta_deg, centre_nm});
            }
        }
    }
}

TEST(QuarterWaveMirrors, AreExactAtTheEdgeOfTheBandAndNextToIt) {
    Family family;
    for (const Materials& of : materials) {
        for (const int pairs : {50, 500, 5000, 50000}) {
            for (const double edge_nm : band_edges_nm(of.high.real(), of.low.real())) {
                for (const double relative : {0.0, 1e-15, -1e-15, 1e-10, -1e-10, 1e-6, -1e-6}) {
                    family.expect_exact({of.name, mirror(of.high, of.low, pairs), 0.0, edge_nm * (1.0 + relative)});
                }
            }
        }
    }
}

TEST(QuarterWaveMirrors, AreExactInTheFringesAndAtAnAngle) {
    Family family;
    for (const Materials& of : materials) {
        for (const int pairs : {50, 5000, 50000}) {
            for (const double wavelength_nm : {401.3, 470.0, 633.0, 701.0}) {
                for (const double theta_deg : {0.0, 35.0, 80.0, 89.9999}) {
                    family.expect_exact({of.name, mirror(of.high, of.low, pairs), theta_deg, wavelength_nm});
                }
            }
        }
    }
}

TEST(QuarterWaveMirrors, HaveTheClosedFormAtTheCentre) {
    // Born & Wolf section 1.6, equation (99). 1 - R would be lost in 1: T = 4 Y / (1 + Y)^2 tells.
    for (const int pairs : {1, 10, 50, 300}) {
        const double admittance = 1.52 * std::pow(2.3 / 1.38, 2 * pairs);
        const double transmittance = 4.0 * admittance / ((1.0 + admittance) * (1.0 + admittance));
        const HardCase lossless{"closed form", mirror(2.3, 1.38, pairs), 0.0, centre_nm};
        for (const Four& got : {scalar_response(lossless), solver_response(lossless)}) {
            // Powers of double: one rounding or two per pair.
            EXPECT_NEAR(got[2] / transmittance, 1.0, 1e-15 * (10 + 2 * pairs)) << pairs;
        }
    }
}

TEST(QuarterWaveMirrors, OfTwoThousandMillionPairsAreExactInPowers) {
    // No such thing exists; the powers of a period must not care. Not at the edge: there a fringe of so many pairs is
    // narrower than the last bit of the wavelength.
    Family family;
    for (const Materials& of : materials) {
        for (const int pairs : {1000000, 123456789, 2147483647}) {
            for (const double theta_deg : {0.0, 35.0, 90.0}) {
                family.expect_solver_exact({of.name, mirror(of.high, of.low, pairs), theta_deg, centre_nm});
                family.expect_solver_exact({of.name, mirror(of.high, of.low, pairs), theta_deg, 401.3});
            }
        }
    }
}

TEST(Groups, OfGroupsAreTheFlatOnes) {
    Family family;
    for (const RefractiveIndex high : {RefractiveIndex(2.3), RefractiveIndex(2.3, 1e-3)}) {
        const auto pair = [&](Stack& stack) { stack.layer(high, 60.0).layer(1.38, 100.0); };
        Stack flat(1.0, 1.52), nested(1.0, 1.52);
        for (int outer = 0; outer < 7; ++outer) {
            for (int inner = 0; inner < 30; ++inner) pair(flat);
            flat.layer(1.7, 40.0);
        }
        nested.begin_group(7).begin_group(30);
        pair(nested);
        nested.end_group().layer(1.7, 40.0).end_group();
        for (const double theta_deg : {0.0, 40.0, 80.0, 90.0}) {
            for (const double wavelength_nm : {420.0, 550.0, 611.0}) {
                const HardCase one{"nested", nested, theta_deg, wavelength_nm};
                const HardCase other{"flat", flat, theta_deg, wavelength_nm};
                family.expect_exact(one);
                expect_equal(one, scalar_response(one), scalar_response(other), "scalar");
                expect_equal(one, solver_response(one), solver_response(other), "solver");
            }
        }
    }
}

TEST(Groups, ThreeDeepSideBySideAndOfOneAreExact) {
    Family family;
    const Stack stack = Stack(1.0, 1.52)
                            .begin_group(3)
                            .layer(2.3, 20.0)
                            .begin_group(4)
                            .begin_group(11)
                            .layer(1.46, 45.0)
                            .layer({2.0, 1e-3}, 33.0)
                            .end_group()
                            .layer(1.38, 10.0)
                            .end_group()
                            .begin_group(1)
                            .layer(1.6, 5.0)
                            .end_group()
                            .end_group()
                            .begin_group(1000)
                            .layer(1.46, 70.0)
                            .end_group();
    for (const double theta_deg : angles_to_grazing()) family.expect_exact({"deep", stack, theta_deg});
}

TEST(Cavities, BetweenHighMirrorsAreExactOnAndOffTheirLine) {
    // A half wave between two mirrors of 15 pairs: T = 1 in a line of 1e-6 of the wavelength.
    Family family;
    for (const double k : {0.0, 1e-8, 1e-6}) {
        const RefractiveIndex high{2.3, k};
        const double high_nm = centre_nm / (4.0 * 2.3), low_nm = centre_nm / (4.0 * 1.38);
        const Stack cavity = Stack(1.52, 1.52)
                                 .begin_group(15)
                                 .layer(high, high_nm)
                                 .layer(1.38, low_nm)
                                 .end_group()
                                 .layer(high, 2.0 * high_nm)
                                 .begin_group(15)
                                 .layer(1.38, low_nm)
                                 .layer(high, high_nm)
                                 .end_group();
        for (const double relative : {0.0, 1e-15, 1e-10, 1e-8, 1e-7, -1e-7, 1e-6, 1e-4}) {
            family.expect_exact({"cavity", cavity, 0.0, centre_nm * (1.0 + relative)});
            family.expect_exact({"cavity", cavity, 20.0, centre_nm * (1.0 + relative)});
        }
    }
}

}  // namespace
}  // namespace nacre::hard_cases
