#include "nacre/lut/fetch.h"

#include <gtest/gtest.h>

#include "nacre/lut/axis_kinds.h"
#include "reference/number.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

Image<Rgb> noise(int width, int height) {
    reference::Uniform uniform(1);
    Image<Rgb> image(width, height);
    for (Rgb& texel : image)
        texel = {uniform.between(-0.1, 1.0), uniform.between(-0.1, 1.0), uniform.between(-0.1, 1.0)};
    return image;
}

void expect_near(const Rgb& one, const Rgb& other, double tolerance) {
    EXPECT_NEAR(one.r, other.r, tolerance);
    EXPECT_NEAR(one.g, other.g, tolerance);
    EXPECT_NEAR(one.b, other.b, tolerance);
}

TEST(Fetch, CornersAreTheCornerTexelsToTheLastBit) {
    for (const auto& [width, height] : {std::pair{2, 2}, {3, 7}, {256, 64}, {4096, 2}}) {
        const Image<Rgb> lut = noise(width, height);
        EXPECT_EQ(fetch(lut, {0.0, 0.0}), lut.at(0, 0));
        EXPECT_EQ(fetch(lut, {1.0, 0.0}), lut.at(width - 1, 0));
        EXPECT_EQ(fetch(lut, {0.0, 1.0}), lut.at(0, height - 1));
        EXPECT_EQ(fetch(lut, {1.0, 1.0}), lut.at(width - 1, height - 1));
    }
}

TEST(Fetch, TexelsAreAtTheirIndexOverTheLastIndex) {
    const Image<Rgb> lut = noise(37, 11);
    for (int row = 0; row < 11; ++row) {
        for (int column = 0; column < 37; ++column) {
            // The coordinate is rounded to 1.1e-16 and stretched by 36 texels that differ by up to 1.1.
            expect_near(fetch(lut, {column / 36.0, row / 10.0}), lut.at(column, row), 1e-14);
        }
    }
}

TEST(Fetch, MiddleOfTwoTexelsIsTheirMeanAndOfFourTheirs) {
    Image<Rgb> lut(2, 2);
    lut.at(0, 0) = {0.0, 1.0, -0.5};
    lut.at(1, 0) = {1.0, 0.5, 0.5};
    lut.at(0, 1) = {0.5, 0.0, 0.25};
    lut.at(1, 1) = {0.0, 0.0, 0.75};
    EXPECT_EQ(fetch(lut, {0.5, 0.0}), (Rgb{0.5, 0.75, 0.0}));
    EXPECT_EQ(fetch(lut, {0.5, 1.0}), (Rgb{0.25, 0.0, 0.5}));
    EXPECT_EQ(fetch(lut, {0.0, 0.5}), (Rgb{0.25, 0.5, -0.125}));
    EXPECT_EQ(fetch(lut, {0.5, 0.5}), (Rgb{0.375, 0.375, 0.25}));
    EXPECT_EQ(fetch(lut, {0.25, 0.5}), (Rgb{0.3125, 0.4375, 0.0625}));
}

TEST(Fetch, IsTheLinearFilterOfGraphicsHardwareAtTheTextureCoordinate) {
    reference::Uniform uniform(2);
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {256, 1}, {2, 2}, {5, 3}, {64, 128}, {1, 8}}) {
        const Image<Rgb> lut = noise(width, height);
        for (int i = 0; i < 500; ++i) {
            const LutPoint point{uniform.between(0.0, 1.0), uniform.between(0.0, 1.0)};
            // A texture coordinate carries its 1.1e-16 times the size, 256 at most.
            expect_near(
                fetch(lut, point),
                test::sampled_as_in_opengl(lut, texcoord_of(point.x, lut.width()), texcoord_of(point.y, lut.height())),
                1e-13);
        }
    }
}

TEST(Fetch, OfALonelyTexelIsThatTexelEverywhere) {
    const Image<Rgb> lut = noise(1, 1);
    for (const double x : {0.0, 0.3, 1.0}) {
        for (const double y : {0.0, 0.7, 1.0}) EXPECT_EQ(fetch(lut, {x, y}), lut.at(0, 0));
    }
}

TEST(Fetch, OfARowIgnoresTheSecondCoordinate) {
    const Image<Rgb> lut = noise(16, 1);
    for (const double x : {0.0, 0.3, 0.5, 0.99, 1.0}) EXPECT_EQ(fetch(lut, {x, 0.6}), fetch(lut, {x, 0.0}));
}

TEST(Fetch, LastCellEndsInTheLastTexel) {
    Image<Rgb> lut(4, 1);
    lut.at(2, 0) = {1.0, 1.0, 1.0};
    lut.at(3, 0) = {3.0, 3.0, 3.0};
    // Within the last cell, just before its end and at it.
    EXPECT_NEAR(fetch(lut, {2.5 / 3.0, 0.0}).r, 2.0, 1e-15);
    EXPECT_NEAR(fetch(lut, {1.0 - 1e-12, 0.0}).g, 3.0, 1e-11);
    EXPECT_EQ(fetch(lut, {1.0, 0.0}).b, 3.0);
}

}  // namespace
}  // namespace nacre
