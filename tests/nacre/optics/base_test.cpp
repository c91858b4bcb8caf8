// What lies below layers, and layers seen from below.
#include "nacre/optics/base.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <vector>

#include "nacre/optics/multilayer/multilayer.h"
#include "nacre/optics/reversed.h"

namespace nacre {
namespace {

// Kubelka and Munk 1931: of an opaque layer (1 - R)^2 / (2 R) = K / S.
TEST(PigmentBase, KeepsKubelkaAndMunksBalance) {
    for (const double k : {1e-9, 1e-4, 0.01, 0.3, 5.0}) {
        for (const double nm : {400.0, 550.0, 800.0}) {
            const PigmentBase base{RefractiveIndex(1.5, k), 0.7, 0.25};
            const double r = diffuse_reflectance(base, nm);
            const double absorption_per_um = 2.0 * 0.25 * 4.0 * std::numbers::pi * k / (nm / 1000.0);
            const double ratio = absorption_per_um / 0.7;
            ASSERT_GT(r, 0.0);
            ASSERT_LT(r, 1.0);
            // 1 - R loses the digits that R has in common with 1.
            const double digits = 1e-15 / (1.0 - r) + 1e-14;
            EXPECT_NEAR((1.0 - r) * (1.0 - r) / (2.0 * r) / ratio, 1.0, 4.0 * digits) << k << " " << nm;
        }
    }
}

TEST(PigmentBase, WithoutPigmentIsWhiteAndWithEndlessMuchIsBlack) {
    EXPECT_EQ(diffuse_reflectance(PigmentBase{Index(1.5), 1.0, 1.0}, 550.0), 1.0);
    EXPECT_EQ(diffuse_reflectance(PigmentBase{RefractiveIndex(1.5, 1.0), 1.0, 0.0}, 550.0), 1.0);
    // For large q it is 1 / (2 q): 1 + q - sqrt(q^2 + 2 q) would have no digit left of it.
    const double q = 2.0 * 4.0 * std::numbers::pi * 1000.0 / 0.55 / 1e-6;
    EXPECT_NEAR(diffuse_reflectance(PigmentBase{RefractiveIndex(1.5, 1000.0), 1e-6, 1.0}, 550.0) * 2.0 * q, 1.0, 1e-9);
}

TEST(RgbBase, IsASigmoidOfAParabola) {
    EXPECT_EQ(diffuse_reflectance(RgbBase{{}, {0.0, 0.0, 0.0}}, 500.0), 0.5);
    // x / sqrt(1 + x^2) of 3 / 4 is 3 / 5, of -4 / 3 is -4 / 5.
    EXPECT_NEAR(diffuse_reflectance(RgbBase{{}, {0.0, 0.0, 0.75}}, 700.0), 0.8, 1e-15);
    EXPECT_NEAR(diffuse_reflectance(RgbBase{{}, {0.0, 0.0, -4.0 / 3.0}}, 700.0), 0.1, 1e-15);
    // The parabola's argument is 0 at 360 nm, 1/2 in the middle and 1 at 830 nm.
    const RgbBase parabola{{}, {3.0, -2.0, 0.75}};
    EXPECT_NEAR(diffuse_reflectance(parabola, 360.0), 0.8, 1e-15);
    EXPECT_NEAR(diffuse_reflectance(parabola, 595.0), 0.5 + 0.5 * 0.5 / std::sqrt(1.25), 1e-15);
    EXPECT_NEAR(diffuse_reflectance(parabola, 830.0), 0.5 + 0.5 * 1.75 / std::sqrt(1.0 + 1.75 * 1.75), 1e-15);
}

TEST(SpectrumBase, IsStraightBetweenItsWavelengthsAndHeldBeyondThem) {
    const SpectrumBase base{{{450.0, 500.0, 600.0}, {0.2, 0.8, 0.4}}};
    EXPECT_EQ(diffuse_reflectance(base, 360.0), 0.2);
    EXPECT_EQ(diffuse_reflectance(base, 450.0), 0.2);
    EXPECT_NEAR(diffuse_reflectance(base, 475.0), 0.5, 1e-15);
    EXPECT_NEAR(diffuse_reflectance(base, 575.0), 0.5, 1e-15);
    EXPECT_EQ(diffuse_reflectance(base, 830.0), 0.4);
}

TEST(MetalBase, ScattersNothing) {
    EXPECT_EQ(diffuse_reflectance(MetalBase{RefractiveIndex(0.05, 3.6)}, 550.0), 0.0);
}

// ---- Seen from below ----

// Absorbing and clear, a group within a group, one incoherent layer.
LayerSystem uneven_system(bool absorbs) {
    LayerSystemBuilder builder(1.0, 1.5);
    builder.layer(RefractiveIndex(1.9, absorbs ? 0.1 : 0.0), 80.0);
    builder.begin_group(3);
    builder.layer(1.38, 95.0);
    builder.begin_group(2);
    builder.layer(2.3, 40.0);
    builder.layer(RefractiveIndex(1.6, absorbs ? 0.02 : 0.0), 30.0);
    builder.end_group();
    builder.end_group();
    builder.layer(1.52, 1e6, true);
    builder.layer(1.45, 130.0);
    return builder.take();
}

TEST(Reversed, TwiceIsTheSame) {
    const LayerSystem system = uneven_system(true);
    const LayerSystem back = reversed(reversed(system));
    EXPECT_EQ(back.nodes, system.nodes);
    EXPECT_EQ(back.media, system.media);
    EXPECT_EQ(back.incident, system.incident);
    EXPECT_EQ(back.substrate, system.substrate);
    EXPECT_NE(reversed(system).nodes, system.nodes);
}

TEST(Reversed, IsTheSystemWrittenFromBelow) {
    LayerSystemBuilder builder(1.5, 1.0);
    builder.layer(1.45, 130.0);
    builder.layer(1.52, 1e6, true);
    builder.begin_group(3);
    builder.begin_group(2);
    builder.layer(RefractiveIndex(1.6, 0.02), 30.0);
    builder.layer(2.3, 40.0);
    builder.end_group();
    builder.layer(1.38, 95.0);
    builder.end_group();
    builder.layer(RefractiveIndex(1.9, 0.1), 80.0);
    const LayerSystem written = builder.take();
    const LayerSystem turned = reversed(uneven_system(true));
    for (const double theta_deg : {0.0, 30.0, 60.0, 89.0}) {
        for (const double nm : {400.0, 555.0, 800.0}) {
            const Response one = multilayer_response(turned, Incidence::from_degrees(theta_deg), nm);
            const Response other = multilayer_response(written, Incidence::from_degrees(theta_deg), nm);
            EXPECT_DOUBLE_EQ(one.reflectance_s, other.reflectance_s);
            EXPECT_DOUBLE_EQ(one.reflectance_p, other.reflectance_p);
            EXPECT_DOUBLE_EQ(one.transmittance_s, other.transmittance_s);
            EXPECT_DOUBLE_EQ(one.transmittance_p, other.transmittance_p);
        }
    }
}

// Born & Wolf, 7th ed., 1.6.3: along one and the same path as much passes in either direction, whatever is absorbed;
// without absorption as much is reflected, too.
TEST(Reversed, LetsAsMuchThroughAlongTheSamePath) {
    for (const bool absorbs : {false, true}) {
        const LayerSystem system = uneven_system(absorbs);
        const LayerSystem below = reversed(system);
        for (const double theta_deg : {0.0, 20.0, 45.0, 70.0, 89.0, 89.99}) {
            const double sine = std::sin(theta_deg * std::numbers::pi / 180.0) / 1.5;  // Snell
            const Incidence inside = Incidence::from_cos(std::sqrt((1.0 - sine) * (1.0 + sine)));
            for (const double nm : {390.0, 480.0, 555.0, 640.0, 800.0}) {
                const Response down = multilayer_response(system, Incidence::from_degrees(theta_deg), nm);
                const Response up = multilayer_response(below, inside, nm);
                // The cosine inside has a rounding of 1e-16, which next to grazing is 1e-12 of the one in air.
                const double tolerance = theta_deg > 89.5 ? 1e-8 : 1e-11;
                EXPECT_NEAR(up.transmittance_s, down.transmittance_s, tolerance) << theta_deg << " " << nm;
                EXPECT_NEAR(up.transmittance_p, down.transmittance_p, tolerance) << theta_deg << " " << nm;
                if (absorbs) continue;
                EXPECT_NEAR(up.reflectance_s, down.reflectance_s, tolerance) << theta_deg << " " << nm;
                EXPECT_NEAR(up.reflectance_p, down.reflectance_p, tolerance) << theta_deg << " " << nm;
            }
        }
    }
}

TEST(Reversed, ReflectsEverythingBeyondTheCriticalAngle) {
    const LayerSystem below = reversed(uneven_system(false));
    for (const double theta_deg : {42.0, 60.0, 89.0}) {  // 1 / 1.5 is at 41.8 degrees
        const Response up = multilayer_response(below, Incidence::from_degrees(theta_deg), 555.0);
        EXPECT_NEAR(up.reflectance_s, 1.0, 1e-12);
        EXPECT_NEAR(up.reflectance_p, 1.0, 1e-12);
        EXPECT_EQ(up.transmittance_s, 0.0);
        EXPECT_EQ(up.transmittance_p, 0.0);
    }
}

}  // namespace
}  // namespace nacre
