// Picks that are colours, from a scene to the file that says what became of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/ocio/colour_config.h"
#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "nacre/colour/illuminant.h"
#include "nacre/colour/light.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "pipeline/picked_colours.h"
#include "support/program.h"

namespace nacre::test {
namespace {

const std::string picks = "[material.m]\npicks = [ { angle_deg = 0, ";

Plan plan_of(const std::string& text, const PlanRequest& request = {}) {
    return plan_scene(parse_scene(text, "s.toml"), scene_files_with_colours("s.toml", ""), request);
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
            if (!transform.has_way_back()) continue;
            ++spaces;
            const auto colour = [&](double peak_nm, double width_nm, double height) {
                return transform.apply(adapt(light.adaptation, lobe_to_xyz(light.weights, peak_nm, width_nm, height)));
            };
            const Plan plan = plan_of("[light]\nilluminant = \"" + std::string(illuminant) + "\"\n" + picks +
                                      "colour = " + numbers(colour(540, 190, 0.6)) + ", space = \"" + space +
                                      "\" },\n{ angle_deg = 50, colour = " + numbers(colour(580, 260, 0.4)) +
                                      ", space = \"" + space + "\" } ]\n");
            EXPECT_TRUE(plan.warnings.empty()) << space << ": " << plan.warnings.front();
            ASSERT_EQ(plan.materials.at(0).picked.size(), 2u);
            for (const PickedColour& picked : plan.materials.at(0).picked) {
                EXPECT_EQ(picked.lobe->miss, LobeMiss::none) << space;
                EXPECT_LE(picked.lobe->de00, 0.01) << space << " under " << illuminant;
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

TEST(PickedColours, ThatNoBandHasAreWarnedOfOrRefused) {
    const std::string purple = picks + "colour = \"#c030c0\" }, { angle_deg = 40, colour = \"#22cc22\" } ]\n";
    const Plan plan = plan_of(purple);
    ASSERT_EQ(plan.warnings.size(), 1u);
    EXPECT_EQ(
        plan.warnings[0].find("s.toml:2:37 [material.m]: picks[0], #c030c0: the nearest band misses by CIEDE2000 "), 0u)
        << plan.warnings[0];
    EXPECT_NE(plan.warnings[0].find("no single band has this chromaticity"), std::string::npos);
    EXPECT_THROW(plan_of(purple, {{}, false, true}), Error);
    for (const auto& [colour, why] : {std::pair{"[0.1, 1.3, 0.1]", "no band that is so bright is so saturated"},
                                      {"[0.2, 1.8, 0.1]", "no surface reflects more light than it receives"},
                                      {"[2, 2, 2]", "no surface reflects more light than it receives"},
                                      {"[-1, -1, -1]", "the colour is darker than black"}}) {
        const Plan missed = plan_of(picks + "colour = " + colour +
                                    ", space = \"lin_rec709\" }, { angle_deg = 40, colour = \"#22cc22\" } ]\n");
        ASSERT_EQ(missed.warnings.size(), 1u);
        EXPECT_NE(missed.warnings[0].find(why), std::string::npos) << missed.warnings[0];
    }
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
        Mistake{"ANumber", "colour = 7", "28 [material.m]: colour = 7 is"},
        Mistake{"Both", "colour = \"#222\", peak_nm = 400",
                "46 [material.m]: peak_nm and colour both say what is seen; remove one of them"},
        Mistake{"SpaceAlone", "space = \"lin_rec709\"",
                "27 [material.m]: space belongs to a colour, and the pick has none; give colour = [r, g, b]"},
        Mistake{"UnknownSpace", "colour = [0, 1, 0], space = \"lin_rec907\"", "28: colour"},
        Mistake{"DataSpace", "colour = [0, 1, 0], space = \"Raw\"", "28: colour"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(PickedColours, StandInThePlanTheHeaderAndTheManifest) {
    const TemporaryFolder folder;
    folder.file("s.toml",
                picks + "colour = \"#2c2\" }, { angle_deg = 40, colour = \"#c030c0\" } ]\n[accuracy]\nmax_de00 = 1\n");
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult plan = run_nacre({"plan", "s.toml"}, here);
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_NE(plan.out.find("m: #2c2 at 0 deg is the band peak_nm = "), std::string::npos) << plan.out;
    EXPECT_NE(plan.err.find("picks[1], #c030c0: the nearest band misses by CIEDE2000 "), std::string::npos) << plan.err;
    const ProgramResult refused = run_nacre({"bake", "s.toml", "--strict", "-o", "out"}, here);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.toml"});
    const ProgramResult baked = run_nacre({"bake", "s.toml", "-o", "out"}, here);
    ASSERT_EQ(baked.exit_code, 0) << baked.err;
    const auto manifest = nlohmann::json::parse(file_bytes(folder.path() / "out" / "m.json"));
    ASSERT_EQ(manifest["picked"].size(), 2u);
    EXPECT_EQ(manifest["picked"][0]["match"], "exact");
    EXPECT_EQ(manifest["picked"][1]["colour"], "#c030c0");
    EXPECT_GT(manifest["picked"][1]["de00"], 5.0);
    EXPECT_NE(file_bytes(folder.path() / "out" / "m.exr").find("#2c2 at 0 deg: exact; #c030c0 at 40 deg: dE00 "),
              std::string::npos);
    const ProgramResult verified = run_nacre({"verify", "out/m.exr"}, here);
    EXPECT_EQ(verified.exit_code, 0) << verified.err;
}

TEST(OnePick, IsTheSameColourAtEveryAngleWithAWarning) {
    const Plan plan = plan_of(picks + "colour = \"#2c2\" } ]\n");
    ASSERT_EQ(plan.warnings.size(), 1u);
    EXPECT_EQ(plan.warnings[0],
              "s.toml:1:11 [material.m]: one pick says nothing about other angles: the same colour at all of them");
    const Palette& palette = palette_of(plan);
    ASSERT_EQ(palette.picks.size(), 1u);
    for (const double angle_deg : {0.0, 45.0, 90.0})
        EXPECT_EQ(palette_lobe(palette, Incidence::from_degrees(angle_deg)), palette.picks[0].lobe);
    EXPECT_FALSE(palette_clamp_bounds(palette).below_deg || palette_clamp_bounds(palette).above_deg);
    EXPECT_EQ(palette_of(plan_of("[material.m]\n" + mechanism_toml(plan.materials[0].mechanism))), palette);
}

TEST(OnePick, BakesWithEverySwatchAndAxis) {
    const TemporaryFolder folder;
    std::string scene = picks + "peak_nm = 520, width_nm = 120, height = 0.6 } ]\n[accuracy]\nmax_de00 = 1\n[lut.a]\n";
    scene += "[lut.b]\nx = \"cos_theta\"\ny = { parameter = \"picks[0].peak_nm\", from = 400, to = 700 }\n";
    scene += "[lut.c]\nx = { parameter = \"shape\", from = 0, to = 1 }\nangle_deg = 30\n";
    for (const char* kind : {"plane", "palette", "strip", "sphere"})
        scene += "[swatch." + std::string(kind) + "]\ndraw = \"" + kind + "\"\n";
    folder.file("s.toml", scene);
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult baked = run_nacre({"bake", "s.toml", "-o", "out"}, here);
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
    EXPECT_NE(baked.err.find("one pick says nothing about other angles"), std::string::npos) << baked.err;
    for (const char* file : {"a.exr", "b.exr", "c.exr", "plane.png", "palette.png", "strip.png", "sphere.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / file)) << file;
    const ProgramResult verified = run_nacre({"verify", "out/a.exr", "out/b.exr", "out/c.exr"}, here);
    EXPECT_EQ(verified.exit_code, 0) << verified.err;
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

TEST(FittedShape, StandsInThePlan) {
    const TemporaryFolder folder;
    folder.file("s.toml", straight + "[accuracy]\nmax_de00 = 1\n");
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult plan = run_nacre({"plan", "s.toml"}, here);
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_NE(plan.out.find("m: shape = 0.5 is nearest to its picks; straight lines would miss them by CIEDE2000 "
                            "0 at 0 deg, 0 at 60 deg, 0 at 90 deg"),
              std::string::npos)
        << plan.out;
    const ProgramResult json = run_nacre({"plan", "s.toml", "--json"}, here);
    const std::string first = json.out.substr(0, json.out.find('\n'));
    EXPECT_NE(json.out.find("\"shape_fit\""), std::string::npos) << first;
    EXPECT_NE(json.out.find("\"straight_line_de00\""), std::string::npos) << first;
}

TEST(Pick, PrintsASceneThatBakes) {
    const TemporaryFolder folder;
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult picked = run_nacre({"pick", "#22cc66@0", "0.1,0.2,0.9@50", "--name", "my.wing"}, here);
    ASSERT_EQ(picked.exit_code, 0) << picked.err;
    EXPECT_NE(picked.out.find("{ angle_deg = 0, colour = \"#22cc66\" },  # peak_nm = "), std::string::npos)
        << picked.out;
    EXPECT_NE(picked.out.find("colour = [0.1, 0.2, 0.9] },  # "), std::string::npos) << picked.out;
    folder.file("s.toml", picked.out);
    const ProgramResult baked = run_nacre({"bake", "s.toml", "-o", "out"}, here);
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "my.wing.exr"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "my.wing_sphere.png"));
    const ProgramResult json = run_nacre({"--json", "pick", "#22cc66@0", "#1fb5c9@50"}, here);
    EXPECT_EQ(nlohmann::json::parse(json.out)["picked"].size(), 2u);
}

TEST(Pick, SaysInOneLineWhatIsWrong) {
    const auto message_of = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "pick");
        const ProgramResult result = run_nacre(arguments);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.out, "");
        return result.err;
    };
    EXPECT_EQ(message_of({}),
              "nacre: nacre pick takes colours, COLOUR@ANGLE, or --measured FILE; give one of the two\n");
    EXPECT_EQ(message_of({"#22cc66", "#fff@3"}),
              "nacre: #22cc66: has no angle; give COLOUR@ANGLE, as in \"#22cc66@0\"\n");
    EXPECT_EQ(message_of({"green@0", "#fff@3"}),
              "nacre: green@0: \"green\" is no colour; give \"#rrggbb\", \"#rgb\" or r,g,b\n");
    EXPECT_EQ(message_of({"#fff@91", "#fff@3"}),
              "nacre: #fff@91: the angle is out of range; allowed [0, 90] degrees\n");
    EXPECT_EQ(message_of({"#fff@x", "#fff@3"}),
              "nacre: #fff@x: \"x\" is no angle; give COLOUR@ANGLE, as in \"#22cc66@0\"\n");
    EXPECT_NE(message_of({"#f0f@0", "#2c2@3", "--strict"})
                  .find("nacre: #f0f at 0 deg: the nearest band misses by CIEDE2000 "),
              std::string::npos);
    EXPECT_NE(message_of({"#2f2@0", "#2c2@0"}).find("different colours at one angle"), std::string::npos);
    EXPECT_NE(message_of({"#2f2@0", "#2c2@9", "--space", "lin_rec907"}).find("lin_rec907"), std::string::npos);
}

}  // namespace
}  // namespace nacre::test
