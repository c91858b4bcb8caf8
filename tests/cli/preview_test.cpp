// The first look: previews beside LUTs, and the pictures of a scene without swatches.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace nacre::test {
namespace {

// Of a fixed size, so that nothing has to be decided.
constexpr const char* two_luts =
    "[accuracy]\nsize = 16\n[colour]\ngamut = \"clip\"\n[material.m]\n"
    "picks = [ { angle_deg = 0,  peak_nm = 460, width_nm = 70, height = 1.0 },\n"
    "          { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n[lut.a]\n[lut.b]\n";
constexpr const char* with_swatch = "[swatch.look]\ndraw = \"strip\"\n";

ProgramResult nacre(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
    return run_nacre(arguments, {folder.path(), {}, {}, {}});
}

std::vector<std::string> files_in(const TemporaryFolder& folder) {
    std::vector<std::string> names;
    if (!std::filesystem::exists(folder.path() / "out")) return names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out"))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

using Names = std::vector<std::string>;

TEST(Preview, StandsBesideEveryLutOfABakeAndTheSummaryNamesIt) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(two_luts) + with_swatch);
    const ProgramResult result = nacre(folder, {"bake", "s.toml", "-o", "out", "--quiet"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(files_in(folder),
              (Names{"a.exr", "a.json", "a.preview.png", "b.exr", "b.json", "b.preview.png", "look.png"}));
    const auto picture = OIIO::ImageInput::open((folder.path() / "out/a.preview.png").string());
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->spec().width, 1200);
    const ProgramResult again = nacre(folder, {"bake", "s.toml", "-o", "out", "--only", "a"});
    EXPECT_NE(again.out.find("\na.preview.png  preview  sRGB / Standard  (unchanged)\n"), std::string::npos)
        << again.out;
}

TEST(Preview, IsDrawnOfEveryLutOrOfNoneIfTheUserSaysSo) {
    const TemporaryFolder folder;
    folder.file("s.toml", two_luts);
    EXPECT_EQ(nacre(folder, {"bake", "s.toml", "--no-preview", "--dry-run"}).out,
              "would write a.exr, a.json  16 x 1\nwould write b.exr, b.json  16 x 1\n");
    EXPECT_EQ(nacre(folder, {"bake", "s.toml", "--preview", "--dry-run"}).out,
              "would write a.exr, a.json  16 x 1\nwould write a.preview.png\n"
              "would write b.exr, b.json  16 x 1\nwould write b.preview.png\n");
    const ProgramResult both = nacre(folder, {"bake", "s.toml", "--preview", "--no-preview"});
    EXPECT_EQ(both.exit_code, 2);
    EXPECT_EQ(both.err, "nacre: --preview excludes --no-preview; see nacre bake --help\n");
}

TEST(Preview, IsAutomaticForUpTo32LutsInAll) {
    const TemporaryFolder folder;
    std::string scene = two_luts;
    for (int i = 2; i < 32; ++i) scene += "[lut.c" + std::to_string(i) + "]\n";
    const auto count = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"bake", "s.toml", "--dry-run"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const std::string out = nacre(folder, arguments).out;
        std::size_t found = 0;
        for (auto at = out.find(".preview.png"); at != std::string::npos; at = out.find(".preview.png", at + 1))
            ++found;
        return found;
    };
    folder.file("s.toml", scene);
    EXPECT_EQ(count({}), 32u);
    folder.file("s.toml", scene + "[lut.one_more]\n");
    EXPECT_EQ(count({}), 0u);
    EXPECT_EQ(count({"--shard", "1/2"}), 0u) << "a shard makes what the whole would";
    EXPECT_EQ(count({"--only", "a"}), 1u);
}

TEST(Preview, BelongsToTheShardOfItsLut) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(two_luts) + with_swatch);
    EXPECT_EQ(nacre(folder, {"bake", "s.toml", "--dry-run", "--shard", "1/2"}).out,
              "would write a.exr, a.json  16 x 1\nwould write a.preview.png\nwould write look.png\n");
    EXPECT_EQ(nacre(folder, {"bake", "s.toml", "--dry-run", "--shard", "2/2"}).out,
              "would write b.exr, b.json  16 x 1\nwould write b.preview.png\n");
    EXPECT_EQ(nacre(folder, {"bake", "s.toml", "--dry-run", "--only", "look"}).out, "would write look.png\n");
}

TEST(Preview, StandsInTheJsonOfABakeAndInThePlan) {
    const TemporaryFolder folder;
    folder.file("s.toml", two_luts);
    const ProgramResult baked = nacre(folder, {"bake", "s.toml", "-o", "out", "--only", "a", "--json"});
    const auto json = nlohmann::json::parse(baked.out);
    EXPECT_EQ(json["previews"],
              nlohmann::json::parse(R"([{"file": "a.preview.png", "draw": "preview", "display": "sRGB",
                                                         "view": "Standard", "unchanged": false, "lut": "a"}])"));
    const ProgramResult plan = nacre(folder, {"plan", "s.toml"});
    EXPECT_NE(plan.out.find("a.preview.png: preview\nb.preview.png: preview\n"), std::string::npos) << plan.out;
    const auto planned = nlohmann::json::parse(nacre(folder, {"plan", "s.toml", "--json"}).out);
    EXPECT_EQ(planned["luts"][0]["files"], (Names{"a.exr", "a.json", "a.preview.png"}));
}

