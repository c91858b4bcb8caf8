// Picks on straight lines in Y know the shape that they were made with; others what comes nearest.
#include "nacre/pick/fit_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/light.h"
#include "nacre/shade/palette_colour.h"

namespace nacre {
namespace {

const Light& daylight() {
    static const Light light = [] {
        LightSettings settings;
        settings.power = *illuminant_by_name("D65");
        return make_light(settings);
    }();
    return light;
}

Xyz colour_of(const Lobe& lobe) {
    const Light& light = daylight();
    return adapt(light.adaptation, lobe_to_xyz(light, lobe));
}

double difference(const Lobe& one, const Lobe& other) {
    return ciede2000(to_lab(colour_of(one), d65_white), to_lab(colour_of(other), d65_white));
}

// Picks of a palette of two at other angles: on straight lines in Y, by the model's own formula.
std::vector<Pick> picks_of(const Palette& palette, const std::vector<double>& angles_deg) {
    std::vector<Pick> picks;
    for (const double angle_deg : angles_deg)
        picks.push_back({angle_deg, palette_lobe_unclamped(palette, Incidence::from_degrees(angle_deg))});
    return picks;
}

const Palette two{{{0.0, {560.0, 120.0, 0.9}}, {80.0, {460.0, 160.0, 0.5}}}};

TEST(FitShape, TakesPicksOnStraightLinesBackToTheirShape) {
    for (const double shape : {0.0, 0.1, 0.37, 0.5, 0.88, 0.9137, 1.0}) {
        Palette palette = two;
        palette.shape = shape;
        for (const std::vector<double>& angles_deg :
             {std::vector<double>{0, 40, 80}, {5, 20, 45, 70}, {80, 0, 30, 60, 10}, {0, 60, 90}}) {
            const auto fit = fit_shape(picks_of(palette, angles_deg), colour_of);
            ASSERT_TRUE(fit.has_value());
            EXPECT_NEAR(fit->shape, shape, 1e-3) << angles_deg.size() << " picks";
            ASSERT_EQ(fit->de00.size(), angles_deg.size());
            for (const double de00 : fit->de00) EXPECT_LT(de00, 0.01);
        }
    }
}

// Heights alone, as of a colour that only fades.
TEST(FitShape, NeedsOneNumberThatMovesOnly) {
    Palette fading{{{0.0, {520.0, 100.0, 1.0}}, {85.0, {520.0, 100.0, 0.1}}}};
    fading.shape = 0.6;
    const auto fit = fit_shape(picks_of(fading, {0, 30, 55, 85}), colour_of);
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->shape, 0.6, 1e-3);
}

// No shape bends the lines enough: what is found is nearer than lines through any two of the picks.
TEST(FitShape, IsNearestWhereNoneFits) {
    const std::vector<Pick> picks{{0.0, {560.0, 120.0, 0.8}},
                                  {25.0, {545.0, 130.0, 0.6}},
                                  {50.0, {480.0, 120.0, 0.7}},
                                  {75.0, {470.0, 140.0, 0.5}}};
    const auto fit = fit_shape(picks, colour_of);
    ASSERT_TRUE(fit.has_value());
    double sum = 0.0;
    for (const double de00 : fit->de00) sum += de00 * de00;
    EXPECT_GT(sum, 1.0);
    for (double shape = 0.0; shape <= 1.0; shape += 0.05) {
        for (std::size_t a = 0; a < picks.size(); ++a) {
            for (std::size_t b = a + 1; b < picks.size(); ++b) {
                const Palette line{{picks[a], picks[b]}, shape};
                double other = 0.0;
                for (const Pick& pick : picks) {
                    const double de00 =
                        difference(palette_lobe(line, Incidence::from_degrees(pick.angle_deg)), pick.lobe);
                    other += de00 * de00;
                }
                EXPECT_GT(other, sum) << shape << " " << a << " " << b;
            }
        }
    }
}

TEST(FitShape, SaysNothingWhereNothingIsSaid) {
    const Pick pick{0.0, {500.0, 100.0, 0.5}};
    const auto at = [](Pick of, double angle_deg) {
        of.angle_deg = angle_deg;
        return of;
    };
    EXPECT_FALSE(fit_shape({pick}, colour_of));
    EXPECT_FALSE(fit_shape({pick, at(pick, 50)}, colour_of));
    EXPECT_FALSE(fit_shape({pick, pick, at(pick, 50)}, colour_of));  // two angles
    EXPECT_FALSE(fit_shape({pick, at(pick, 30), at(pick, 50), at(pick, 90)}, colour_of));
    // All black, wherever the bands were.
    EXPECT_FALSE(
        fit_shape({{0.0, {400.0, 0.0, 1.0}}, {30.0, {500.0, 0.0, 0.3}}, {60.0, {700.0, 0.0, 0.2}}}, colour_of));
}

TEST(FitShape, TakesBlackNarrowAndInvisiblePicks) {
    for (const std::vector<Pick>& picks :
         {std::vector<Pick>{{0.0, {500.0, 100.0, 0.0}}, {40.0, {480.0, 100.0, 0.5}}, {80.0, {450.0, 80.0, 0.0}}},
          {{0.0, {1500.0, 10.0, 1.0}}, {40.0, {480.0, 0.0, 0.5}}, {80.0, {150.0, 80.0, 0.4}}},
          {{0.0, {500.0, 0.0, 0.0}}, {1e-10, {500.0, 0.0, 0.0}}, {80.0, {450.0, 80.0, 0.4}}},
          {{89.0, {500.0, 900.0, 1.0}}, {89.5, {500.0, 1000.0, 1.0}}, {90.0, {550.0, 1000.0, 1.0}}}}) {
        const auto fit = fit_shape(picks, colour_of);
        if (!fit) continue;
        EXPECT_GE(fit->shape, 0.0);
        EXPECT_LE(fit->shape, 1.0);
        for (const double de00 : fit->de00) EXPECT_TRUE(std::isfinite(de00));
    }
}

}  // namespace
}  // namespace nacre
