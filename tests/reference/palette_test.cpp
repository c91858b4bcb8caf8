// The reference model of palettes is judged before it judges: by a published table, by IEEE 754 and by 50 digits.
#include "reference/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/csv.h"
#include "reference/lut.h"
#include "reference/model.h"
#include "reference/paper_scenes.h"

namespace nacre::reference {
namespace {

TEST(ReferencePalette, ColourDifferenceGivesTheTableOfSharmaWuAndDalal) {
    const Csv pairs = read_csv("ciede2000_sharma34.csv");
    ASSERT_EQ(pairs.rows.size(), 34u);
    for (std::size_t row = 0; row < pairs.rows.size(); ++row) {
        const auto number = [&](const char* name) { return *pairs.number(row, name); };
        const ModelLab one{number("L1"), number("a1"), number("b1")};
        const ModelLab two{number("L2"), number("a2"), number("b2")};
        // Printed with four decimals.
        EXPECT_NEAR(ciede2000(one, two), number("dE00"), 5.001e-5) << "pair " << row + 1;
        EXPECT_NEAR(ciede2000(two, one), number("dE00"), 5.001e-5) << "pair " << row + 1 << " swapped";
    }
}

TEST(ReferencePalette, HalvesAreKeptAndMiddlesGoToTheEvenNeighbour) {
    // IEEE 754 binary16: code k < 1024 is k * 2^-24; otherwise (1024 + k % 1024) * 2^(k / 1024 - 25).
    const auto half = [](int code) {
        return code < 1024 ? std::ldexp(code, -24) : std::ldexp(1024 + code % 1024, code / 1024 - 25);
    };
    for (int code = 0; half(code) < 65504.0; ++code) {
        const double low = half(code), high = half(code + 1), middle = (low + high) / 2.0;
        ASSERT_EQ(as_half(low), low) << code;
        ASSERT_EQ(as_half(middle), code % 2 == 0 ? low : high) << code;
        ASSERT_EQ(as_half(-std::nextafter(middle, 0.0)), -low) << code;
        ASSERT_EQ(as_half(std::nextafter(middle, 1e9)), high) << code;
    }
}

TEST(ReferencePalette, FiftyDigitsGiveTheSameColour) {
    ModelScene narrow = paper_morpho();
    narrow.illuminant = "FL11";
    std::get<Palette>(narrow.mechanism).picks = {{0, {460, 30, 0.9}}, {40, {395, 3, 0.7}}, {60, {440, 12, 0.4}}};
    ModelScene tenth_degree = paper_beetle();
    tenth_degree.illuminant = "A";
    tenth_degree.observer_deg = 10;
    tenth_degree.x = ModelAxis::theta_deg;
    struct Point {
        ModelScene scene;
        double x, y;
    };
    const std::vector<Point> points{
        {paper_morpho(), 1.0, 0.0}, {paper_morpho(), 0.91, 0.0}, {paper_morpho_width(), 0.7, 0.1}, {narrow, 0.875, 0.0},
        {narrow, 0.8, 0.0},         {narrow, 0.7072, 0.0},       {tenth_degree, 0.4, 0.0}};
    for (const auto& [scene, x, y] : points) {
        const ModelXyz colour = Model(scene).at(x, y);
        const XyzNumbers exact = palette_in_50_digits(scene, x, y);
        EXPECT_LT(distance(colour.x, exact.x), 1e-11) << scene.name << " " << x;
        EXPECT_LT(distance(colour.y, exact.y), 1e-11) << scene.name << " " << x;
        EXPECT_LT(distance(colour.z, exact.z), 1e-11) << scene.name << " " << x;
    }
}

}  // namespace
}  // namespace nacre::reference
