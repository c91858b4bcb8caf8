#include "nacre/pick/colour_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "nacre/colour/oklab.h"

namespace nacre {
namespace {

using Hues = std::vector<std::string>;

constexpr double chroma = 0.15;

Oklab hue_at(double degrees) {
    const double radians = degrees * std::numbers::pi / 180.0;
    return {0.6, chroma * std::cos(radians), chroma * std::sin(radians)};
}

// In Oklab a straight line, or around it at one chroma.
std::vector<Xyz> straight(const Oklab& from, const Oklab& to) {
    std::vector<Xyz> colours;
    for (std::size_t i = 0; i < colours_of_path; ++i) {
        const double t = static_cast<double>(i) / (colours_of_path - 1);
        colours.push_back(oklab_to_xyz(
            {std::lerp(from.lightness, to.lightness, t), std::lerp(from.a, to.a, t), std::lerp(from.b, to.b, t)}));
    }
    return colours;
}

std::vector<Xyz> around(double from_deg, double to_deg) {
    std::vector<Xyz> colours;
    for (std::size_t i = 0; i < colours_of_path; ++i)
        colours.push_back(
            oklab_to_xyz(hue_at(std::lerp(from_deg, to_deg, static_cast<double>(i) / (colours_of_path - 1)))));
    return colours;
}

TEST(ColourPath, AroundTheCircleNamesTheHuesBetweenItsEnds) {
    const ColourPath path = colour_path(around(142.5, 303.4));  // green to purple
    EXPECT_EQ(path.hues, (Hues{"cyan", "blue"}));
    EXPECT_NEAR(path.chroma, 1.0, 1e-9);
    EXPECT_FALSE(path.is_pale());
    EXPECT_EQ(path_text(path), "through cyan and blue");
}

TEST(ColourPath, AcrossTheCircleIsGrey) {
    const ColourPath path = colour_path(straight(hue_at(142.5), hue_at(322.5)));
    EXPECT_EQ(path.hues, Hues{"grey"});
    EXPECT_NEAR(path.chroma, 0.0, 1e-9);
    EXPECT_TRUE(path.is_pale());
}

// A chord of 120 degrees comes within cos 60 = half of the radius, one of 140 within cos 70 = 0.34.
TEST(ColourPath, ChromaIsTheLeastShareOnTheWay) {
    EXPECT_NEAR(colour_path(straight(hue_at(30.0), hue_at(150.0))).chroma, 0.5, 1e-9);
    EXPECT_FALSE(colour_path(straight(hue_at(30.0), hue_at(150.0))).is_pale());
    EXPECT_NEAR(colour_path(straight(hue_at(30.0), hue_at(170.0))).chroma, std::cos(70.0 * std::numbers::pi / 180.0),
                1e-9);
    EXPECT_TRUE(colour_path(straight(hue_at(30.0), hue_at(170.0))).is_pale());
}

TEST(ColourPath, FromGreyHasNoChromaToLose) {
    const ColourPath path = colour_path(straight({0.5, 0.0, 0.0}, hue_at(30.0)));
    EXPECT_EQ(path.chroma, 1.0);
    EXPECT_FALSE(path.is_pale());
    EXPECT_TRUE(path.hues.empty());
}

TEST(ColourPath, OfSeveralPicksIsTheWorstAndHasAllHues) {
    const std::vector<ColourPath> parts{{0.7, {"cyan", "blue"}}, {0.2, {"blue", "grey"}}};
    const ColourPath whole = joined(parts);
    EXPECT_EQ(whole.chroma, 0.2);
    EXPECT_EQ(whole.hues, (Hues{"cyan", "blue", "grey"}));
    EXPECT_EQ(path_text(whole), "through cyan, blue and grey");
}

TEST(ColourPath, TextOfARainbowNamesNoHues) {
    EXPECT_EQ(path_text({1.0, {}}), "");
    EXPECT_EQ(path_text({1.0, {"red"}}), "through red");
    EXPECT_EQ(path_text({1.0, {"red", "green", "blue", "red", "green"}}), "through many hues");
}

}  // namespace
}  // namespace nacre
