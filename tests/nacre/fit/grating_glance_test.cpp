#include "nacre/fit/grating_glance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/bake/grating_colour.h"
#include "nacre/colour/adaptation.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/illuminant.h"
#include "reference/number.h"

namespace nacre {
namespace {

Light daylight() {
    LightSettings settings;
    settings.power = *illuminant_by_name(settings.illuminant);
    return make_light(settings);
}

Grating random_grating(reference::Uniform& random) {
    Grating grating;
    grating.period_nm = random.between(800.0, 3000.0);
    grating.depth_nm = random.between(60.0, 250.0);
    grating.land = random.between(0.15, 0.5);
    grating.grooves = static_cast<int>(random.between(60.0, 200.0));
    return grating;
}

double difference(const Xyz& one, const Xyz& other) {
    constexpr Xyz d65 = xyz_from_chromaticity(d65_chromaticity);
    return ciede2000(to_lab(one, d65), to_lab(other, d65));
}

TEST(GratingGlance, SeesWhatManyGroovesShow) {
    const Light light = daylight();
    const GratingGlance glance(light);
    int points = 0, off = 0;
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        reference::Uniform random(seed);
        const Grating grating = random_grating(random);
        const GratingColour colour(grating, light);
        for (int i = 0; i < 20; ++i) {
            // First-order light, away from the direct reflection's flanks.
            const double least_u = 420.0 / grating.period_nm;
            const double u = random.between(least_u, std::min(2.0, 2.5 * least_u));
            const Xyz exact = adapt(light.adaptation, colour.at(u));
            const Xyz seen = adapt(light.adaptation, glance.at(grating, u));
            if (exact.y < 0.02) continue;
            ++points;
            sum += std::abs(seen.y - exact.y) / exact.y;
            const bool is_near = difference(seen, exact) < 4.0 || std::abs(seen.y - exact.y) < 0.05 * exact.y;
            if (!is_near) ++off;
        }
    }
    EXPECT_GT(points, 300);
    EXPECT_LE(off, points / 20);
    EXPECT_LT(sum / points, 0.08);
}

TEST(GratingGlance, HasTheLightOfAWholeOrder) {
    // Over u every order has the light that its efficiency says, however it is drawn.
    const Light light = daylight();
    const GratingGlance glance(light);
    Grating grating;
    grating.period_nm = 2000.0;
    grating.depth_nm = 120.0;
    grating.grooves = 150;
    grating.orders = {1};
    const GratingColour colour(grating, light);
    Xyz seen, exact;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double u = 0.1 + 0.4 * (i + 0.5) / steps;
        const Xyz a = glance.at(grating, u), b = colour.at(u);
        seen = {seen.x + a.x, seen.y + a.y, seen.z + a.z};
        exact = {exact.x + b.x, exact.y + b.y, exact.z + b.z};
    }
    EXPECT_NEAR(seen.x / exact.x, 1.0, 0.02);
    EXPECT_NEAR(seen.y / exact.y, 1.0, 0.02);
    EXPECT_NEAR(seen.z / exact.z, 1.0, 0.02);
}

TEST(GratingGlance, KnowsOrdersAndAzimuth) {
    const Light light = daylight();
    const GratingGlance glance(light);
    Grating grating;
    grating.period_nm = 1000.0;
    grating.depth_nm = 120.0;
    grating.grooves = 100;
    grating.orders = {2};
    EXPECT_EQ(glance.at(grating, 0.5).y, 0.0);
    grating.orders = {1};
    EXPECT_GT(glance.at(grating, 0.5).y, 0.0);
    grating.azimuth_deg = 30.0;
    EXPECT_EQ(glance.at(grating, 0.6).y, 0.0);  // endless grooves send nothing beside their plane
    grating.groove_length_um = 0.4;
    const double seen = glance.at(grating, 0.6).y;
    EXPECT_NEAR(seen / GratingColour(grating, light).at(0.6).y, 1.0, 0.1);
}

}  // namespace
}  // namespace nacre
