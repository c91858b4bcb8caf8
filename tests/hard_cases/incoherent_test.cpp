// Layers whose faces do not interfere: intensities are added, whatever coats the faces.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hard_cases/hard_case.h"

namespace nacre::hard_cases {
namespace {

const RefractiveIndex silver{0.05, 3.9};

TEST(IncoherentPlates, WithCoatingsOnEitherFaceAreExact) {
    Family family;
    for (const double k : {0.0, 1e-8, 1e-6, 1e-4}) {
        const RefractiveIndex glass{1.52, k};
        for (const double theta_deg : angles_to_grazing()) {
            family.expect_exact({"bare", Stack(1.0, 1.0).incoherent_layer(glass, 1e6), theta_deg});
            family.expect_exact(
                {"front", Stack(1.0, 1.0).layer(2.0, 70.0).layer(1.38, 90.0).incoherent_layer(glass, 1e6), theta_deg});
            family.expect_exact({"back",
                                 Stack(1.0, 1.0).incoherent_layer(glass, 1e6).layer(silver, 15.0).layer(1.38, 90.0),
                                 theta_deg});
            family.expect_exact({"both",
                                 Stack(1.0, 1.33)
                                     .layer(1.38, 90.0)
                                     .incoherent_layer(glass, 1e6)
                                     .layer({2.0, 0.01}, 70.0)
                                     .layer(silver, 10.0),
                                 theta_deg});
            family.expect_exact({"mirrored",
                                 Stack(1.0, 1.0)
                                     .incoherent_layer(glass, 1e6)
                                     .begin_group(30)
                                     .layer(2.3, 60.0)
                                     .layer(1.38, 100.0)
                                     .end_group(),
                                 theta_deg});
        }
    }
}

TEST(IncoherentPlates, InARowAndAtFrontAndBackAreExact) {
    Family family;
    for (const double theta_deg : angles_to_grazing()) {
        family.expect_exact({"double glazing",
                             Stack(1.0, 1.0)
                                 .layer(2.0, 20.0)
                                 .incoherent_layer({1.52, 1e-7}, 4e6)
                                 .layer(silver, 8.0)
                                 .incoherent_layer(1.0, 1.2e7)
                                 .incoherent_layer({1.52, 1e-7}, 4e6)
                                 .layer(1.38, 90.0),
                             theta_deg});
        Stack pile(1.0, 1.0);
        for (int i = 0; i < 50; ++i) pile.incoherent_layer(1.52, 1e5).incoherent_layer(1.0, 1e5);
        family.expect_exact({"pile of plates", pile, theta_deg});
        family.expect_exact(
            {"touching equals", Stack(1.0, 1.52).incoherent_layer(1.0, 1e6).incoherent_layer(1.52, 1e6), theta_deg});
    }
}

TEST(IncoherentPlates, FromAPrismAndIntoAMetalAreExact) {
    Family family;
    for (const double theta_deg : angles_to_grazing()) {
        family.expect_exact(
            {"prism", Stack(1.52, 1.52).layer(1.38, 90.0).incoherent_layer({1.6, 1e-7}, 1e6), theta_deg});
        family.expect_exact(
            {"on metal", Stack(1.0, silver).incoherent_layer({1.52, 1e-7}, 1e6).layer(1.7, 60.0), theta_deg});
        family.expect_exact(
            {"opaque", Stack(1.0, 1.52).layer(1.38, 90.0).incoherent_layer({1.52, 0.1}, 1e6), theta_deg});
    }
    // Total reflection within the prism: a millimetre of air, or of a hair's breadth of it, lets nothing through.
    for (const double theta_deg : {45.0, 60.0, 90.0}) {
        for (const double gap_nm : {1e5, 1e6}) {
            family.expect_exact({"gap", Stack(1.52, 1.52).layer(2.0, 60.0).incoherent_layer(1.0, gap_nm), theta_deg});
        }
    }
}

TEST(IncoherentPlates, AlongWhichTheWaveRunsLetNothingInAndAreExact) {
    // n = n0 sin(theta) to the last bit: q = 0 in the layer, and whatever is like it behind it. Conditioning is 1e-7.
    Family family;
    for (const double incident : {1.0, 1.52}) {
        for (const double theta_deg : {30.0, 40.0, 60.0}) {
            const double n = incident * std::sin(theta_deg * std::numbers::pi / 180.0);
            for (const double index : {n, std::nextafter(n, 0.0), std::nextafter(n, 9.0)}) {
                const Stack bare = Stack(incident, index).incoherent_layer(index, 1e6);
                const Stack coated = Stack(incident, index).layer(2.0, 70.0).incoherent_layer(index, 1e6);
                const Stack between = Stack(incident, incident).incoherent_layer(index, 1e6).layer(1.7, 50.0);
                const Stack two = Stack(incident, incident).incoherent_layer(index, 1e6).incoherent_layer(index, 1e5);
                for (const Stack& stack : {bare, coated, between, two}) {
                    family.expect_exact({"along", stack, theta_deg});
                }
            }
        }
    }
}

TEST(IncoherentPlates, LoseNothingWithoutAbsorption) {
    for (const double theta_deg : angles_to_grazing()) {
        const HardCase plate{"plate", Stack(1.0, 1.33).layer(1.38, 90.0).incoherent_layer(1.52, 1e6).layer(2.0, 70.0),
                             theta_deg};
        for (const Four& got : {scalar_response(plate), solver_response(plate)}) {
            EXPECT_NEAR(got[0] + got[2], 1.0, 1e-13) << theta_deg;
            EXPECT_NEAR(got[1] + got[3], 1.0, 1e-13) << theta_deg;
        }
    }
}

TEST(IncoherentPlates, AreTheMeanOfCoherentFringes) {
    // The mean over a whole fringe of a lossless plate is the sum of intensities (Born & Wolf, section 7.6). The mean
    // over 64 phases is the integral but for r^128 of the Fourier series: nothing.
    const double theta_deg = 40.0;
    const double q = std::sqrt(1.52 * 1.52 - std::pow(std::sin(theta_deg * std::numbers::pi / 180.0), 2));
    Four mean{};
    for (int i = 0; i < 64; ++i) {
        const double thickness_nm = 1000.0 + i / 64.0 * 500.0 / (2.0 * q);
        const Four got = solver_response(
            {"fringe", Stack(1.0, 1.33).layer(2.0, 70.0).layer(1.52, thickness_nm).layer(1.38, 90.0), theta_deg});
        for (std::size_t j = 0; j < 4; ++j) mean[j] += got[j] / 64.0;
    }
    const HardCase plate{"plate", Stack(1.0, 1.33).layer(2.0, 70.0).incoherent_layer(1.52, 1000.0).layer(1.38, 90.0),
                         theta_deg};
    for (const Four& got : {scalar_response(plate), solver_response(plate)}) {
        for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(got[j], mean[j], 1e-13) << j;
    }
}

}  // namespace
}  // namespace nacre::hard_cases