TEST(Preview, HasANameThatNoOtherFileMayHave) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(two_luts) + "[swatch.\"b.preview\"]\ndraw = \"strip\"\n");
    const ProgramResult result = nacre(folder, {"bake", "s.toml", "-o", "out"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err,
              "nacre: s.toml:10:9: this would write b.preview.png, and so would s.toml:9:6; rename one of them\n");
    EXPECT_EQ(nacre(folder, {"bake", "s.toml", "--no-preview", "--dry-run"}).exit_code, 0);
}

TEST(Preview, OfAConfigWithoutADisplayIsAWarningUnlessItIsAskedFor) {
    const TemporaryFolder folder;
    folder.file("plain.ocio",
                "ocio_profile_version: 2\nroles:\n  aces_interchange: ap0\n  default: ap0\n  scene_linear: ap0\n"
                "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\ncolorspaces:\n  - !<ColorSpace>\n    "
                "name: ap0\n");
    std::string scene = two_luts;
    scene.replace(scene.find("gamut = \"clip\""), 14, "config = \"plain.ocio\"\nspace = \"ap0\"");
    folder.file("s.toml", scene);
    const std::string missing =
        "s.toml:9:6 a.preview.png: config \"plain.ocio\" has no displays; pictures need a config with a display and a "
        "view";
    const ProgramResult result = nacre(folder, {"bake", "s.toml", "-o", "out"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err.find("nacre: warning: " + missing + "; without it the LUTs get no previews\n"), 0u)
        << result.err;
    EXPECT_EQ(files_in(folder), (Names{"a.exr", "a.json", "b.exr", "b.json"}));
    const ProgramResult asked = nacre(folder, {"bake", "s.toml", "-o", "out", "--preview"});
    EXPECT_EQ(asked.exit_code, 2);
    EXPECT_EQ(asked.err, "nacre: " + missing + "\n");
}

TEST(Swatch, OfASceneWithoutSwatchesIsThePreviewThatABakeLeaves) {
    const TemporaryFolder folder;
    folder.file("s.toml", two_luts);
    const ProgramResult drawn = nacre(folder, {"swatch", "s.toml", "-o", "out"});
    EXPECT_EQ(drawn.out, "a.preview.png  preview  sRGB / Standard\nb.preview.png  preview  sRGB / Standard\n")
        << drawn.err;
    EXPECT_EQ(files_in(folder), (Names{"a.preview.png", "b.preview.png"}));
    const ProgramResult baked = nacre(folder, {"bake", "s.toml", "-o", "out", "--only", "b"});
    EXPECT_NE(baked.out.find("b.preview.png  preview  sRGB / Standard  (unchanged)\n"), std::string::npos) << baked.out;
}

TEST(Swatch, DrawsPreviewsBesideSwatchesOnlyIfTheyAreAskedFor) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(two_luts) + with_swatch);
    const auto files = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"swatch", "s.toml", "--dry-run"});
        return nacre(folder, more).out;
    };
    EXPECT_EQ(files({}), "would write look.png\n");
    EXPECT_EQ(files({"--preview"}), "would write a.preview.png\nwould write b.preview.png\nwould write look.png\n");
    EXPECT_EQ(files({"--only", "b"}), "would write b.preview.png\n");
    EXPECT_EQ(files({"--only", "look"}), "would write look.png\n");
    folder.file("s.toml", two_luts);
    const ProgramResult nothing = nacre(folder, {"swatch", "s.toml", "--no-preview"});
    EXPECT_EQ(nothing.exit_code, 2);
    EXPECT_EQ(nothing.err,
              "nacre: there is nothing to draw: no [swatch.NAME], and --no-preview leaves out the previews of LUTs\n");
}

TEST(Swatch, OfVariantsWithAContactSheetIsTheSheetAlone) {
    const TemporaryFolder folder;
    std::string scene = two_luts;
    scene.erase(scene.find("[lut.a]"));
    scene += "[variants]\nblue = {}\ngreen = { \"material.m.picks[0].peak_nm\" = 530 }\n";
    folder.file("s.toml", scene + "[swatch.looks]\ndraw = \"contact_sheet\"\n");
    EXPECT_EQ(nacre(folder, {"swatch", "s.toml", "--dry-run"}).out, "would write looks.png\n");
    EXPECT_EQ(nacre(folder, {"swatch", "s.toml", "--dry-run", "--only", "green"}).out,
              "would write green.preview.png\n");
    folder.file("s.toml", scene);
    EXPECT_EQ(nacre(folder, {"swatch", "s.toml", "--dry-run"}).out,
              "would write blue.preview.png\nwould write green.preview.png\n");
}

// A scene may also ask for one by name, with the keys of a strip.
TEST(Swatch, MayBeAPreviewOfALut) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(two_luts) +
                              "[swatch.p]\ndraw = \"preview\"\nlut = \"b\"\nexposure = 1\nx = \"cos_theta\"\n");
    const ProgramResult result = nacre(folder, {"swatch", "s.toml", "-o", "out"});
    EXPECT_EQ(result.out, "p.png  preview  sRGB / Standard\n") << result.err;
}

}  // namespace
}  // namespace nacre::test
