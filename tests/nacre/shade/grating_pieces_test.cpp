#include "nacre/shade/grating_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "nacre/shade/grating_colour.h"
#include "reference/number.h"

namespace nacre {
namespace {

Light daylight() {
    LightSettings settings;
    settings.power = *illuminant_by_name(settings.illuminant);
    return make_light(settings);
}

std::shared_ptr<const GratingPieces> coarse_pieces(const Light& light, int nm) {
    return std::make_shared<const GratingPieces>(grating_pieces(light.weights, nm, 0.0));
}

TEST(GratingPieces, CoverTheLightFromEndToEnd) {
    const Light light = daylight();
    for (const int nm : {1, 7, 20, 1000}) {
        const GratingPieces pieces = grating_pieces(light.weights, nm, 0.0);
        ASSERT_EQ(pieces.per_nm.size(), 2 * pieces.weights.size() + 1) << nm;
        EXPECT_EQ(pieces.per_nm.front(), 1.0 / light.weights.first_nm);
        EXPECT_DOUBLE_EQ(pieces.per_nm.back(), 1.0 / light.weights.last_nm);
        for (std::size_t i = 0; i + 2 < pieces.per_nm.size(); i += 2)
            EXPECT_NEAR(pieces.per_nm[i + 1], 0.5 * (pieces.per_nm[i] + pieces.per_nm[i + 2]), 1e-17) << nm;
    }
}

TEST(GratingPieces, OfDeepProfilesAreShorter) {
    const Light light = daylight();
    EXPECT_EQ(grating_pieces(light.weights, 20, 200.0).weights.size(),
              grating_pieces(light.weights, 20, 0.0).weights.size());
    EXPECT_GT(grating_pieces(light.weights, 20, 5000.0).weights.size(),
              5 * grating_pieces(light.weights, 20, 0.0).weights.size());
}

// Second road: midpoints of a thousand steps per piece, with the light's weights as they are.
TEST(GratingPieces, KeepTheMomentsOfTheWeights) {
    const Light light = daylight();
    const TristimulusWeights& weights = light.weights;
    const GratingPieces pieces = grating_pieces(weights, 25, 0.0);
    for (std::size_t piece = 0; piece < pieces.weights.size(); ++piece) {
        const double from = pieces.per_nm[2 * piece], to = pieces.per_nm[2 * piece + 2];
        double expected[3] = {}, kept[3] = {};
        constexpr int steps = 2000;
        for (int i = 0; i < steps; ++i) {
            const double s = -1.0 + 2.0 * (i + 0.5) / steps;
            const double nm = 2.0 / ((1.0 - s) * from + (1.0 + s) * to);
            const double place = nm - weights.first_nm;
            const auto cell = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(weights.count()) - 2);
            const double weight = std::lerp(weights.y[cell], weights.y[cell + 1], place - static_cast<double>(cell));
            const auto& points = pieces.weights[piece];
            const double parabola =
                0.5 * s * (s - 1.0) * points[0].y + (1.0 - s * s) * points[1].y + 0.5 * s * (s + 1.0) * points[2].y;
            for (int power = 0; power < 3; ++power) {
                expected[power] += std::pow(s, power) * weight * nm / steps;
                kept[power] += std::pow(s, power) * parabola / steps;
            }
        }
        for (int power = 0; power < 3; ++power)
            EXPECT_NEAR(kept[power], expected[power], 1e-5) << piece << ", s^" << power;
    }
}

Grating random_grating(reference::Uniform& random) {
    Grating grating;
    grating.period_nm = std::exp(random.between(std::log(400.0), std::log(5000.0)));
    grating.depth_nm = random.between(10.0, 400.0);
    grating.land = random.between(0.05, 0.5);
    grating.grooves = static_cast<int>(std::exp(random.between(0.0, std::log(200.0))));
    return grating;
}

TEST(GratingPieces, ShowLinesOfAnyWidth) {
    struct Step {
        int nm;
        double median, most;  // CIEDE2000
    };
    const Light light = daylight();
    for (const Step& step : {Step{5, 1e-3, 0.03}, {12, 4e-3, 0.5}, {20, 0.03, 5.0}}) {
        const auto pieces = coarse_pieces(light, step.nm);
        std::vector<double> differences;
        for (std::uint64_t seed = 0; seed < 150; ++seed) {
            reference::Uniform random(seed);
            const Grating grating = random_grating(random);
            const GratingColour exact(grating, light), coarse(grating, light, pieces);
            const double u = random.between(0.09, 1.0);
            const auto lab = [&](const GratingColour& colour) {
                return to_lab(adapt(light.adaptation, colour.at(u)), d65_white);
            };
            differences.push_back(ciede2000(lab(exact), lab(coarse)));
        }
        std::sort(differences.begin(), differences.end());
        EXPECT_LE(differences[differences.size() / 2], step.median) << step.nm;
        EXPECT_LE(differences.back(), step.most) << step.nm;
    }
}

TEST(GratingPieces, HaveTheLightOfAWholeOrder) {
    // Over u every order has the light that its efficiency says, however it is drawn.
    const Light light = daylight();
    Grating grating;
    grating.period_nm = 2000.0;
    grating.depth_nm = 120.0;
    grating.grooves = 150;
    grating.orders = {1};
    const GratingColour colour(grating, light), coarse(grating, light, coarse_pieces(light, 20));
    Xyz seen, exact;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double u = 0.1 + 0.4 * (i + 0.5) / steps;
        const Xyz a = coarse.at(u), b = colour.at(u);
        seen = {seen.x + a.x, seen.y + a.y, seen.z + a.z};
        exact = {exact.x + b.x, exact.y + b.y, exact.z + b.z};
    }
    EXPECT_NEAR(seen.x / exact.x, 1.0, 2e-3);
    EXPECT_NEAR(seen.y / exact.y, 1.0, 2e-3);
    EXPECT_NEAR(seen.z / exact.z, 1.0, 2e-3);
}

TEST(GratingPieces, KnowOrdersAndAzimuth) {
    const Light light = daylight();
    const auto pieces = coarse_pieces(light, 20);
    Grating grating;
    grating.period_nm = 1000.0;
    grating.depth_nm = 120.0;
    grating.grooves = 100;
    grating.orders = {2};
    EXPECT_LT(GratingColour(grating, light, pieces).at(0.5).y, 1e-3);
    grating.orders = {1};
    EXPECT_GT(GratingColour(grating, light, pieces).at(0.5).y, 0.1);
    grating.azimuth_deg = 30.0;
    EXPECT_EQ(GratingColour(grating, light, pieces).at(0.6).y, 0.0);  // endless grooves send nothing beside their plane
    grating.groove_length_um = 0.4;
    const double seen = GratingColour(grating, light, pieces).at(0.6).y;
    EXPECT_NEAR(seen / GratingColour(grating, light).at(0.6).y, 1.0, 5e-3);
}

}  // namespace
}  // namespace nacre
