#include "nacre/lut/axis_kinds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "nacre/optics/incidence.h"

namespace nacre {
namespace {

TEST(AxisKinds, TheDefaultIsTheSquareRootOfTheCosine) {
    EXPECT_EQ(axis_kinds().front().name, "sqrt_cos_theta");
}

TEST(AxisKinds, NamesAreDistinct) {
    std::set<std::string_view> names;
    for (const AxisKind& kind : axis_kinds()) names.insert(kind.name);
    EXPECT_EQ(names.size(), axis_kinds().size());
}

TEST(AxisKinds, EveryQuantityHasADefault) {
    EXPECT_EQ(default_axis_kind(Quantity::incidence).name, "sqrt_cos_theta");
    EXPECT_EQ(default_axis_kind(Quantity::grating_u).name, "grating_u");
    EXPECT_EQ(default_axis_kind(Quantity::cos_scatter).name, "cos_scatter");
}

// Cosines run over [0, 1], |sin theta_i + sin theta_o| over [0, 2], the cosine of a turn over [-1, 1]: their
// definitions.
TEST(AxisKinds, EveryAxisReachesItsEndsExactly) {
    for (const AxisKind& kind : axis_kinds()) {
        SCOPED_TRACE(kind.name);
        const double least = kind.quantity == Quantity::cos_scatter ? -1.0 : 0.0;
        const double most = kind.quantity == Quantity::grating_u ? 2.0 : 1.0;
        for (const double end : {0.0, 1.0}) {
            const double argument = kind.argument_at(end);
            EXPECT_TRUE(argument == least || argument == most) << argument;
            EXPECT_EQ(kind.coordinate(argument), end);
        }
        EXPECT_EQ(kind.high, most);
    }
}

TEST(AxisKinds, NoArgumentOfItsRangeLeavesTheTexture) {
    for (const AxisKind& kind : axis_kinds()) {
        SCOPED_TRACE(kind.name);
        for (int i = 0; i <= 1000; ++i) {
            const double coordinate = kind.coordinate(kind.low + (kind.high - kind.low) * (i / 1000.0));
            EXPECT_GE(coordinate, 0.0);
            EXPECT_LE(coordinate, 1.0);
        }
    }
}

// A cosine of 1 - u is stored to 1e-16, so an angle read from it is certain to 1e-16 / sin(theta): 2e-8 at worst.
TEST(AxisKinds, CoordinateAndArgumentAreInverse) {
    for (const AxisKind& kind : axis_kinds()) {
        SCOPED_TRACE(kind.name);
        for (int i = 0; i <= 10000; ++i) {
            const double coordinate = i / 10000.0;
            const double argument = kind.argument_at(coordinate);
            double tolerance = 1e-15;
            if (kind.quantity == Quantity::incidence) {
                const double sin_theta = std::sqrt((1.0 - argument) * (1.0 + argument));
                tolerance += 2e-16 / std::fmax(sin_theta, 1e-8);
            }
            ASSERT_NEAR(kind.coordinate(argument), coordinate, tolerance);
        }
    }
}

TEST(AxisKinds, AGratingIsAlikeOnEitherSide) {
    const AxisKind& grating_u = default_axis_kind(Quantity::grating_u);
    for (const double u : {0.0, 1e-9, 0.3, 1.0, 2.0}) EXPECT_EQ(grating_u.coordinate(-u), grating_u.coordinate(u));
    EXPECT_EQ(grating_u.low, -grating_u.high);
}

double argument_of(const Geometry& geometry, Quantity quantity) {
    if (quantity == Quantity::grating_u) return geometry.grating_u;
    return quantity == Quantity::cos_scatter ? geometry.cos_scatter : geometry.incidence.cos_theta;
}

// The same quantity by both members, to the rounding of one sine or square root.
TEST(AxisKinds, GeometryHasTheArgumentOfTheSameCoordinate) {
    for (const AxisKind& kind : axis_kinds()) {
        SCOPED_TRACE(kind.name);
        for (int i = 0; i <= 1000; ++i) {
            const double coordinate = i / 1000.0;
            ASSERT_NEAR(argument_of(kind.geometry(coordinate), kind.quantity), kind.argument_at(coordinate), 3e-16);
        }
    }
}

TEST(AxisKinds, ThetaIsTheAngleOfIncidenceOver90Degrees) {
    const AxisKind& theta_deg = axis_kinds()[2];
    ASSERT_EQ(theta_deg.name, "theta_deg");
    for (const double cos_theta : {0.0, 1e-12, 0.1, 0.5, 0.9, 1.0 - 1e-12, 1.0}) {
        EXPECT_NEAR(theta_deg.coordinate(cos_theta), Incidence::from_cos(cos_theta).theta_deg / 90.0, 1e-15);
    }
    EXPECT_NEAR(theta_deg.argument_at(60.0 / 90.0), 0.5, 1e-15);
}

TEST(Texels, TheFirstAndLastTexelAreTheEndsOfTheAxis) {
    EXPECT_EQ(coordinate_of_texel(0, 256), 0.0);
    EXPECT_EQ(coordinate_of_texel(255, 256), 1.0);
    EXPECT_EQ(coordinate_of_texel(0, 1), 0.0);
}

// OpenGL 4.5 specification, section 8.14: a linear filter returns texel i alone at u = (i + 0.5) / size.
TEST(Texels, ACoordinateOfATexelIsFetchedAtThatTexelsCentre) {
    for (const int size : {1, 2, 3, 64, 256}) {
        for (int texel = 0; texel < size; ++texel) {
            EXPECT_NEAR(texcoord_of(coordinate_of_texel(texel, size), size), (texel + 0.5) / size, 1e-15);
        }
    }
}

}  // namespace
}  // namespace nacre
