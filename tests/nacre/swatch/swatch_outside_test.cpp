#include "nacre/swatch/swatch_outside.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/scene/readers/axis_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "nacre/colour/adaptation.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/gamut.h"
#include "nacre/swatch/swatch.h"
#include "support/palette_luts.h"
#include "support/test_encoding.h"

namespace nacre {
namespace {

LutSpace rec709() {
    return {"lin_rec709", test::rec709_encoding().to_rgb};
}

PlannedSwatch strip_of(const Palette& palette) {
    PlannedSwatch swatch;
    swatch.kind = SwatchKind::strip;
    swatch.jobs = swatch_jobs(SwatchKind::strip, {"material", palette, {}}, test::light_of());
    return swatch;
}

template <typename Shape>
std::vector<Shape> all_of(const Swatch& swatch) {
    std::vector<Shape> shapes;
    for (const Overlay& overlay : swatch.overlays) {
        if (const auto* shape = std::get_if<Shape>(&overlay)) shapes.push_back(*shape);
    }
    return shapes;
}

std::string caption(const Swatch& swatch) {
    for (const Text& text : all_of<Text>(swatch)) {
        if (text.text.starts_with("outside")) return text.text;
    }
    return "";
}

// The bars along the strip, without the sample before the caption.
std::vector<Box> bars(const Swatch& swatch) {
    const Panel& panel = swatch.panels.at(0);
    std::vector<Box> boxes;
    for (const Rectangle& rectangle : all_of<Rectangle>(swatch)) {
        const Box& box = rectangle.box;
        if (box.bottom == panel.top + panel.image.height() && box.bottom - box.top == outside_bar_px)
            boxes.push_back(box);
    }
    return boxes;
}

bool is_outside(const Xyz& colour) {
    const Rgb rgb = rec709().to_rgb(Image<Xyz>(1, 1, colour)).at(0, 0);
    return std::min({rgb.r, rgb.g, rgb.b}) < -1e-6;
}

// The LUT baked for itself, exactly and of another size, says at each of its texels the same as the bar above it.
TEST(SwatchOutside, TheBarLiesWhereTheLutHasNegativeComponents) {
    const PlannedSwatch plan = strip_of(test::morpho);
    const Swatch swatch = draw_swatch(plan, rec709());
    const Panel& panel = swatch.panels.at(0);
    Job job = plan.jobs.front();
    job.x.kind = &even_degrees();
    job.width = 397;
    job.height = 1;
    const Image<Xyz> lut = bake(job);
    int outside = 0, disagree = 0;
    for (int i = 0; i < job.width; ++i) {
        const double x = panel.left + 0.5 + (panel.image.width() - 1) * (i / (job.width - 1.0));
        const auto shown = bars(swatch);
        const bool is_marked =
            std::any_of(shown.begin(), shown.end(), [&](const Box& box) { return x >= box.left && x <= box.right; });
        outside += is_outside(lut.at(i, 0)) ? 1 : 0;
        disagree += is_marked != is_outside(lut.at(i, 0)) ? 1 : 0;
    }
    EXPECT_LE(disagree, 1);  // at the end of the bar, within a texel
    EXPECT_EQ(caption(swatch),
              "outside lin_rec709: " + std::to_string(std::lround(100.0 * outside / job.width)) + " % of the strip");
}

TEST(SwatchOutside, NothingIsDrawnWhereNothingIsOutsideOrNoSpaceIsGiven) {
    const Palette pale{{{0.0, {560.0, 300.0, 0.5}}, {60.0, {520.0, 300.0, 0.5}}}};
    const Swatch expected = draw_swatch(strip_of(pale)), same = draw_swatch(strip_of(pale), rec709());
    EXPECT_EQ(same.height, expected.height);
    EXPECT_EQ(same.overlays.size(), expected.overlays.size());
    EXPECT_EQ(caption(draw_swatch(strip_of(test::morpho))), "");
    EXPECT_GT(draw_swatch(strip_of(test::morpho), rec709()).height, expected.height);
}

TEST(SwatchOutside, TheColoursOfTheStripAreLeftAsTheyAre) {
    const Image<Xyz> without = draw_swatch(strip_of(test::morpho)).panels.at(0).image;
    const Image<Xyz> with = draw_swatch(strip_of(test::morpho), rec709()).panels.at(0).image;
    EXPECT_TRUE(std::equal(without.begin(), without.end(), with.begin(), with.end()));
}

TEST(SwatchOutside, HatchingOfALutWithTwoAxesLiesOnWhatIsOutside) {
    PlannedSwatch plan = strip_of(test::beetle);
    plan.jobs[0].y = parameter_axis(plan.jobs[0].material.mechanism, "width_nm", 20.0, 400.0);
    const Swatch swatch = draw_swatch(plan, rec709());
    const Panel& panel = swatch.panels.at(0);
    int lines = 0;
    for (const Polyline& line : all_of<Polyline>(swatch)) {
        ASSERT_EQ(line.points.size(), 2U);
        if (line.points[0].y > panel.top + panel.image.height()) continue;  // the sample before the caption
        ++lines;
        for (const double t : {0.0, 0.5, 1.0}) {
            const int x = static_cast<int>(std::lerp(line.points[0].x, line.points[1].x, t)) - panel.left;
            const int y = static_cast<int>(std::lerp(line.points[0].y, line.points[1].y, t)) - panel.top;
            EXPECT_TRUE(is_outside(panel.image.at(x, y))) << x << " " << y;
        }
    }
    EXPECT_GT(lines, 20);
    const auto outside = std::count_if(panel.image.begin(), panel.image.end(), is_outside);
    const double percent = 100.0 * static_cast<double>(outside) / static_cast<double>(panel.image.size());
    EXPECT_EQ(caption(swatch), "outside lin_rec709: " + std::to_string(std::lround(percent)) + " % of the picture");
}

TEST(SwatchOutside, SharesBelowOnePercentAndAllAreSaidSo) {
    const auto share = [](int outside) {
        Swatch swatch;
        swatch.height = 400;
        Image<Xyz> colours(1000, 1);
        for (int x = 0; x < outside; ++x) colours.at(x, 0) = {1.0, 0.0, 0.0};
        const LutSpace by_x{"space", [](const Image<Xyz>& image) {
                                return test::converted<Rgb>(image, [](const Xyz& c) { return Rgb{-c.x, 0.0, 0.0}; });
                            }};
        draw_outside(swatch, {0, 0, 1000, 1}, colours, true, by_x);
        return caption(swatch);
    };
    EXPECT_EQ(share(0), "");
    EXPECT_EQ(share(1), "outside space: less than 1 % of the strip");
    EXPECT_EQ(share(230), "outside space: 23 % of the strip");
    EXPECT_EQ(share(999), "outside space: 99 % of the strip");
    EXPECT_EQ(share(1000), "outside space: 100 % of the strip");
}

}  // namespace
}  // namespace nacre
