#include "nacre/colour/rgb_space.h"

#include <gtest/gtest.h>

namespace nacre {
namespace {

TEST(RgbSpace, MatrixOfRec709IsTheOneThatCssColor4Derives) {
    const glm::dmat3 matrix = xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene"));
    // W3C CSS Color Module Level 4, section 18: 12831/3959, -329/214, -1974/3959 in the first row.
    EXPECT_NEAR(matrix[0][0], 12831.0 / 3959.0, 1e-14);
    EXPECT_NEAR(matrix[1][0], -329.0 / 214.0, 1e-14);
    EXPECT_NEAR(matrix[2][0], -1974.0 / 3959.0, 1e-14);
}

TEST(RgbSpace, PrimariesAreThoseOfTheStandards) {
    // SMPTE EG 432-1, ITU-R BT.2020, Adobe RGB (1998), SMPTE ST 2065-1, AMPAS S-2014-004.
    const RgbPrimaries p3 = *primaries_by_interop_id("lin_p3d65_scene");
    EXPECT_EQ(p3.red, (Chromaticity{0.680, 0.320}));
    EXPECT_EQ(p3.green, (Chromaticity{0.265, 0.690}));
    EXPECT_EQ(p3.blue, (Chromaticity{0.150, 0.060}));
    EXPECT_EQ(primaries_by_interop_id("lin_rec2020_scene")->green, (Chromaticity{0.170, 0.797}));
    EXPECT_EQ(primaries_by_interop_id("lin_adobergb_scene")->green, (Chromaticity{0.21, 0.71}));
    EXPECT_EQ(primaries_by_interop_id("lin_ap0_scene")->blue, (Chromaticity{0.0001, -0.0770}));
    EXPECT_EQ(primaries_by_interop_id("lin_ap1_scene")->red, (Chromaticity{0.713, 0.293}));
}

TEST(RgbSpace, WhiteOfEverySpaceIsOneOneOne) {
    for (const char* id : {"lin_rec709_scene", "lin_p3d65_scene", "lin_rec2020_scene", "lin_adobergb_scene",
                           "lin_ap0_scene", "lin_ap1_scene"}) {
        const RgbPrimaries primaries = *primaries_by_interop_id(id);
        const Xyz white = xyz_from_chromaticity(primaries.white);
        const glm::dvec3 rgb = xyz_to_rgb_matrix(primaries) * glm::dvec3(white.x, white.y, white.z);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(rgb[i], 1.0, 1e-14) << id;
    }
}

TEST(RgbSpace, PrimariesComeBackFromTheirMatrix) {
    const RgbPrimaries rec2020 = *primaries_by_interop_id("lin_rec2020_scene");
    const auto back = primaries_of(xyz_to_rgb_matrix(rec2020));
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->red.x, rec2020.red.x, 1e-14);
    EXPECT_NEAR(back->blue.y, rec2020.blue.y, 1e-14);
    EXPECT_NEAR(back->white.x, rec2020.white.x, 1e-14);
    EXPECT_FALSE(primaries_of(glm::dmat3(0.0)));
    EXPECT_FALSE(primaries_by_interop_id("srgb_rec709_scene"));
}

}  // namespace
}  // namespace nacre
