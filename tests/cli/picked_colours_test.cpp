// Picks that are colours, in the program: what the plan, the header and the manifest say of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.h"

namespace nacre::test {
namespace {

const std::string picks = "[material.m]\npicks = [ { angle_deg = 0, ";

TEST(PickedColours, StandInThePlanTheHeaderAndTheManifest) {
    const TemporaryFolder folder;
    folder.file("s.toml",
                picks +
                    "colour = \"#2c2\" }, { angle_deg = 40, colour = [0.1, 1.3, 0.1], space = \"lin_rec709\" } ]\n" +
                    "[accuracy]\nmax_de00 = 1\n");
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult plan = run_nacre({"plan", "s.toml"}, here);
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_NE(plan.out.find("m: #2c2 at 0 deg is the band peak_nm = "), std::string::npos) << plan.out;
    EXPECT_NE(plan.err.find("picks[1], [0.1, 1.3, 0.1] in lin_rec709: is dimmed to "), std::string::npos) << plan.err;
    const ProgramResult refused = run_nacre({"bake", "s.toml", "--strict", "-o", "out"}, here);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.toml"});
    const ProgramResult baked = run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, here);
    ASSERT_EQ(baked.exit_code, 0) << baked.err;
    const auto manifest = nlohmann::json::parse(file_bytes(folder.path() / "out" / "m.json"));
    ASSERT_EQ(manifest["picked"].size(), 2u);
    EXPECT_EQ(manifest["picked"][0]["match"], "exact");
    EXPECT_EQ(manifest["picked"][1]["colour"], "[0.1, 1.3, 0.1] in lin_rec709");
    EXPECT_EQ(manifest["picked"][1]["match"], "dimmed");
    const double luminance = manifest["picked"][1]["shown_luminance"];
    EXPECT_GT(luminance, 0.5);
    EXPECT_LT(luminance, 0.95);
    EXPECT_EQ(manifest["picked"][1]["shown_chroma"], 1.0);
    EXPECT_NE(file_bytes(folder.path() / "out" / "m.exr")
                  .find("#2c2 at 0 deg: exact; [0.1, 1.3, 0.1] in lin_rec709 at 40 deg: dimmed to "),
              std::string::npos);
    const ProgramResult verified = run_nacre({"verify", "out/m.exr"}, here);
    EXPECT_EQ(verified.exit_code, 0) << verified.err;
}

TEST(PickedColours, HaveATolerance) {
    const TemporaryFolder folder;
    folder.file("s.toml",
                "[material.m]\nmechanism = \"film\"\nindex = \"tio2\"\nsubstrate = 1.5\n"
                "picks = [ { angle_deg = 0, colour = \"#c8b090\" } ]\ntolerance = { thickness_nm = 3 }\n"
                "[accuracy]\nmax_de00 = 1\n");
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const std::string said = "; thicknesses off by 3 nm move the colour by dE00 ";
    const ProgramResult plan = run_nacre({"plan", "s.toml"}, here);
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_NE(plan.out.find(said), std::string::npos) << plan.out;
    const ProgramResult baked = run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, here);
    ASSERT_EQ(baked.exit_code, 0) << baked.err;
    const auto manifest = nlohmann::json::parse(file_bytes(folder.path() / "out" / "m.json"));
    const auto& tolerance = manifest["picked"].at(0)["tolerance"];
    EXPECT_GT(tolerance["mean_de00"], 0.0);
    EXPECT_GT(tolerance["percentile_95_de00"], tolerance["mean_de00"]);
    EXPECT_EQ(run_nacre({"verify", "out/m.exr"}, here).exit_code, 0);
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
    const ProgramResult baked = run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, here);
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
    EXPECT_NE(baked.err.find("one pick gives the same colour at every angle"), std::string::npos) << baked.err;
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

TEST(FittedShape, StandsInThePlan) {
    const TemporaryFolder folder;
    folder.file("s.toml", straight + "[accuracy]\nmax_de00 = 1\n");
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult plan = run_nacre({"plan", "s.toml"}, here);
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_NE(plan.out.find("m: shape = 0.5 fits its picks best; straight lines would miss them by CIEDE2000 "
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
    const ProgramResult baked = run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, here);
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
              "nacre: green@0: \"green\" is not a colour; give \"#rrggbb\", \"#rgb\" or r,g,b\n");
    EXPECT_EQ(message_of({"#fff@91", "#fff@3"}),
              "nacre: #fff@91: the angle is out of range; allowed [0, 90] degrees\n");
    EXPECT_EQ(message_of({"#fff@x", "#fff@3"}),
              "nacre: #fff@x: \"x\" is not an angle; give COLOUR@ANGLE, as in \"#22cc66@0\"\n");
    EXPECT_NE(message_of({"0,1.2,0@0", "#2c2@3", "--space", "lin_rec709", "--strict"})
                  .find("nacre: [0, 1.2, 0] in lin_rec709 at 0 deg: is dimmed to "),
              std::string::npos);
    EXPECT_EQ(
        message_of({"#ff000080@0", "#2c2@3"}),
        "nacre: #ff000080@0: \"#ff000080\" has an alpha component, and a reflectance has none; give \"#ff0000\"\n");
    EXPECT_NE(message_of({"#2f2@0", "#2c2@0"}).find("different colours at one angle"), std::string::npos);
    EXPECT_NE(message_of({"#2f2@0", "#2c2@9", "--space", "lin_rec907"}).find("lin_rec907"), std::string::npos);
}

}  // namespace
}  // namespace nacre::test
