#include "nacre/colour/hue_name.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>
#include <string>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/rgb_space.h"

namespace nacre {
namespace {

Oklab oklab_of_bytes(int r, int g, int b) {
    const auto linear = [](int byte) {  // IEC 61966-2-1
        const double encoded = byte / 255.0;
        return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    };
    const glm::dmat3 to_xyz = glm::inverse(xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec709_scene")));
    return xyz_to_oklab(adapt(to_xyz, Xyz{linear(r), linear(g), linear(b)}));
}

// CSS Color 4, section 6.1: names that people know and that stand for one hue.
TEST(HueName, OfColoursThatCssNamesIsTheirHue) {
    EXPECT_EQ(hue_name(oklab_of_bytes(220, 20, 60)), "red");        // crimson
    EXPECT_EQ(hue_name(oklab_of_bytes(255, 140, 0)), "orange");     // darkorange
    EXPECT_EQ(hue_name(oklab_of_bytes(255, 215, 0)), "yellow");     // gold
    EXPECT_EQ(hue_name(oklab_of_bytes(34, 139, 34)), "green");      // forestgreen
    EXPECT_EQ(hue_name(oklab_of_bytes(64, 224, 208)), "cyan");      // turquoise
    EXPECT_EQ(hue_name(oklab_of_bytes(65, 105, 225)), "blue");      // royalblue
    EXPECT_EQ(hue_name(oklab_of_bytes(138, 43, 226)), "purple");    // blueviolet
    EXPECT_EQ(hue_name(oklab_of_bytes(238, 130, 238)), "magenta");  // violet
    EXPECT_EQ(hue_name(oklab_of_bytes(255, 105, 180)), "pink");     // hotpink
}

// Neither lightness nor chroma has a say, and the circle has no seam.
TEST(HueName, IsThatOfTheNearestNamedHueAllRound) {
    const auto at = [](double degrees) {
        const double radians = degrees * std::numbers::pi / 180.0;
        return std::string(hue_name({0.4, 0.1 * std::cos(radians), 0.1 * std::sin(radians)}));
    };
    EXPECT_EQ(at(0.0), "pink");
    EXPECT_EQ(at(-10.0), "pink");
    EXPECT_EQ(at(350.0), "pink");
    EXPECT_EQ(at(0.5 * (29.2 + 356.9 - 360.0) - 0.1), "pink");
    EXPECT_EQ(at(0.5 * (29.2 + 356.9 - 360.0) + 0.1), "red");
}

TEST(GreyName, GoesByLightness) {
    EXPECT_EQ(grey_name({1.0, 0.0, 0.0}), "white");
    EXPECT_EQ(grey_name({0.6, 0.0, 0.0}), "grey");
    EXPECT_EQ(grey_name({0.0, 0.0, 0.0}), "black");
}

}  // namespace
}  // namespace nacre
