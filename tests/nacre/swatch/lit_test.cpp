// Objects in a light: what a ray to them meets, and the picture of that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "nacre/optics/base.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/swatch/lit_picture.h"
#include "nacre/swatch/lit_table.h"
#include "nacre/swatch/studio.h"
#include "nacre/swatch/swatch.h"
#include "nacre/swatch/swatch_disc.h"
#include "nacre/swatch/swatch_gamut.h"
#include "nacre/swatch/swatch_lit.h"
#include "nacre/swatch/swatch_puddle.h"
#include "nacre/swatch/swatch_sphere.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

LitTable even_table(double luminance, Quantity quantity = Quantity::incidence) {
    LitTable table;
    table.mirrored = Image<Xyz>(16, 1, grey(luminance));
    table.quantity = quantity;
    return table;
}

// A ray that meets the ball where the normal is (x, y, sqrt(1 - x^2 - y^2)), from far away along -z.
Ray straight_at(double x, double y) {
    return {{x, y, 50.0}, {0.0, 0.0, -1.0}};
}

PlannedSwatch planned_lit(SwatchKind kind, const Palette& palette) {
    PlannedSwatch swatch;
    swatch.kind = kind;
    swatch.title = "title";
    swatch.jobs = swatch_jobs(kind, {"material", palette, {}}, test::light_of());
    return swatch;
}

std::vector<std::string> texts_of(const Swatch& swatch) {
    std::vector<std::string> texts;
    for (const Overlay& overlay : swatch.overlays) {
        if (const auto* text = std::get_if<Text>(&overlay)) texts.push_back(text->text);
    }
    return texts;
}

bool has(const std::vector<std::string>& texts, const std::string& text) {
    return std::find(texts.begin(), texts.end(), text) != texts.end();
}

// So that exposure 0 means the same for every material.
TEST(Studio, ItsBrightestLightIsWhite) {
    double brightest = 0.0;
    for (int i = 0; i < 400; ++i) {
        for (int j = 0; j < 400; ++j) {
            const double polar = std::numbers::pi * (i + 0.5) / 400.0, turn = 2.0 * std::numbers::pi * j / 400.0;
            const glm::dvec3 way{std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn)};
            brightest = std::max(brightest, studio_luminance({{}, way}, 0.0));
        }
    }
    // A wall behind the light adds to it.
    EXPECT_GT(brightest, 0.95);
    EXPECT_LT(brightest, 1.5);
}

// Exact as long as all of the ball is above the floor: cos / distance^2 of a sphere of radius 1.
TEST(Studio, TheBallShadesTheFloorWhereItStandsAndNotFarAway) {
    const auto floor_below = [](double x) { return studio_luminance({{x, 0.0, 0.0}, {0.0, -1.0, 0.0}}, 0.0); };
    EXPECT_NEAR(floor_below(0.0), 0.0, 1e-12);
    EXPECT_LT(floor_below(0.5), 0.5 * floor_below(2.5));
}

TEST(Studio, ABlurKeepsWhatALightGivesInAll) {
    // Around the light overhead: the sum over a square of directions that it fills half.
    const auto sum = [](double blur) {
        double total = 0.0;
        for (int i = -60; i <= 60; ++i) {
            for (int j = -60; j <= 60; ++j)
                total += studio_luminance({{}, glm::normalize(glm::dvec3{0.02 * i, 1.0, 0.02 * j})}, blur);
        }
        return total;
    };
    EXPECT_NEAR(sum(0.1) / sum(0.0), 1.0, 0.01);
}

// CIE S 011: the horizon has a third of the zenith's luminance.
TEST(Studio, TheOvercastSkyHasAThirdOfItsZenithAtTheHorizon) {
    EXPECT_NEAR(overcast_sky({0.0, 1.0, 0.0}), 1.0, 1e-12);
    EXPECT_NEAR(overcast_sky({1.0, 0.0, 0.0}), 1.0 / 3.0, 1e-12);
}

TEST(Ball, APerfectMirrorShowsTheStudioInTheMirrorDirection) {
    const LitTable table = even_table(1.0);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.3, 0.4}, {-0.6, 0.5}, {0.2, -0.7}}) {
        const glm::dvec3 normal{x, y, std::sqrt(1.0 - x * x - y * y)};
        const glm::dvec3 mirrored = 2.0 * normal.z * normal - glm::dvec3{0.0, 0.0, 1.0};
        const Seen seen = look_at_ball(table, straight_at(x, y));
        EXPECT_NEAR(seen.material.y, studio_luminance({normal, mirrored}, 0.0), 1e-9) << x << " " << y;
        EXPECT_EQ(seen.rest.y, 0.0);
    }
}

