// Random materials of two and three picks, from a scene's text to a baked LUT: at each pick a shader fetches the picked
// colour. Fetch, colours and differences are the reference model's. NACRE_PICK_SWEEP=1 takes 1000 materials.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "io/ocio/colour_config.h"
#include "io/ocio/ocio_spaces.h"
#include "io/scene/scene_file.h"
#include "nacre/accuracy/choose_lut.h"
#include "nacre/pick/band/picked_bands.h"
#include "nacre/scene/plan.h"
#include "pipeline/baked_lut.h"
#include "pipeline/picked_colours.h"
#include "reference/lut.h"

namespace nacre::test {
namespace {

struct RandomPick {
    double angle_deg;
    reference::ModelXyz colour;
    bool can_be_had;  // every sRGB colour can, under D65
    std::string text;
};

// One in eight is brighter than a screen shows, so that some have to be dimmed.
RandomPick random_pick(reference::Dice& dice, double angle_deg) {
    char text[240];
    const auto rgb = random_rgb(dice);
    if (dice.chance(0.125)) {
        const reference::ModelRgb linear{1.4 * rgb[0], 1.4 * rgb[1], 1.4 * rgb[2]};
        std::snprintf(text, sizeof text,
                      "{ angle_deg = %.17g, colour = [%.17g, %.17g, %.17g], space = \"lin_rec709\" }", angle_deg,
                      linear[0], linear[1], linear[2]);
        return {angle_deg, reference::from_rec709(linear), false, text};
    }
    const auto byte = [](double component) { return static_cast<int>(std::lround(255.0 * component)); };
    std::snprintf(text, sizeof text, "{ angle_deg = %.17g, colour = \"#%02x%02x%02x\" }", angle_deg, byte(rgb[0]),
                  byte(rgb[1]), byte(rgb[2]));
    return {angle_deg, reference::from_srgb({byte(rgb[0]) / 255.0, byte(rgb[1]) / 255.0, byte(rgb[2]) / 255.0}), true,
            text};
}

std::vector<RandomPick> random_material(reference::Dice& dice) {
    std::vector<RandomPick> picks;
    const int count = dice.whole(2, 3);
    for (int i = 0; i < count; ++i) picks.push_back(random_pick(dice, 28.0 * i + dice.between(0.0, 24.0, 10.0)));
    return picks;
}

std::string scene_of(const std::vector<RandomPick>& picks) {
    std::string text = "[material.m]\npicks = [ ";
    for (const RandomPick& pick : picks) text += (&pick == &picks.front() ? "" : ", ") + pick.text;
    return text + " ]\n[lut.m]\nx = \"sqrt_cos_theta\"\n";
}

reference::Pixels pixels_of(const Image<Rgb>& image) {
    reference::Pixels pixels{image.width(), image.height(), {}};
    for (const Rgb& texel : image) pixels.rgb.push_back({texel.r, texel.g, texel.b});
    return pixels;
}

TEST(PickedMaterials, ShowTheirPicksInTheirLutsWithinTheBound) {
    const ColourConfig config = ColourConfig::open({"", "", "test"});
    const SceneFiles files = scene_files_with_colours("s.toml", "", open_ocio_spaces);
    reference::Dice dice(7);
    Failures failures;
    int dimmed = 0, not_reached = 0;
    const int count = sweeps_all_picks() ? 1000 : 60;
    for (int i = 0; i < count; ++i) {
        const std::vector<RandomPick> picks = random_material(dice);
        const std::string scene = scene_of(picks);
        const Plan plan = plan_scene(parse_scene(scene, "s.toml"), files);
        const ColourTransform transform = config.to_colour_space(plan.colour.space, "test");
        const ChosenLut chosen = choose_lut(plan.luts.at(0), lut_encoding(transform, plan.colour.gamut));
        const BakedLut baked = bake_lut(chosen, plan, {}, transform);
        ASSERT_TRUE(baked.reached) << scene;
        not_reached += !chosen.is_reached;
        // What is asked for by default is a goal; a LUT that misses it says what it reaches.
        const double bound = chosen.is_reached ? chosen.lut.request.max_de00 : *baked.reached;
        const reference::Pixels lut = pixels_of(baked.image);
        const double scale = reference::scale_of(lut);
        const auto& picked = plan.materials.at(0).picked;
        ASSERT_EQ(picked.size(), picks.size());
        for (std::size_t k = 0; k < picks.size(); ++k) {
            const reference::ModelXyz shown = as_model(picked[k].shown.colour);
            // The colour itself, if it can be had; what it is dimmed to is judged in exact_bands_test.cpp.
            dimmed += !picked[k].shown.is_as_picked();
            const reference::ModelXyz wanted = picks[k].can_be_had ? picks[k].colour : shown;
            const double x = std::sqrt(std::cos(picks[k].angle_deg * std::numbers::pi / 180.0));
            const double error = reference::error_at(lut, scale, x, 0.0, wanted);
            // 0.01 for the band itself, as everywhere.
            if (!(error <= bound + 0.01))
                failures.add(picks[k].text + " differs by " + std::to_string(error) + " where " +
                             std::to_string(bound) + " was promised in\n" + scene);
        }
    }
    EXPECT_EQ(failures.count, 0) << "of " << count << ", such as" << failures.first.str();
    EXPECT_GT(dimmed, 0);
    RecordProperty("not_reached", not_reached);
}

}  // namespace
}  // namespace nacre::test
