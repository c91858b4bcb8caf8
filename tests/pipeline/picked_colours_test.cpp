// Picks that are colours, from a scene to its plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "io/ocio/colour_config.h"
#include "io/ocio/ocio_spaces.h"
#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/light.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/shade/palette_colour.h"
#include "pipeline/picked_colours.h"

namespace nacre::test {
namespace {

const std::string picks = "[material.m]\npicks = [ { angle_deg = 0, ";

Plan plan_of(const std::string& text, const PlanRequest& request = {}) {
    return plan_scene(parse_scene(text, "s.toml"), scene_files_with_colours("s.toml", "", open_ocio_spaces), request);
}

const Palette& palette_of(const Plan& plan) {
    return std::get<Palette>(plan.materials.at(0).mechanism);
}

std::string numbers(const Rgb& colour) {
    char text[120];
    std::snprintf(text, sizeof text, "[%.17g, %.17g, %.17g]", colour.r, colour.g, colour.b);
    return text;
}

TEST(PickedColours, ComeBackInEverySpaceOfOurConfig) {
    const ColourConfig config = ColourConfig::open({"", "", "test"});
    int spaces = 0;
    for (const char* illuminant : {"D65", "A", "E"}) {
        LightSettings settings;
        settings.illuminant = illuminant;
        settings.power = *illuminant_by_name(illuminant);
        const Light light = make_light(settings);
        for (const std::string& space : config.colour_spaces()) {
            const ColourTransform transform = config.to_colour_space(space, "test");
            if (!transform.has_inverse()) continue;
            ++spaces;
            const auto colour = [&](double peak_nm, double width_nm, double height) {
                return transform.to_rgb(adapt(light.adaptation, lobe_to_xyz(light, {peak_nm, width_nm, height})));
            };
            const Plan plan = plan_of("[light]\nilluminant = \"" + std::string(illuminant) + "\"\n" + picks +
                                      "colour = " + numbers(colour(540, 190, 0.6)) + ", space = \"" + space +
                                      "\" },\n{ angle_deg = 50, colour = " + numbers(colour(580, 260, 0.4)) +
                                      ", space = \"" + space + "\" } ]\n");
            EXPECT_TRUE(plan.warnings.empty()) << space << ": " << plan.warnings.front();
            ASSERT_EQ(plan.materials.at(0).picked.size(), 2u);
            for (const PickedColour& picked : plan.materials.at(0).picked) {
                EXPECT_TRUE(picked.is_met()) << space;
                EXPECT_LE(picked.de00, 0.01) << space << " under " << illuminant;
            }
            // Through single precision, where a space is no matrix.
            EXPECT_NEAR(palette_of(plan).picks[0].lobe.peak_nm, 540.0, 3.0) << space << " under " << illuminant;
            EXPECT_NEAR(palette_of(plan).picks[1].lobe.width_nm, 260.0, 10.0) << space << " under " << illuminant;
        }
    }
    EXPECT_GT(spaces, 20);
}

TEST(PickedColours, MixWithNumbersAndSayWhatTheyBecame) {
    const Plan plan =
        plan_of(picks + "colour = \"#2c2\" }, { angle_deg = 40, peak_nm = 460, width_nm = 80, height = 0.5 } ]\n");
    ASSERT_EQ(plan.materials.at(0).picked.size(), 1u);
    const PickedColour& picked = plan.materials.at(0).picked.front();
    EXPECT_EQ(picked.text, "#2c2");
    EXPECT_EQ(picked.pick, 0u);
    EXPECT_EQ(palette_of(plan).picks[0].lobe.peak_nm, picked.lobe->peak_nm);
    EXPECT_EQ(palette_of(plan).picks[1].lobe.peak_nm, 460.0);
    EXPECT_EQ(
        plan_of(picks + "colour = \"#22cc22\" }, { angle_deg = 40, peak_nm = 460, width_nm = 80, height = 0.5 } ]\n")
            .materials.at(0)
            .mechanism,
        plan.materials.at(0).mechanism);
}

TEST(PickedColours, BlackFadesWhereItsNeighbourIs) {
    const Plan plan = plan_of(picks +
                              "colour = \"#000000\" }, { angle_deg = 30, colour = \"#22cc22\" },\n"
                              "{ angle_deg = 80, peak_nm = 460, width_nm = 80, height = 0.5 } ]\n");
    const auto& all = palette_of(plan).picks;
    EXPECT_EQ(all[0].lobe.peak_nm, all[1].lobe.peak_nm);
    EXPECT_EQ(all[0].lobe.width_nm, all[1].lobe.width_nm);
    EXPECT_EQ(all[0].lobe.height, 0.0);
    EXPECT_EQ(plan.materials.at(0).picked[0].lobe->peak_nm, all[0].lobe.peak_nm) << "as it is told";
    EXPECT_EQ(plan.materials.at(0).picked[0].lobe->width_nm, all[0].lobe.width_nm);
    EXPECT_TRUE(plan.warnings.empty());
    const Plan night = plan_of(picks + "colour = \"#000\" }, { angle_deg = 30, colour = [0, 0, 0] } ]\n");
    EXPECT_EQ(palette_of(night).picks[1].lobe.height, 0.0);
}

TEST(PickedColours, PurpleIsMet) {
    const Plan plan = plan_of(picks + "colour = \"#c030c0\" }, { angle_deg = 40, colour = \"#22cc22\" } ]\n");
    EXPECT_TRUE(plan.warnings.empty()) << plan.warnings.front();
    const Lobe& notch = palette_of(plan).picks[0].lobe;
    EXPECT_GT(notch.floor, notch.height);
    EXPECT_LT(plan.materials.at(0).picked[0].de00, 0.01);
}

TEST(PickedColours, ThatNoReflectanceHasAreDimmedWithAWarningOrRefused) {
    const auto scene = [](const std::string& colour) {
        return picks + "colour = " + colour +
               ", space = \"lin_rec709\" }, { angle_deg = 40, colour = \"#22cc22\" } ]\n";
    };
    for (const auto& [colour, why] :
         {std::pair{"[0.1, 1.3, 0.1]", "because no reflectance is both so bright and so saturated"},
          {"[0.2, 1.8, 0.1]", "because no surface reflects more light than it receives"},
          {"[2, 2, 2.5]", "because no surface reflects more light than it receives"},
          {"[58, 111, 208]", "components go from 0 to 1, and these look like 0 to 255"},
          {"[-0.1, 0.3, -0.2]", "because it is more saturated than the light of a single wavelength"},
          {"[-1, -1, -1]", "because the colour is darker than black"}}) {
        const Plan plan = plan_of(scene(colour));
        ASSERT_EQ(plan.warnings.size(), 1u);
        EXPECT_NE(plan.warnings[0].find(why), std::string::npos) << plan.warnings[0];
        EXPECT_THROW(plan_of(scene(colour), {{}, false, true}), Error);
    }
    const Plan plan = plan_of(scene("[0.1, 1.3, 0.1]"));
    EXPECT_EQ(plan.warnings[0].find("s.toml:2:37 [material.m]: picks[0], [0.1, 1.3, 0.1] in lin_rec709: is dimmed to "),
              0u)
        << plan.warnings[0];
}

struct Mistake {
    const char* name;
    std::string pick;     // the second
    std::string message;  // behind "s.toml:3:"
};
void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}
class BadPick : public testing::TestWithParam<Mistake> {};

TEST_P(BadPick, IsOneLineThatSaysWhereAndWhat) {
    try {
        plan_of(picks + "colour = \"#22cc22\" },\n{ angle_deg = 40, " + GetParam().pick + " } ]\n");
        FAIL() << "was accepted";
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.substr(0, GetParam().message.size() + 9), "s.toml:3:" + GetParam().message) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes, BadPick,
    testing::Values(
        Mistake{"NoHex", "colour = \"#12g\"",
                "28 [material.m]: colour = \"#12g\" is not a colour; give \"#rrggbb\", \"#rgb\" or [r, g, b]"},
        Mistake{"AName", "colour = \"red\"",
                "28 [material.m]: colour = \"red\" is not a colour; give \"#rrggbb\", \"#rgb\" or [r, g, b]"},
        Mistake{"TwoComponents", "colour = [1, 2]", "28 [material.m]: colour has 2 components; give 3: [r, g, b]"},
        Mistake{"NaN", "colour = [0.1, nan, 0.2]",
                "34 [material.m]: colour = nan is not a finite number; allowed [-65504, 65504]"},
        Mistake{"Alpha", "colour = \"#11223380\"",
                "28 [material.m]: colour = \"#11223380\" has an alpha component, and a reflectance has none; give "
                "\"#112233\""},
        Mistake{"ANumber", "colour = 7", "28 [material.m]: colour = 7 is"},
        Mistake{"Both", "colour = \"#222\", peak_nm = 400",
                "46 [material.m]: peak_nm and colour both say what is seen; remove one of them"},
        Mistake{"SpaceAlone", "space = \"lin_rec709\"",
                "27 [material.m]: space belongs to a colour, and the pick has none; give colour = [r, g, b]"},
        Mistake{"UnknownSpace", "colour = [0, 1, 0], space = \"lin_rec907\"", "28: colour"},
        Mistake{"DataSpace", "colour = [0, 1, 0], space = \"Raw\"", "28: colour"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(OnePick, IsTheSameColourAtEveryAngleWithAWarning) {
    const Plan plan = plan_of(picks + "colour = \"#2c2\" } ]\n");
    ASSERT_EQ(plan.warnings.size(), 1u);
    EXPECT_EQ(plan.warnings[0],
              "s.toml:1:11 [material.m]: one pick gives the same colour at every angle; add a pick at another angle");
    const Palette& palette = palette_of(plan);
    ASSERT_EQ(palette.picks.size(), 1u);
    for (const double angle_deg : {0.0, 45.0, 90.0})
        EXPECT_EQ(palette_lobe(palette, Incidence::from_degrees(angle_deg)), palette.picks[0].lobe);
    EXPECT_FALSE(palette_clamp_bounds(palette).below_deg || palette_clamp_bounds(palette).above_deg);
    EXPECT_EQ(palette_of(plan_of("[material.m]\n" + mechanism_toml(plan.materials[0].mechanism))), palette);
}

// Three picks on a straight line for p = 0.5: cos 60 = 0.5, so Y = 1, 0.375 and 0.
const std::string straight =
    "[material.m]\npicks = [ { angle_deg = 0, peak_nm = 560, width_nm = 120, height = 0.9 },\n"
    "{ angle_deg = 60, peak_nm = 510, width_nm = 145, height = 0.65 },\n"
    "{ angle_deg = 90, peak_nm = 480, width_nm = 160, height = 0.5 } ]\n";

TEST(FittedShape, IsThePicksOwnAndAGivenOneIsKept) {
    const Plan plan = plan_of(straight);
    EXPECT_NEAR(palette_of(plan).shape, 0.5, 1e-3);
    ASSERT_TRUE(plan.materials.at(0).shape_fit.has_value());
    EXPECT_EQ(plan.materials.at(0).shape_fit->shape, palette_of(plan).shape);
    EXPECT_EQ(plan.materials.at(0).shape_fit->de00.size(), 3u);
    EXPECT_TRUE(plan.warnings.empty());
    const Plan given = plan_of(straight + "shape = 0.2\n");
    EXPECT_EQ(palette_of(given).shape, 0.2);
    EXPECT_FALSE(given.materials.at(0).shape_fit.has_value());
    // What a header carries is given.
    const Plan again = plan_of("[material.m]\n" + mechanism_toml(plan.materials[0].mechanism));
    EXPECT_EQ(again.materials[0].mechanism, plan.materials[0].mechanism);
    EXPECT_FALSE(again.materials.at(0).shape_fit.has_value());
    const Plan two = plan_of(picks + "colour = \"#2c2\" }, { angle_deg = 40, colour = \"#22c\" } ]\n");
    EXPECT_EQ(palette_of(two).shape, Palette::default_shape);
    EXPECT_FALSE(two.materials.at(0).shape_fit.has_value());
}

}  // namespace
}  // namespace nacre::test
