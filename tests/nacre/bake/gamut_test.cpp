#include "nacre/bake/gamut.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre {
namespace {

// Second row of XYZ from linear Rec.709 (IEC 61966-2-1): the luminance of its primaries; the sum is 1.
double luminance(Rgb c) {
    return 87098.0 / 409605.0 * c.r + 175762.0 / 245763.0 * c.g + 12673.0 / 175545.0 * c.b;
}

const Rgb spectral_green{-0.4, 0.9, -0.05};

Image<Rgb> three_pixels() {
    Image<Rgb> image(3, 1);
    image.at(0, 0) = {0.2, 0.3, 0.4};
    image.at(1, 0) = spectral_green;
    image.at(2, 0) = {1e-7, -1e-7, 0.5};
    return image;
}

Image<Xyz> luminances_of(const Image<Rgb>& image) {
    Image<Xyz> xyz(image.width(), image.height());
    for (int x = 0; x < image.width(); ++x) xyz.at(x, 0).y = luminance(image.at(x, 0));
    return xyz;
}

TEST(Gamut, ClippingLeavesNoNegativeComponentAndNoNegativeZero) {
    EXPECT_EQ(clip_to_gamut(spectral_green), (Rgb{0.0, 0.9, 0.0}));
    EXPECT_FALSE(std::signbit(clip_to_gamut({-0.0, 0.0, 0.0}).r));
}

TEST(Gamut, CompressionKeepsLuminance) {
    const double y = luminance(spectral_green);
    EXPECT_NEAR(luminance(compress_to_gamut(spectral_green, y)), y, 1e-15);
    // What clipping would do instead.
    EXPECT_GT(luminance(clip_to_gamut(spectral_green)) - y, 0.08);
}

TEST(Gamut, CompressionStopsAtTheHullOnTheLineToGrey) {
    const double y = luminance(spectral_green);
    const Rgb c = compress_to_gamut(spectral_green, y);
    EXPECT_EQ(c.r, 0.0);
    EXPECT_GT(c.b, 0.0);
    // On the line: distances from grey shrink by one factor.
    const double factor = (c.g - y) / (spectral_green.g - y);
    EXPECT_NEAR((c.b - y) / (spectral_green.b - y), factor, 1e-14);
    EXPECT_NEAR((c.r - y) / (spectral_green.r - y), factor, 1e-14);
}

TEST(Gamut, AColourInsideIsItsOwnCompression) {
    EXPECT_EQ(compress_to_gamut({0.2, 0.3, 0.4}, 0.28), (Rgb{0.2, 0.3, 0.4}));
    EXPECT_EQ(compress_to_gamut({0.0, 0.0, 0.0}, 0.0), (Rgb{0.0, 0.0, 0.0}));
}

TEST(Gamut, ColourWithoutLuminanceBecomesBlack) {
    EXPECT_EQ(compress_to_gamut({-0.1, 0.02, 0.1}, 0.0), (Rgb{0.0, 0.0, 0.0}));
}

TEST(Gamut, ReportCountsTexelsOutsideButNotRounding) {
    EXPECT_EQ(gamut_report(three_pixels()), (GamutReport{1, -0.4}));
    EXPECT_EQ(gamut_report(Image<Rgb>()), GamutReport{});
    EXPECT_EQ(gamut_report(Image<Rgb>(2, 2, {0.1, 1e-9, 3.0})), GamutReport{});
}

TEST(Gamut, EveryTreatmentReportsWhatTheImageWasBefore) {
    for (const Gamut gamut : {Gamut::keep, Gamut::clip, Gamut::compress}) {
        Image<Rgb> image = three_pixels();
        EXPECT_EQ(fit_to_gamut(gamut, image, luminances_of(image)), (GamutReport{1, -0.4}));
    }
}

TEST(Gamut, KeepChangesNothingAndTheOthersOnlyWhatIsNegative) {
    const Image<Rgb> before = three_pixels();
    Image<Rgb> kept = before;
    fit_to_gamut(Gamut::keep, kept, {});
    for (int x = 0; x < 3; ++x) EXPECT_EQ(kept.at(x, 0), before.at(x, 0));

    Image<Rgb> clipped = before;
    fit_to_gamut(Gamut::clip, clipped, {});
    EXPECT_EQ(clipped.at(0, 0), before.at(0, 0));
    EXPECT_EQ(clipped.at(1, 0), (Rgb{0.0, 0.9, 0.0}));
    EXPECT_EQ(clipped.at(2, 0), (Rgb{1e-7, 0.0, 0.5}));

    Image<Rgb> compressed = before;
    fit_to_gamut(Gamut::compress, compressed, luminances_of(before));
    EXPECT_EQ(compressed.at(0, 0), before.at(0, 0));
    for (int x = 0; x < 3; ++x) {
        EXPECT_GE(compressed.at(x, 0).r, 0.0);
        EXPECT_GE(compressed.at(x, 0).g, 0.0);
        EXPECT_NEAR(luminance(compressed.at(x, 0)), luminance(before.at(x, 0)), 1e-15);
    }
}

}  // namespace
}  // namespace nacre
