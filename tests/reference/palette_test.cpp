// The reference model of palettes is judged before it judges: by a published table, by IEEE 754 and by 50 digits.
#include "reference/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/csv.h"
#include "reference/lobe_quadrature.h"
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
    ModelScene flat = paper_beetle();
    std::get<Palette>(flat.mechanism).picks = {{0, {560, 200, 0.9, 0.1, 0.4}}, {70, {470, 120, 0.2, 0.7, 0.8}}};
    const std::vector<Point> points{{flat, 1.0, 0.0},
                                    {flat, 0.8, 0.0},
                                    {flat, 0.4, 0.0},
                                    {paper_morpho(), 1.0, 0.0},
                                    {paper_morpho(), 0.91, 0.0},
                                    {paper_morpho_width(), 0.7, 0.1},
                                    {narrow, 0.875, 0.0},
                                    {narrow, 0.8, 0.0},
                                    {narrow, 0.7072, 0.0},
                                    {tenth_degree, 0.4, 0.0}};
    for (const auto& [scene, x, y] : points) {
        const ModelXyz colour = Model(scene).at(x, y);
        const XyzNumbers exact = palette_in_50_digits(scene, x, y);
        EXPECT_LT(distance(colour.x, exact.x), 1e-11) << scene.name << " " << x;
        EXPECT_LT(distance(colour.y, exact.y), 1e-11) << scene.name << " " << x;
        EXPECT_LT(distance(colour.z, exact.z), 1e-11) << scene.name << " " << x;
    }
}

// The antiderivatives of a band with a plateau. The quadrature knows half cosines alone; of a band that is narrower
// than its plateau's cell both sides are halves of two of them.
TEST(ReferencePalette, BandsWithAPlateauAreHalvesOfTwoCosinesAroundIt) {
    for (const auto& [peak_nm, width_nm, flatness] :
         {std::array{500.0, 64.0, 0.25}, {611.5, 10.0, 0.5}, {480.0, 200.0, 0.75}, {400.25, 2.0, 0.875}}) {
        const double half_plateau = 0.5 * flatness * width_nm, shoulders = width_nm - flatness * width_nm;
        Number whole = 0, lever = 0;  // the integral, and that of (nm - 360)
        const auto add = [](const std::vector<CellMoments>& cells, Number& zeroth, Number& first) {
            for (const CellMoments& cell : cells) {
                zeroth += cell.zeroth;
                first += cell.first + (cell.nm - 360) * cell.zeroth;
            }
        };
        add(FlatBandMoments(peak_nm, width_nm, flatness).cells(), whole, lever);
        // Both halves of a cosine weigh alike, so that two whole cosines at the plateau's ends hold what is wanted
        // twice over; together with the mirrored halves they are symmetric about the peak.
        Number cosines = 0, cosines_lever = 0;
        add(lobe_moments(peak_nm - half_plateau, shoulders), cosines, cosines_lever);
        add(lobe_moments(peak_nm + half_plateau, shoulders), cosines, cosines_lever);
        const Number expected = cosines / 2 + 2 * Number(half_plateau);
        EXPECT_LT(relative_distance(static_cast<double>(whole), expected), 1e-15);
        EXPECT_LT(static_cast<double>(abs(whole - expected)), 1e-20) << peak_nm;
        EXPECT_LT(static_cast<double>(abs(lever - whole * (Number(peak_nm) - 360))), 1e-18) << peak_nm;
    }
}

// Cell by cell: beyond the plateau's middle a band is the cosine around the plateau's end.
TEST(ReferencePalette, ShouldersAreTheCosineCellByCell) {
    const auto band = FlatBandMoments(500.0, 64.0, 0.25).cells();
    const auto right = lobe_moments(508.0, 48.0), left = lobe_moments(492.0, 48.0);
    int compared = 0;
    for (const CellMoments& cell : band) {
        for (const auto& [side, is_shoulder] : {std::pair{&left, cell.nm < 492}, {&right, cell.nm >= 508}}) {
            if (!is_shoulder) continue;
            const auto same = std::find_if(side->begin(), side->end(), [&](const auto& c) { return c.nm == cell.nm; });
            ASSERT_NE(same, side->end());
            EXPECT_LT(static_cast<double>(abs(cell.zeroth - same->zeroth)), 1e-22) << cell.nm;
            EXPECT_LT(static_cast<double>(abs(cell.first - same->first)), 1e-22) << cell.nm;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 48);
}

TEST(ReferencePalette, OklabGivesOttossonsExamples) {
    // The table of pairs in his article, to its three digits.
    const auto expect = [](const ModelXyz& colour, double l, double a, double b) {
        const auto lab = oklab_of(colour);
        EXPECT_NEAR(lab[0], l, 5.1e-4);
        EXPECT_NEAR(lab[1], a, 5.1e-4);
        EXPECT_NEAR(lab[2], b, 5.1e-4);
    };
    expect({0.950, 1.000, 1.089}, 1.000, 0.000, 0.000);
    expect({1.000, 0.000, 0.000}, 0.450, 1.236, -0.019);
    expect({0.000, 1.000, 0.000}, 0.922, -0.671, 0.263);
    expect({0.000, 0.000, 1.000}, 0.153, -1.415, -0.449);
}

}  // namespace
}  // namespace nacre::reference