TEST(Ball, IsMultipliedByTheReflectanceAtTheAngleAtWhichItIsSeen) {
    LitTable ramp = even_table(0.0);
    ramp.mirrored = Image<Xyz>(101, 1);
    for (int i = 0; i <= 100; ++i) ramp.mirrored.at(i, 0) = grey(0.01 * i);  // sqrt(cos)
    const double y = std::sin(std::numbers::pi / 3.0);                       // 60 degrees
    const double white = look_at_ball(even_table(1.0), straight_at(0.0, y)).material.y;
    EXPECT_NEAR(look_at_ball(ramp, straight_at(0.0, y)).material.y, std::sqrt(0.5) * white, 1e-4);
}

TEST(Ball, ShowsASecondAxisFromPoleToPole) {
    LitTable table = even_table(0.0);
    table.mirrored = Image<Xyz>(2, 181);
    for (int row = 0; row <= 180; ++row) {
        // The first value is in the last row.
        for (int column = 0; column < 2; ++column) table.mirrored.at(column, row) = grey((180 - row) / 180.0);
    }
    for (const double latitude_deg : {-60.0, 0.0, 45.0}) {
        const double y = std::sin(latitude_deg * std::numbers::pi / 180.0);
        const double white = look_at_ball(even_table(1.0), straight_at(0.0, y)).material.y;
        EXPECT_NEAR(look_at_ball(table, straight_at(0.0, y)).material.y / white, 0.5 - latitude_deg / 180.0, 1e-9);
    }
}

TEST(Ball, WhatABaseScattersIsMatte) {
    LitTable table = even_table(0.0);
    table.scattered = Image<Xyz>(16, 1, grey(0.5));
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {-0.4, 0.4}, {0.3, -0.8}}) {
        const glm::dvec3 normal{x, y, std::sqrt(1.0 - x * x - y * y)};
        EXPECT_NEAR(look_at_ball(table, straight_at(x, y)).material.y, 0.5 * studio_irradiance(normal), 1e-9);
    }
    EXPECT_GT(studio_irradiance({0.0, 1.0, 0.0}), 2.0 * studio_irradiance({0.0, -1.0, 0.0}));
}

TEST(Ball, ABaseIsTakenApartIntoWhatMirrorsAndWhatScatters) {
    Job job = planned_lit(SwatchKind::sphere, test::beetle).jobs.front();
    EXPECT_EQ(lit_table(job).scattered.size(), 0u);
    job.material.mechanism = Film{};
    job.material.mechanism.effects.base = GreyBase{0.4};
    const LitTable both = lit_table(job);
    job.material.mechanism.effects.base.reset();
    const LitTable film = lit_table(job);
    ASSERT_EQ(both.scattered.size(), both.mirrored.size());
    EXPECT_NEAR(both.mirrored.at(700, 0).y, film.mirrored.at(700, 0).y, 1e-6);
    EXPECT_GT(both.scattered.at(700, 0).y, 0.2);
}

TEST(Bubble, OfNothingIsInvisibleAndOfAMirrorIsOpaque) {
    const Seen clear = look_at_bubble(even_table(0.0), straight_at(0.3, 0.4));
    EXPECT_EQ(clear.material.y, 0.0);
    EXPECT_NEAR(clear.rest.y, studio_luminance(straight_at(0.3, 0.4), 0.0), 1e-12);
    const Seen mirror = look_at_bubble(even_table(1.0), straight_at(0.3, 0.4));
    EXPECT_NEAR(mirror.rest.y, 0.0, 1e-12);
    EXPECT_NEAR(mirror.material.y, look_at_ball(even_table(1.0), straight_at(0.3, 0.4)).material.y, 1e-9);
}

// 92 % passes a window of two faces of 4 % each: (1 - r) / (1 + r) = 0.923.
TEST(Bubble, TwoWallsLetThroughWhatAWindowDoes) {
    const Ray ray = straight_at(0.1, 0.2);
    EXPECT_NEAR(look_at_bubble(even_table(0.04), ray).rest.y / studio_luminance(ray, 0.0), 0.96 / 1.04, 1e-9);
}

// R and T of walls that are as even as those of even_table().
LitTable see_through(double reflected, double passes) {
    LitTable table = even_table(reflected);
    table.through = Image<Xyz>(16, 1, grey(passes));
    return table;
}

TEST(Checkerboard, HasSquaresOfTwoTonesAllAlong) {
    const auto seen = [](double x, double y) { return checkerboard(straight_at(x, y)); };
    EXPECT_EQ(seen(0.1, 0.1), light_square);
    for (const double step : {0.48, -0.48, 1.44}) {
        EXPECT_EQ(seen(0.1 + step, 0.1), dark_square) << step;
        EXPECT_EQ(seen(0.1, 0.1 + step), dark_square) << step;
        EXPECT_EQ(seen(0.1 + step, 0.1 + step), light_square) << step;
    }
}

