#include "nacre/shade/palette_colour.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/tristimulus.h"
#include "reference/number.h"

namespace nacre {
namespace {

Light light_of(const char* illuminant) {
    LightSettings settings;
    settings.illuminant = illuminant;
    settings.power = *illuminant_by_name(illuminant);
    return make_light(settings);
}

// R times the weights, which are linear between whole nanometres, at 400 midpoints per nanometre.
Xyz fine_sum(const TristimulusWeights& weights, const Lobe& lobe) {
    constexpr int parts = 400;
    Xyz sum;
    for (int nm = weights.first_nm; nm < weights.last_nm; ++nm) {
        const auto i = static_cast<std::size_t>(nm - weights.first_nm);
        for (int part = 0; part < parts; ++part) {
            const double t = (part + 0.5) / parts;
            const double r = lobe_reflectance(lobe, nm + t) / parts;
            sum.x += r * ((1.0 - t) * weights.x[i] + t * weights.x[i + 1]);
            sum.y += r * ((1.0 - t) * weights.y[i] + t * weights.y[i + 1]);
            sum.z += r * ((1.0 - t) * weights.z[i] + t * weights.z[i + 1]);
        }
    }
    return sum;
}

// The midpoint rule errs by h^2 / 24 times the jumps of slope: of the weights 1e-3 per nm each, some 470 of them, and
// of the shoulders' ends pi / 20 nm or less: 2.6e-7 (5e-4 + 0.3 * 0.02) is 2e-9 at most, and most of it cancels.
TEST(PaletteColour, IsTheSumOfItsReflectance) {
    const Light light = light_of("D65");
    reference::Uniform uniform(7);
    for (int i = 0; i < 12; ++i) {
        const Lobe lobe{uniform.between(400.0, 700.0), uniform.between(150.0, 400.0), uniform.between(0.0, 1.0),
                        uniform.between(0.0, 1.0), uniform.between(0.0, 0.7)};
        const Xyz colour = lobe_to_xyz(light, lobe), sum = fine_sum(light.weights, lobe);
        EXPECT_NEAR(colour.x, sum.x, 1e-9);
        EXPECT_NEAR(colour.y, sum.y, 1e-9);
        EXPECT_NEAR(colour.z, sum.z, 1e-9);
    }
}

TEST(PaletteColour, IsFloorTimesWhiteAndTheBandAboveIt) {
    for (const char* illuminant : {"D65", "A", "FL11"}) {
        const Light light = light_of(illuminant);
        const Xyz white = light.weights.white, band = band_to_xyz(light.weights, {540.0, 130.0, 0.4});
        for (const auto& [height, floor] : {std::pair{0.9, 0.2}, {0.0, 1.0}, {0.1, 0.7}}) {
            const Xyz colour = lobe_to_xyz(light, {540.0, 130.0, height, floor, 0.4});
            EXPECT_NEAR(colour.x, floor * white.x + (height - floor) * band.x, 1e-15);
            EXPECT_NEAR(colour.y, floor * white.y + (height - floor) * band.y, 1e-15);
            EXPECT_NEAR(colour.z, floor * white.z + (height - floor) * band.z, 1e-15);
        }
        const Xyz grey = lobe_to_xyz(light, {540.0, 130.0, 0.3, 0.3, 0.4});
        EXPECT_EQ(grey.y, 0.3);
        EXPECT_EQ(grey.x, 0.3 * white.x);
    }
}

TEST(PaletteColour, WithoutFloorIsTheBandTimesItsHeightBitByBit) {
    const Light light = light_of("E");
    const Xyz band = band_to_xyz(light.weights, {480.5, 77.0});
    const Xyz colour = lobe_to_xyz(light, {480.5, 77.0, 0.37});
    EXPECT_EQ(colour.x, 0.37 * band.x);
    EXPECT_EQ(colour.y, 0.37 * band.y);
    EXPECT_EQ(colour.z, 0.37 * band.z);
}

}  // namespace
}  // namespace nacre
