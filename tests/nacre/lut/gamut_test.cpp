#include "nacre/lut/gamut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/matrix.hpp>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/rgb_space.h"
#include "support/test_encoding.h"

namespace nacre {
namespace {

const Rgb spectral_green{-0.4, 0.9, -0.05};

Image<Rgb> three_pixels() {
    Image<Rgb> image(3, 1);
    image.at(0, 0) = {0.2, 0.3, 0.4};
    image.at(1, 0) = spectral_green;
    image.at(2, 0) = {1e-7, -1e-7, 0.5};
    return image;
}

// To XYZ from linear Rec.709 (IEC 61966-2-1).
const glm::dmat3 rec709_of_xyz = xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene"));

Image<Xyz> xyz_of(const Image<Rgb>& image) {
    const glm::dmat3 xyz_of_rec709 = glm::inverse(rec709_of_xyz);
    return test::converted<Xyz>(image, [&](const Rgb& c) { return adapt(xyz_of_rec709, {c.r, c.g, c.b}); });
}

TEST(Gamut, ClippingLeavesNoNegativeComponentAndNoNegativeZero) {
    EXPECT_EQ(clip_to_gamut(spectral_green), (Rgb{0.0, 0.9, 0.0}));
    EXPECT_FALSE(std::signbit(clip_to_gamut({-0.0, 0.0, 0.0}).r));
}

TEST(Gamut, ReportCountsTexelsOutsideButNotRounding) {
    EXPECT_EQ(gamut_report(three_pixels()), (GamutReport{1, -0.4}));
    EXPECT_EQ(gamut_report(Image<Rgb>()), GamutReport{});
    EXPECT_EQ(gamut_report(Image<Rgb>(2, 2, {0.1, 1e-9, 3.0})), GamutReport{});
}

TEST(Gamut, KeepChangesNothingAndTheOthersOnlyWhatIsNotWellInside) {
    const Image<Rgb> before = three_pixels();
    Image<Rgb> kept = before;
    GamutRule(Gamut::keep, {}).apply(kept, {});
    for (int x = 0; x < 3; ++x) EXPECT_EQ(kept.at(x, 0), before.at(x, 0));

    Image<Rgb> clipped = before;
    GamutRule(Gamut::clip, {}).apply(clipped, {});
    EXPECT_EQ(clipped.at(0, 0), before.at(0, 0));
    EXPECT_EQ(clipped.at(1, 0), (Rgb{0.0, 0.9, 0.0}));
    EXPECT_EQ(clipped.at(2, 0), (Rgb{1e-7, 0.0, 0.5}));

    Image<Rgb> compressed = before;
    GamutRule(Gamut::compress, rec709_of_xyz).apply(compressed, xyz_of(before));
    EXPECT_EQ(compressed.at(0, 0), before.at(0, 0));
    EXPECT_EQ(gamut_report(compressed), GamutReport{});
    EXPECT_NE(compressed.at(1, 0), before.at(1, 0));
}

TEST(Gamut, NoRuleLetsANegativeZeroOrANegativeRoundingThrough) {
    for (const Gamut gamut : {Gamut::clip, Gamut::compress}) {
        Image<Rgb> image(2, 1);
        image.at(0, 0) = {-0.0, -0.0, -0.0};
        image.at(1, 0) = {1.0, 1.0, -1e-17};
        GamutRule(gamut, rec709_of_xyz).apply(image, xyz_of(image));
        for (const Rgb& pixel : image) {
            for (const double component : {pixel.r, pixel.g, pixel.b}) EXPECT_FALSE(std::signbit(component));
        }
    }
}

}  // namespace
}  // namespace nacre