TEST(Ball, OfATransmittanceIsSeenThroughToTheBoard) {
    for (const double x : {0.1, 0.6}) {
        const Ray ray = straight_at(x, 0.1);
        const Seen seen = look_at_ball(see_through(0.3, 0.7), ray);
        EXPECT_NEAR(seen.material.y, 0.7 * checkerboard(ray), 1e-12);
        EXPECT_EQ(seen.rest.y, 0.0) << "it mirrors nothing";
    }
    const Ray beside = straight_at(1.3, 0.1);
    EXPECT_EQ(look_at_ball(see_through(0.3, 0.7), beside).rest.y, checkerboard(beside));
}

// 1 - r of a wall that takes nothing; else what goes to and fro is t^2 (1 + r^2 + r^4 ...).
TEST(Bubble, OfATransmittanceShowsBothSides) {
    const Ray ray = straight_at(0.1, 0.1);
    const Seen clear = look_at_bubble(see_through(0.04, 0.96), ray);
    EXPECT_NEAR(clear.rest.y, light_square * 0.96 / 1.04, 1e-9);
    EXPECT_NEAR(clear.material.y, look_at_bubble(even_table(0.04), ray).material.y, 1e-12);
    const Seen grey_glass = look_at_bubble(see_through(0.1, 0.5), ray);
    EXPECT_NEAR(grey_glass.rest.y, light_square * 0.25 * (1.0 + 0.01 + 1e-4 + 1e-6 + 1e-8), 1e-9);
    EXPECT_NEAR(look_at_bubble(see_through(1.0, 0.0), ray).rest.y, 0.0, 1e-12);
}

TEST(LitSwatch, ABallThatIsSeenThroughIsExposedLikeTheBoard) {
    PlannedSwatch swatch;
    swatch.kind = SwatchKind::sphere;
    Mechanism glass = Film{1.0, 1.5, 300.0, 1.5, 0.0};
    glass.effects.observed = Observed::transmittance;
    swatch.jobs = swatch_jobs(SwatchKind::sphere, {"glass", glass, {}}, test::light_of());
    const LitImage lit = lit_image(swatch, 60);
    EXPECT_EQ(lit.exposure_ev, 0.0);
    double brightest = 0.0;
    for (const Xyz& pixel : lit.image) brightest = std::max(brightest, pixel.y);
    EXPECT_NEAR(brightest, light_square, 1e-9);
    // In the middle glass lets 96 % of the light in; there two squares meet.
    EXPECT_NEAR(std::max(lit.image.at(26, 28).y, lit.image.at(33, 28).y), 0.96 * light_square, 0.002);
}

TEST(Disc, HasAHoleAndGroovesWhereACompactDiscHasThem) {
    const LitTable table = even_table(1.0, Quantity::grating_u);
    const auto at = [&](double radius) { return look_at_disc(table, {{radius, 5.0, 0.0}, {0.0, -1.0, 0.0}}); };
    for (const double radius : {0.05, 0.2, 0.35, 0.99, 1.2}) EXPECT_EQ(at(radius).material.y, 0.0) << radius;
    EXPECT_GT(at(0.5).rest.y, 0.0);
    double most = 0.0;
    for (int turn = 0; turn < 360; ++turn) {
        const double a = turn * std::numbers::pi / 180.0;
        most = std::max(
            most, look_at_disc(table, {{0.7 * std::cos(a), 5.0, 0.7 * std::sin(a)}, {0.0, -1.0, 0.0}}).material.y);
    }
    EXPECT_GT(most, 0.5);
}

TEST(Puddle, ShowsASecondAxisFromItsEdgeToItsMiddle) {
    LitTable table = even_table(0.0);
    table.mirrored = Image<Xyz>(2, 2);
    table.mirrored.at(0, 0) = table.mirrored.at(1, 0) = grey(1.0);  // the last value
    const auto at = [&](double x) { return look_at_puddle(table, {{x, 3.0, 0.0}, {0.0, -1.0, 0.0}}); };
    EXPECT_EQ(at(3.0).material.y, 0.0);
    EXPECT_GT(at(3.0).rest.y, 0.0);
    EXPECT_GT(at(0.0).material.y, at(0.9).material.y + 0.2);
}

TEST(LitPicture, TheEdgeOfTheBallLiesBetweenBallAndRoom) {
    const LitTable table = even_table(1.0);
    const LitPicture picture = take_picture(
        ball_camera(), [&](const Ray& ray) { return look_at_ball(table, ray); }, 200);
    int edges = 0;
    for (int x = 0; x < 200; ++x) edges += picture.material.at(x, 100).y > 0.0 && picture.rest.at(x, 100).y > 0.0;
    EXPECT_GE(edges, 1);
    EXPECT_LE(edges, 4);
    EXPECT_EQ(picture.rest.at(100, 100).y, 0.0);
    EXPECT_EQ(picture.material.at(0, 0).y, 0.0);
}

