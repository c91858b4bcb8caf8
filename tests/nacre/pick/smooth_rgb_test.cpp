// What lies below the layers: reflectances for colours, against the CIE's tables by hand.
#include "nacre/pick/smooth_rgb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/observer.h"
#include "nacre/scene/readers/index_keys.h"

namespace nacre {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& matrix, const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
    return result;
}

// Linear Rec.709 to XYZ for the white (0.3127, 0.3290): the rationals that CSS Color Module Level 4 prints, section
// "Sample code for Color Conversions", lin_sRGB_to_XYZ.
constexpr Matrix rec709_to_xyz{{{506752.0 / 1228815, 87881.0 / 245763, 12673.0 / 70218},
                                {87098.0 / 409605, 175762.0 / 245763, 12673.0 / 175545},
                                {7918.0 / 409605, 87881.0 / 737289, 1001167.0 / 1053270}}};
// The cones of Bradford, as the ICC profile specification prints them.
constexpr Matrix cones{{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

// The trapezium rule over whole nanometres of what the CIE prints; nothing of the code that is tested but the
// reflectance itself.
Triple xyz_of(const Base& base) {
    const SampledCurve d65 = *illuminant_by_name("D65");
    Triple sum{};
    double perfect = 0.0;
    for (int nm = 360; nm <= 830; ++nm) {
        const Triple& seen = colour_matching(Observer::cie1931_2deg, nm);
        const double light = (nm == 360 || nm == 830 ? 0.5 : 1.0) * d65.at(nm);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += diffuse_reflectance(base, nm) * light * seen[i];
        perfect += light * seen[1];
    }
    for (double& component : sum) component /= perfect;
    return sum;
}

// What Rec.709's colour is under the light's own white.
Triple wanted_xyz(const Triple& rgb) {
    const Triple from = times(cones, times(rec709_to_xyz, {1.0, 1.0, 1.0}));
    const Triple to = times(cones, xyz_of(GreyBase{1.0}));
    const Triple target = times(rec709_to_xyz, rgb);
    // cones * xyz = wanted, by Cramer's rule
    Triple wanted = times(cones, target);
    for (std::size_t i = 0; i < 3; ++i) wanted[i] *= to[i] / from[i];
    const auto determinant = [](const Matrix& m) {
        return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    Triple xyz{};
    for (std::size_t i = 0; i < 3; ++i) {
        Matrix replaced = cones;
        for (std::size_t row = 0; row < 3; ++row) replaced[row][i] = wanted[row];
        xyz[i] = determinant(replaced) / determinant(cones);
    }
    return xyz;
}

// Of the cube: its inside, its faces, edges and corners, and what is nearly on them.
std::vector<Triple> colours() {
    std::vector<Triple> all;
    const std::array values{0.0, 1e-4, 0.02, 0.18, 0.5, 0.75, 0.97, 0.9999, 1.0};
    for (const double r : values) {
        for (const double g : values) {
            for (const double b : values) all.push_back({r, g, b});
        }
    }
    return all;
}

TEST(RgbBase, HasTheColourThatItWasMadeFor) {
    for (const Triple& rgb : colours()) {
        const Upsampled found = upsampled(rgb);
        EXPECT_EQ(found.base.rgb, rgb);
        EXPECT_LT(found.ciede2000, 1e-3);
        const Triple xyz = xyz_of(found.base);
        const Triple wanted = wanted_xyz(rgb);
        // Two roads' rounding; Levenberg and Marquardt's method ends at 1e-13.
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(xyz[i], wanted[i], 1e-10) << rgb[0] << ' ' << rgb[1] << ' ' << rgb[2] << ", component " << i;
    }
}

TEST(RgbBase, ReflectsNoMoreThanAllAndNoLessThanNothing) {
    for (const Triple& rgb : colours()) {
        const Base base = upsampled(rgb).base;
        for (double nm = 300.0; nm <= 900.0; nm += 0.5) {
            EXPECT_GE(diffuse_reflectance(base, nm), 0.0) << nm;
            EXPECT_LE(diffuse_reflectance(base, nm), 1.0) << nm;
        }
    }
}

TEST(RgbBase, IsSmoothWithOneHillOrValleyAtMost) {
    for (const Triple& rgb : colours()) {
        const Base base = upsampled(rgb).base;
        int turns = 0;
        double before = 0.0;
        for (double nm = 361.0; nm <= 830.0; nm += 1.0) {
            const double step = diffuse_reflectance(base, nm) - diffuse_reflectance(base, nm - 1.0);
            if (std::abs(step) < 1e-12) continue;  // rounding
            if (before * step < 0.0) ++turns;
            before = step;
        }
        EXPECT_LE(turns, 1) << rgb[0] << ' ' << rgb[1] << ' ' << rgb[2];
    }
}

TEST(RgbBase, OfGreyIsFlatAndOfBlackAndWhiteExact) {
    for (const double grey : {0.0, 1e-12, 0.001, 0.18, 0.5, 0.9, 1.0 - 1e-12, 1.0}) {
        const Upsampled found = upsampled({grey, grey, grey});
        EXPECT_EQ(found.ciede2000, 0.0);
        for (const double nm : {360.0, 444.0, 555.0, 830.0}) {
            const double reflectance = diffuse_reflectance(found.base, nm);
            if (grey == 0.0 || grey == 1.0)
                EXPECT_EQ(reflectance, grey);
            else
                EXPECT_NEAR(reflectance, grey, 2e-16);  // rounding near 1/2
        }
    }
}

// There is no jump between a grey and its neighbours, although greys are taken by another way.
TEST(RgbBase, OfNearlyGreyIsNearlyFlat) {
    for (const double grey : {0.05, 0.5, 0.95}) {
        const Base base = upsampled({grey + 1e-6, grey, grey - 1e-6}).base;
        for (double nm = 400.0; nm <= 700.0; nm += 10.0) EXPECT_NEAR(diffuse_reflectance(base, nm), grey, 2e-5);
    }
}

TEST(RgbBase, IsTheSameToTheBitEveryTime) {
    for (const Triple& rgb : {Triple{0.1, 0.6, 0.3}, {1.0, 0.0, 0.2}, {1e-5, 2e-5, 0.0}})
        EXPECT_EQ(upsampled(rgb).base, upsampled(rgb).base);
}

TEST(LargestK, IsTakenAllOverTheRangeAndAtItsEnds) {
    EXPECT_EQ(largest_k(Index(RefractiveIndex(1.5, 0.25)), 360, 830), 0.25);
    IndexCurve curve;
    curve.k = SampledCurve{{300.0, 500.0, 501.0, 502.0, 829.0, 830.0, 900.0}, {0.0, 0.0, 0.5, 0.0, 0.0, 0.7, 9.0}};
    const Index index(std::make_shared<const IndexCurve>(curve));
    EXPECT_EQ(largest_k(index, 360, 829), 0.5);
    EXPECT_EQ(largest_k(index, 360, 830), 0.7);
}

}  // namespace
}  // namespace nacre