// The mean of n x n samples in a pixel.
Xyz sampled_mean(const Camera& camera, const LitTable& table, int side, int column, int row, int n) {
    Xyz sum;
    for (int i = 0; i < n * n; ++i) {
        const int across = i % n, along = i / n;
        const double right = column + (across + 0.5) / n, down = row + (along + 0.5) / n;
        const Seen seen = look_at_ball(table, camera.through(2.0 * right / side - 1.0, 1.0 - 2.0 * down / side));
        sum = sum + 1.0 / (n * n) * (seen.material + seen.rest);
    }
    return sum;
}

// Smooth parts are interpolated between corners that pixels share; a picture of 900 pixels bends less between them.
TEST(LitPicture, PixelsAreWithinACodeOfTheMeanOfTheirSamples) {
    constexpr int side = 301;  // no whole number of cells
    LitTable table = even_table(0.0);
    for (int i = 0; i < 16; ++i) table.mirrored.at(i, 0) = {0.9, 0.5 + 0.03 * i, 0.04 * i};
    const Camera camera = ball_camera();
    const Image<Xyz> picture = exposed(take_picture(
                                           camera, [&](const Ray& ray) { return look_at_ball(table, ray); }, side),
                                       1.0);
    const auto code = [](double linear) { return 255.0 * std::pow(std::clamp(linear, 0.0, 1.0), 1.0 / 2.4); };
    double most = 0.0;
    for (int row = 0; row < side; row += 3) {
        for (int column = 0; column < side; ++column) {
            const Xyz few = sampled_mean(camera, table, side, column, row, 2);
            const Xyz many = sampled_mean(camera, table, side, column, row, 6);
            const Xyz& seen = picture.at(column, row);
            const auto off = [&](const Xyz& mean) {
                return std::max({std::abs(code(seen.x) - code(mean.x)), std::abs(code(seen.y) - code(mean.y)),
                                 std::abs(code(seen.z) - code(mean.z))});
            };
            most = std::max(most, std::min(off(few), off(many)));
        }
    }
    EXPECT_LT(most, 0.5);
}

TEST(LitSwatch, AutomaticExposureBringsTheBrightestComponentToItsLevel) {
    for (const Palette& palette : {test::morpho, test::beetle}) {
        const Swatch swatch = draw_swatch(planned_lit(SwatchKind::sphere, palette));
        double brightest = 0.0;
        for (const Xyz& pixel : swatch.panels.at(0).image) {
            const Rgb rgb = linear_rec709(pixel);
            brightest = std::max({brightest, rgb.r, rgb.g, rgb.b});
        }
        // Towards the rim, which does not count, the beetle's band grows.
        EXPECT_GE(brightest, lit_brightest - 1e-9);
        EXPECT_LE(brightest, 1.3);
    }
}

TEST(LitSwatch, AFixedExposureDoublesTheMaterialAndNotTheRoom) {
    PlannedSwatch plan = planned_lit(SwatchKind::sphere, test::beetle);
    plan.exposure_ev = 0.0;
    const Swatch plain = draw_swatch(plan);
    plan.exposure_ev = 1.0;
    const Swatch brighter = draw_swatch(plan);
    const Image<Xyz>& a = plain.panels.at(0).image;
    const Image<Xyz>& b = brighter.panels.at(0).image;
    EXPECT_EQ(b.at(450, 450).y, 2.0 * a.at(450, 450).y);
    EXPECT_EQ(b.at(5, 5), a.at(5, 5));
    EXPECT_TRUE(has(texts_of(brighter), "exposure +1 EV"));
    for (const std::string& text : texts_of(plain)) EXPECT_FALSE(text.starts_with("exposure"));
}

TEST(LitSwatch, SaysTheEndsOfASecondAxis) {
    PlannedSwatch plan = planned_lit(SwatchKind::sphere, test::beetle);
    plan.jobs[0].y = parameter_axis(plan.jobs[0].material.mechanism, "width_nm", 20.0, 400.0);
    const std::vector<std::string> texts = texts_of(draw_swatch(plan));
    EXPECT_TRUE(has(texts, "width of every pick: 20 nm at the top, 400 nm at the bottom"));
}

TEST(LitSwatch, ExposuresAreSaidInStopsUnlessTheyAreZero) {
    EXPECT_EQ(exposure_text(1.324), "exposure +1.32 EV");
    EXPECT_EQ(exposure_text(-0.5), "exposure -0.5 EV");
    EXPECT_EQ(exposure_text(0.001), "");
}

}  // namespace
}  // namespace nacre
