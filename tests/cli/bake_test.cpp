// What `nacre bake` leaves behind when all goes well, but for previews: preview_test.cpp.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <tuple>

#include "io/disk/hash.h"
#include "io/image/lut_file.h"
#include "nacre/lut/formats.h"
#include "support/program.h"

namespace nacre::test {
namespace {

constexpr const char* two_picks =
    "[material.morpho]\n"
    "picks = [ { angle_deg = 0,  peak_nm = 460, width_nm = 70, height = 1.0 },\n"
    "          { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n";

ProgramResult bake(const TemporaryFolder& folder, std::vector<std::string> more) {
    std::vector<std::string> arguments{"bake", "s.toml", "-o", "out", "--no-preview"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_nacre(arguments, {folder.path(), {}, {}, {}});
}

TEST(Bake, SmallestSceneGivesOneTextureAndItsManifest) {
    const TemporaryFolder folder;
    folder.file("s.toml", two_picks);
    const ProgramResult result = bake(folder, {});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const StoredLut lut = read_lut((folder.path() / "out/morpho.exr").string());
    EXPECT_EQ(lut.image.width(), 256);
    EXPECT_EQ(lut.image.height(), 1);
    EXPECT_EQ(lut.format, PixelFormat::single_float);  // half of any size misses the default bound
    EXPECT_EQ(lut.header.interop_id, "lin_rec709_scene");
    const auto manifest = nlohmann::json::parse(file_bytes(folder.path() / "out/morpho.json"));
    EXPECT_EQ(manifest["width"], 256);
    EXPECT_EQ(manifest["x"]["axis"], "sqrt_cos_theta");
    EXPECT_EQ(manifest["scene"], lut.header.value("scene"));
    EXPECT_EQ(result.out.find("morpho.exr  256 x 1 float  lin_rec709 (config nacre)  dE00 0.078 of 0.1"), 0u)
        << result.out;
}

TEST(Bake, BytesDoNotDependOnThreadsShardsOrTheFolder) {
    const TemporaryFolder one;
    const TemporaryFolder two;
    const std::string scene =
        std::string(two_picks) +
        "[lut.a]\n[lut.b]\ny = { parameter = \"width_nm\", from = 10, to = 200 }\nsize = [64, 16]\n"
        "[lut.c]\nx = \"theta_deg\"\nformat = \"float\"\n";
    one.file("s.toml", scene);
    two.file("s.toml", scene);
    ASSERT_EQ(bake(one, {"--threads", "1"}).exit_code, 0);
    ASSERT_EQ(bake(two, {"--threads", "4", "--shard", "1/2"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(two.path() / "out/b.exr"));
    ASSERT_EQ(bake(two, {"--threads", "4", "--shard", "2/2"}).exit_code, 0);
    for (const char* name : {"a.exr", "a.json", "b.exr", "b.json", "c.exr", "c.json"}) {
        const std::string bytes = file_bytes(one.path() / "out" / name);
        EXPECT_FALSE(bytes.empty()) << name;
        EXPECT_EQ(bytes, file_bytes(two.path() / "out" / name)) << name;
        EXPECT_EQ(bytes.find(one.path().string()), std::string::npos) << "no path may be in it";
    }
}

TEST(Bake, WhatIsUpToDateIsNotWrittenAgainUnlessForced) {
    const TemporaryFolder folder;
    folder.file("s.toml", two_picks);
    ASSERT_EQ(bake(folder, {}).exit_code, 0);
    const auto file = folder.path() / "out/morpho.exr";
    const auto before = std::filesystem::last_write_time(file);
    EXPECT_NE(bake(folder, {}).out.find("(unchanged)"), std::string::npos);
    EXPECT_EQ(std::filesystem::last_write_time(file), before);
    EXPECT_EQ(bake(folder, {"--force"}).out.find("(unchanged)"), std::string::npos);
    EXPECT_NE(std::filesystem::last_write_time(file), before);
    std::ofstream(file) << "damaged";
    ASSERT_EQ(bake(folder, {}).exit_code, 0);
    EXPECT_GT(file_bytes(file).size(), 1000u) << "a damaged file is replaced";
}

TEST(Bake, DryRunNamesTheFilesAndWritesNone) {
    const TemporaryFolder folder;
    folder.file("s.toml", two_picks);
    const ProgramResult result = bake(folder, {"--dry-run"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, "would write morpho.exr, morpho.json  256 x 1\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.toml"});
}

TEST(Bake, OnlyAndOutputsSelectWhatIsWritten) {
    const TemporaryFolder folder;
    folder.file("s.toml",
                std::string(two_picks) + "[lut.a]\noutputs = [\"exr\"]\n[lut.b]\noutputs = [\"json\", \"png\"]\n");
    ASSERT_EQ(bake(folder, {"--only", "a"}).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/a.exr"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/a.json"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/b.json"));
    ASSERT_EQ(bake(folder, {}).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/b.png"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/b.exr"));
}

TEST(Bake, PngOfALutHoldsItsTexelsInTheOrderOfTheExr) {
    const TemporaryFolder folder;
    folder.file("s.toml",
                std::string(two_picks) +
                    "[lut.a]\ny = { parameter = \"width_nm\", from = 10, to = 200 }\nsize = [32, 8]\noutputs = "
                    "[\"exr\", \"png\"]\n");
    const ProgramResult result = bake(folder, {});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(std::regex_search(result.out, std::regex(R"(  \d+ % of texels clamped in a\.png\n)"))) << result.out;
    const StoredLut lut = read_lut((folder.path() / "out/a.exr").string());
    const auto picture = OIIO::ImageInput::open((folder.path() / "out/a.png").string());
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->spec().format, OIIO::TypeDesc::UINT16);
    ASSERT_EQ(picture->spec().width, 32);
    ASSERT_EQ(picture->spec().height, 8);
    std::vector<float> shown(32 * 8 * 3);
    ASSERT_TRUE(picture->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, shown.data()));
    // Blue; of the sRGB curve its upper part.
    for (std::size_t i = 0; i < lut.image.size(); ++i) {
        const double blue = std::clamp(lut.image.data()[i].b, 0.0, 1.0);
        if (blue < 0.01) continue;
        EXPECT_NEAR(shown[3 * i + 2], 1.055 * std::pow(blue, 1.0 / 2.4) - 0.055, 1e-4) << i;
    }
    const ProgramResult json = bake(folder, {"--json"});
    EXPECT_GT(nlohmann::json::parse(json.out)["luts"][0]["png_clamped"], 0);
}

TEST(Bake, IncludesMergeAndJsonIsOneDocument) {
    const TemporaryFolder folder;
    folder.file("parts/morpho.toml", two_picks);
    folder.file("s.toml", "include = [\"parts/morpho.toml\"]\n[lut.wide]\nmaterial = \"morpho\"\n");
    const ProgramResult result = bake(folder, {"--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    ASSERT_EQ(json["luts"].size(), 1u);
    EXPECT_EQ(json["luts"][0]["file"], "wide.exr");
    EXPECT_TRUE(json["failures"].empty());
}

TEST(Bake, IncludedFilesMayIncludeOthersAndWhatIsIncludedStaysBesideItsFile) {
    const TemporaryFolder folder;
    folder.file("parts/deeper/lamp.csv", "300,1\n900,2\n");
    folder.file("parts/deeper/light.toml", "[light]\nilluminant = \"lamp.csv\"\n");
    folder.file("parts/morpho.toml", "include = \"deeper/light.toml\"\n" + std::string(two_picks));
    folder.file("s.toml", "include = [\"parts/morpho.toml\"]\n");
    const ProgramResult result = bake(folder, {});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(read_lut((folder.path() / "out/morpho.exr").string()).header.value("illuminant"), "lamp.csv");
}

TEST(Bake, LampThatIsNegativeBeyondTheRangeBakesAndVerifies) {
    const TemporaryFolder folder;
    folder.file(
        "lamp.csv",
        "\"nm\",\"power\"\n\"300\",-0.01\n\"340\",-0.002\n\"350\",12345678901234567890\n\"840\",1e19\n\"900\",-1\n");
    folder.file("s.toml", std::string(two_picks) + "[light]\nilluminant = \"lamp.csv\"\n");
    const ProgramResult result = bake(folder, {});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(run_nacre({"verify", (folder.path() / "out/morpho.exr").string()}).exit_code, 0);
}

TEST(Bake, PictureOfALutNeedsADisplayAndSaysSoBeforeAnythingIsWritten) {
    const TemporaryFolder folder;
    folder.file("plain.ocio",
                "ocio_profile_version: 2\nroles:\n  aces_interchange: ap0\n  default: ap0\n  scene_linear: ap0\n"
                "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\ncolorspaces:\n  - !<ColorSpace>\n    "
                "name: ap0\n");
    folder.file("s.toml",
                std::string(two_picks) +
                    "[colour]\nconfig = \"plain.ocio\"\nspace = \"ap0\"\n[lut.a]\n[lut.b]\noutputs = [\"png\"]\n");
    const ProgramResult result = bake(folder, {});
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

TEST(Bake, LutsOfEncodedAndDisplayReferredSpacesVerifyToo) {
    const TemporaryFolder folder;
    for (const std::string space : {"srgb_rec709", "srgb_rec709_display", "lin_ciexyzd65_display", "lin_ap0"}) {
        folder.file("s.toml", std::string(two_picks) + "[colour]\nspace = \"" + space + "\"\n");
        ASSERT_EQ(bake(folder, {}).exit_code, 0) << space;
        const ProgramResult result = run_nacre({"verify", (folder.path() / "out/morpho.exr").string()});
        EXPECT_EQ(result.exit_code, 0) << space << result.out;
    }
}

TEST(Bake, DefaultSpaceIsFoundByTheNameThatTheConfigHasForIt) {
    const TemporaryFolder folder;
    folder.file("s.toml", two_picks);
    const std::string configs = std::string(NACRE_SOURCE_DIR) + "/tests/io/ocio/";
    const ProgramResult ours = bake(folder, {});
    const std::string lut = (folder.path() / "out/morpho.exr").string();
    const Image<Rgb> expected = read_lut(lut).image;
    for (const std::string config : {"cif-core-renderer-1.1.0", "aces-cg-1.0.0", "aces-studio-1.0.0"}) {
        const ProgramResult result = bake(folder, {"--ocio", configs + config + "/config.ocio"});
        ASSERT_EQ(result.exit_code, 0) << config << result.err;
        const StoredLut stored = read_lut(lut);
        EXPECT_EQ(stored.header.interop_id, "lin_rec709_scene") << config;
        // Another config's matrix has fewer digits: one unit of a half at 1 is 9.8e-4.
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_NEAR(stored.image.data()[i].b, expected.data()[i].b, 1e-3);
    }
}

TEST(Bake, GamutRulesLeaveNoNegativeComponentSayWhatTheyDidAndVerify) {
    const TemporaryFolder folder;
    for (const std::string rule : {"keep", "clip", "compress"}) {
        folder.file("s.toml", std::string(two_picks) + "[colour]\ngamut = \"" + rule + "\"\n");
        const ProgramResult result = bake(folder, {"--json"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const std::string path = (folder.path() / "out/morpho.exr").string();
        const StoredLut stored = read_lut(path);
        double smallest = 0.0;
        for (const Rgb& texel : stored.image) smallest = std::min({smallest, texel.r, texel.g, texel.b});

        const auto said = nlohmann::json::parse(result.out)["luts"][0]["gamut"];
        EXPECT_EQ(said, nlohmann::json::parse(file_bytes(folder.path() / "out/morpho.json"))["gamut"]);
        EXPECT_EQ(said["rule"], rule);
        EXPECT_GT(said["texels_outside"], 10);
        EXPECT_LT(said["most_negative"], -0.01) << "blue of a Morpho lies outside Rec.709";
        EXPECT_EQ(stored.header.value("gamut"), rule);
        EXPECT_EQ(stored.header.value("gamutOutside"), said["texels_outside"].dump());
        if (rule == "keep") {
            EXPECT_NEAR(smallest, said["most_negative"].get<double>(), 1e-4);
            EXPECT_FALSE(said.contains("left"));
            EXPECT_EQ(stored.header.value("gamutMostNegative"), "");
            EXPECT_NE(result.err.find("negative components"), std::string::npos);
        } else {
            EXPECT_EQ(smallest, 0.0) << rule;
            EXPECT_EQ(said["left"], (nlohmann::json{{"texels_outside", 0}, {"most_negative", 0.0}})) << rule;
            EXPECT_NEAR(std::stod(stored.header.value("gamutMostNegative")), said["most_negative"].get<double>(), 1e-3);
            EXPECT_EQ(result.err.find("negative components"), std::string::npos);
        }
        const ProgramResult verified = run_nacre({"verify", path});
        EXPECT_EQ(verified.exit_code, 0) << rule << verified.out << verified.err;
    }
}

TEST(Bake, SummarySaysHowFarOutsideAndWhatWasDone) {
    const TemporaryFolder folder;
    for (const auto& [rule, verb, done] :
         {std::tuple{"keep", "are", R"(\n|  )"}, {"clip", "were", ", clipped"}, {"compress", "were", ", compressed"}}) {
        folder.file("s.toml",
                    std::string("[accuracy]\nsize = 64\n") + two_picks + "[colour]\ngamut = \"" + rule + "\"\n");
        const ProgramResult result = bake(folder, {});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_TRUE(std::regex_search(result.out, std::regex(std::string(R"(  [\d.]+ % of texels )") + verb +
                                                             R"( negative \(minimum -0\.0\d+\)(?=)" + done + ")")))
            << result.out;
    }
}

TEST(Bake, WarningOfNegativeComponentsNamesTheLutHowMuchOfItAndByHowMuch) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(two_picks) +
                              "[lut.morpho]\nsize = 64\n[lut.wide]\nsize = 64\n[lut.fitted]\nsize = 64\n"
                              "gamut = \"compress\"\n");
    const ProgramResult result = bake(folder, {});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string share =
        R"(: \d+ % of texels have negative components, because the colour lies outside lin_rec709; )"
        R"(setting them to 0 would change it by up to dE00 \d+\n)";
    EXPECT_TRUE(std::regex_match(
        result.err,
        std::regex("nacre: warning: morpho" + share + R"(nacre: warning: wide \(material morpho\))" + share +
                   R"(nacre: warning: gamut = "compress" or "clip" in \[colour\] or \[lut.NAME\] removes negative )"
                   R"(components; a wider space keeps the colours\n)")))
        << result.err;
}

TEST(Bake, NegativeComponentsThatMatterLessThanTheBoundAreNoWarning) {
    const TemporaryFolder folder;
    // A green whose red is -0.020. Clipping changes it by CIEDE2000 0.85.
    const std::string green =
        "[material.green]\npicks = [ { angle_deg = 0, peak_nm = 530, width_nm = 180, height = 0.6 } ]\n";
    for (const auto& [bound, warns] : {std::pair{"0.7", true}, {"1", false}}) {
        folder.file("s.toml", green + "[lut.green]\nmax_de00 = " + bound + "\n");
        const ProgramResult result = bake(folder, {});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_NE(result.out.find("% of texels are negative"), std::string::npos) << result.out;
        EXPECT_EQ(result.err.find("negative components") != std::string::npos, warns) << bound << result.err;
    }
}

TEST(Bake, LutsMayHaveTheirOwnBoundGamutAndSpace) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string("[colour]\nspace = \"lin_p3d65\"\ngamut = \"clip\"\n[accuracy]\nmax_de00 = 1\n") +
                              two_picks +
                              "[lut.scene]\n[lut.own]\nspace = \"lin_ap1\"\ngamut = \"keep\"\nmax_de00 = 0.2\n");
    const ProgramResult result = bake(folder, {});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const auto& [name, space, gamut, bound] :
         {std::tuple{"scene", "lin_p3d65", "clip", "1"}, {"own", "lin_ap1", "keep", "0.2"}}) {
        const std::string path = (folder.path() / "out" / name).string();
        const StoredLut stored = read_lut(path + ".exr");
        EXPECT_EQ(stored.header.value("colourSpace"), space);
        EXPECT_EQ(stored.header.value("gamut"), gamut);
        EXPECT_EQ(stored.header.value("accuracyAsked"), bound);
        const auto manifest = nlohmann::json::parse(file_bytes(path + ".json"));
        EXPECT_EQ(manifest["colour_space"], space);
        EXPECT_EQ(manifest["gamut"]["rule"], gamut);
        EXPECT_EQ(manifest["accuracy"]["max_de00"].get<double>(), std::stod(bound));
        EXPECT_LE(manifest["accuracy"]["reached"].get<double>(), std::stod(bound));
        EXPECT_EQ(run_nacre({"verify", path + ".exr"}).exit_code, 0) << name;
    }
    // The command line wins over both.
    ASSERT_EQ(bake(folder, {"--accuracy", "3"}).exit_code, 0);
    EXPECT_EQ(read_lut((folder.path() / "out/own.exr").string()).header.value("accuracyAsked"), "3");
}

TEST(Bake, SetChangesTheSceneAndTheFilesSayWhatWasChanged) {
    const TemporaryFolder folder;
    folder.file("s.toml", two_picks);
    const ProgramResult result = bake(folder, {"--set", "material.morpho.picks[0].peak_nm=500", "--set",
                                               "accuracy.max_de00=0.5", "--set", "colour.gamut=clip"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string path = (folder.path() / "out/morpho.exr").string();
    const StoredLut stored = read_lut(path);
    EXPECT_EQ(stored.header.value("edits"),
              "material.morpho.picks[0].peak_nm = 500, accuracy.max_de00 = 0.5, colour.gamut = \"clip\"");
    EXPECT_EQ(stored.header.value("gamut"), "clip");
    EXPECT_NE(stored.header.value("scene").find("peak_nm = 500,"), std::string::npos) << stored.header.value("scene");
    const auto manifest = nlohmann::json::parse(file_bytes(folder.path() / "out/morpho.json"));
    EXPECT_EQ(manifest["edits"], (nlohmann::json{"material.morpho.picks[0].peak_nm = 500", "accuracy.max_de00 = 0.5",
                                                 "colour.gamut = \"clip\""}));
    EXPECT_EQ(run_nacre({"verify", path}).exit_code, 0);
    // The same as a scene in which the numbers stand, but for that attribute.
    std::string edited = two_picks;
    edited.replace(edited.find("460"), 3, "500");
    folder.file("s.toml", edited + "[accuracy]\nmax_de00 = 0.5\n[colour]\ngamut = \"clip\"\n");
    ASSERT_EQ(bake(folder, {}).exit_code, 0);
    const StoredLut written = read_lut(path);
    EXPECT_EQ(written.header.value("scene"), stored.header.value("scene"));
    EXPECT_EQ(written.header.value("edits"), "");
    EXPECT_TRUE(std::equal(written.image.begin(), written.image.end(), stored.image.begin()));
}

TEST(Bake, SetIsAnOptionOfBakePlanAndSwatchAndItsMistakesAreWrongInput) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(two_picks) + "[swatch.strip]\ndraw = \"strip\"\n");
    for (const std::string command : {"bake", "plan", "swatch"}) {
        const auto run = [&](const std::string& edit) {
            return run_nacre({command, "s.toml", "--set", edit}, {folder.path(), {}, {}, {}});
        };
        for (const auto& [edit, message] :
             {std::pair{"foo", "is not KEY=VALUE; write for example --set material.hero.picks[0].colour=#aa2244"},
              {"material.blue.shape=1", "s.toml has no material.blue; known in material: morpho"},
              {"material.morpho.picks=[1", "not TOML: Error while parsing array: encountered end-of-file"}}) {
            const ProgramResult result = run(edit);
            EXPECT_EQ(result.exit_code, 2) << command << edit;
            EXPECT_EQ(result.err, "nacre: --set \"" + std::string(edit) + "\": " + message + "\n");
        }
        EXPECT_EQ(run("accuracy.max_de0=1").err,
                  "nacre: --set \"accuracy.max_de0=1\" [accuracy]: unknown key \"max_de0\"; did you mean max_de00?\n");
        EXPECT_EQ(run("material.morpho.shape=0.5").exit_code, 0) << command;
    }
}

TEST(Bake, VariantsOfACsvAreLutsThatVerifyAndAContactSheet) {
    const TemporaryFolder folder;
    folder.file("looks.csv", "name,material.morpho.picks[0].peak_nm,accuracy.max_de00\nblue,,\ngreen,530,0.5\n");
    folder.file("s.toml",
                "variants = \"looks.csv\"\n" + std::string(two_picks) + "[swatch.looks]\ndraw = \"contact_sheet\"\n");
    const ProgramResult result = bake(folder, {});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const char* file : {"blue.exr", "blue.json", "green.exr", "green.json", "looks.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / file)) << file;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/morpho.exr")) << "the scene itself is no variant";
    for (const std::string name : {"blue", "green"})
        EXPECT_EQ(run_nacre({"verify", (folder.path() / ("out/" + name + ".exr")).string()}).exit_code, 0) << name;
    const LutHeader header = read_lut((folder.path() / "out/green.exr").string()).header;
    EXPECT_EQ(header.value("edits"), "material.morpho.picks[0].peak_nm = 530, accuracy.max_de00 = 0.5");
    EXPECT_EQ(header.value("accuracyAsked"), "0.5");
    EXPECT_EQ(read_lut((folder.path() / "out/blue.exr").string()).header.value("edits"), "");
    EXPECT_EQ(bake(folder, {"--only", "gren"}).err,
              "nacre: --only \"gren\": the scenes have no LUT or swatch of that name; known: green\n");
}

TEST(Bake, CompressIntoEveryLinearSpaceVerifies) {
    const TemporaryFolder folder;
    for (const std::string space : {"lin_ap1", "lin_ap0", "lin_rec2020", "lin_p3d65"}) {
        folder.file("s.toml", std::string(two_picks) + "[colour]\nspace = \"" + space + "\"\ngamut = \"compress\"\n");
        ASSERT_EQ(bake(folder, {}).exit_code, 0) << space;
        const std::string path = (folder.path() / "out/morpho.exr").string();
        for (const Rgb& texel : read_lut(path).image) EXPECT_GE(std::min({texel.r, texel.g, texel.b}), 0.0) << space;
        const ProgramResult result = run_nacre({"verify", path});
        EXPECT_EQ(result.exit_code, 0) << space << result.out;
    }
}

TEST(Bake, VerifyRefusesAForgedHeaderThatCompressesIntoACurve) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(two_picks) + "[colour]\nspace = \"srgb_rec709\"\ngamut = \"clip\"\n");
    ASSERT_EQ(bake(folder, {}).exit_code, 0);
    const std::string path = (folder.path() / "out/morpho.exr").string();
    StoredLut lut = read_lut(path);
    std::string scene = lut.header.value("scene");
    scene.replace(scene.find("\"clip\""), 6, "\"compress\"");
    for (auto& [name, value] : lut.header.nacre) {
        if (name == "scene") value = scene;
        if (name == "sceneHash") value = hash_text(scene);
    }
    folder.file("out/morpho.exr", encode_lut(lut.image, lut.format, lut.header));
    const ProgramResult result = run_nacre({"verify", path});
    EXPECT_EQ(result.exit_code, 4) << result.out << result.err;
    EXPECT_NE(result.out.find("gamut = \"compress\" needs a linear space, and srgb_rec709 is not linear"),
              std::string::npos)
        << result.out;
}

// The line of text below says so, where there is something to say.
TEST(Bake, PicturesOfALutShowWhereItLeavesItsSpace) {
    const TemporaryFolder folder;
    // Not by OIIO::ImageBuf, whose cache may remember the picture that was there before.
    const auto height = [&](const char* file) {
        const auto picture = OIIO::ImageInput::open((folder.path() / "out" / file).string());
        return picture ? picture->spec().height : 0;
    };
    const std::string pictures =
        "[lut.morpho]\nsize = 64\n[swatch.strip]\ndraw = \"strip\"\n[swatch.ball]\ndraw = \"sphere\"\n";
    for (const auto& [space, expected] : {std::pair{"lin_rec709", 542}, {"lin_ciexyzd65_display", 512}}) {
        folder.file("s.toml", std::string("[colour]\nspace = \"") + space + "\"\n" + two_picks + pictures);
        ASSERT_EQ(bake(folder, {}).exit_code, 0) << space;
        EXPECT_EQ(height("strip.png"), expected) << space;
        EXPECT_EQ(height("ball.png"), 900) << space;
    }
}

TEST(Bake, PictureOfALutShowsWhereItLeavesItsOwnSpace) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(two_picks) +
                              "[lut.narrow]\nsize = 64\n[lut.wide]\nsize = 64\nspace = \"lin_ciexyzd65_display\"\n"
                              "[swatch.of_narrow]\ndraw = \"strip\"\nlut = \"narrow\"\n"
                              "[swatch.of_wide]\ndraw = \"strip\"\nlut = \"wide\"\n");
    ASSERT_EQ(bake(folder, {}).exit_code, 0);
    const auto height = [&](const char* file) {
        return OIIO::ImageInput::open((folder.path() / "out" / file).string())->spec().height;
    };
    EXPECT_GT(height("of_narrow.png"), height("of_wide.png")) << "by the line that says how much is outside";
}

TEST(Bake, LutThatItsFormatCannotHoldFailsAloneAndTheOthersAreWritten) {
    const TemporaryFolder folder;
    // A space a million times as bright as ACES2065-1: beyond what half holds.
    folder.file("bright.ocio",
                "ocio_profile_version: 2\nroles:\n  aces_interchange: ap0\n  default: ap0\n  scene_linear: ap0\n"
                "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n"
                "displays:\n  none:\n    - !<View> {name: none, colorspace: ap0}\n"
                "colorspaces:\n  - !<ColorSpace>\n    name: ap0\n  - !<ColorSpace>\n    name: bright\n"
                "    from_scene_reference: !<MatrixTransform> {matrix: [1e6, 0, 0, 0, 0, 1e6, 0, 0, 0, 0, 1e6, 0, 0, "
                "0, 0, 1]}\n");
    folder.file(
        "s.toml",
        std::string(two_picks) +
            "[colour]\nconfig = \"bright.ocio\"\nspace = \"bright\"\n[lut.small]\nformat = \"half\"\n[lut.large]\n");
    const ProgramResult result = bake(folder, {});
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find("nacre: s.toml:7:6 small: texel ("), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("half holds up to 65504"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/small.exr"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/large.exr"));
}

TEST(Bake, VerifyAcceptsWhatBakeWroteAndNothingElse) {
    const TemporaryFolder folder;
    folder.file("lamp.csv", "wavelength_nm,power\n300,1\n500,3.7\n900,0.5\n");
    folder.file("s.toml", std::string(two_picks) +
                              "[light]\nilluminant = \"lamp.csv\"\nadapt = \"cat16\"\n[colour]\nspace = "
                              "\"acescct_ap1\"\ngamut = \"clip\"\n"
                              "[accuracy]\nwavelengths = 95\n"
                              "[lut.a]\nx = \"cos_theta\"\ny = { parameter = \"picks[1].peak_nm\", from = 400.5, to = "
                              "600 }\nsize = [32, 8]\nformat = \"float\"\n");
    ASSERT_EQ(bake(folder, {}).exit_code, 0);
    const auto file = folder.path() / "out/a.exr";
    ProgramResult result = run_nacre({"verify", file.string()});
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    EXPECT_NE(result.out.find("verified: header complete, 256 texels equal a re-bake"), std::string::npos)
        << result.out;

    // One bit of one texel.
    const std::string intact = file_bytes(file);
    std::string bytes = intact;
    bytes[bytes.size() - 100] = static_cast<char>(bytes[bytes.size() - 100] ^ 1);
    std::ofstream(file, std::ios::binary) << bytes;
    result = run_nacre({"verify", file.string()});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_NE(result.out.find("NOT verified: 1 components differ from a re-bake"), std::string::npos) << result.out;

    // Another observer, and another space, in attributes that say what the scene says too.
    for (const auto& [said, forged, attribute] : {std::tuple{"cie1931_2deg", "cie1964_2deg", "nacre:observer"},
                                                  {"acescct_ap1", "acescct_ap0", "nacre:colourSpace"}}) {
        bytes = intact;
        bytes.replace(bytes.find(said), std::string(said).size(), forged);
        std::ofstream(file, std::ios::binary) << bytes;
        result = run_nacre({"verify", file.string()});
        EXPECT_EQ(result.exit_code, 4);
        EXPECT_NE(result.out.find(std::string("the header contradicts its scene in ") + attribute), std::string::npos)
            << result.out;
    }

    // A file that cannot be read hides no other.
    std::ofstream(file, std::ios::binary) << "no image";
    const std::string other = folder.file("other.exr", intact);
    result = run_nacre({"verify", file.string(), other});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_NE(result.out.find("other.exr: verified"), std::string::npos) << result.out;
}

// Pictures hold letters, and another version of FreeType draws their edges a little differently: 1 % of the pixels may.
void expect_alike(const std::filesystem::path& shipped, const std::filesystem::path& made) {
    OIIO::ImageBuf a(shipped.string());
    OIIO::ImageBuf b(made.string());
    const float two_levels = 2.5F / 255.0F;
    ASSERT_TRUE(a.read() && b.read() && a.spec().width == b.spec().width && a.spec().height == b.spec().height)
        << shipped;
    const auto difference = OIIO::ImageBufAlgo::compare(a, b, two_levels, two_levels);
    EXPECT_LE(difference.nfail, 0.01 * a.spec().width * a.spec().height)
        << shipped << ": run ./run bake configs/scenes/*.toml -o luts --no-preview";
}

TEST(ShippedLuts, AreWhatTheirScenesMake) {
    const TemporaryFolder folder;
    const std::string root = NACRE_SOURCE_DIR;
    std::vector<std::string> arguments{"bake", "--no-preview", "-o", folder.path().string()};
    for (const auto& file : std::filesystem::directory_iterator(root + "/configs/scenes")) {
        if (file.path().extension() == ".toml") arguments.push_back(file.path().string());
    }
    const ProgramResult result = run_nacre(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    std::size_t compared = 0;
    for (const std::string& name : folder.names()) {
        const auto shipped = std::filesystem::path(root) / "luts" / name;
        ASSERT_TRUE(std::filesystem::exists(shipped)) << "luts/ lacks " << name;
        if (shipped.extension() == ".png") {
            expect_alike(shipped, folder.path() / name);
        } else {
            EXPECT_EQ(file_bytes(shipped), file_bytes(folder.path() / name))
                << name << ": run ./run bake configs/scenes/*.toml -o luts --no-preview";
        }
        ++compared;
    }
    EXPECT_EQ(compared, 179u);
}

// Programs that others wrote read the header: if one is missing, install openexr and openimageio-tools.
TEST(Bake, ToolsOfOthersReadTheTextureAndShowItsMetadata) {
    const TemporaryFolder folder;
    folder.file("s.toml", two_picks);
    ASSERT_EQ(bake(folder, {}).exit_code, 0);
    const std::string lut = (folder.path() / "out/morpho.exr").string();
    const std::string shown = (folder.path() / "shown").string();
    for (const std::string tool : {"exrheader", "exrinfo -v", "oiiotool --info -v"}) {
        ASSERT_EQ(std::system((tool + " " + lut + " > " + shown + " 2>&1").c_str()), 0)
            << tool << ": " << file_bytes(shown);
        const std::string text = file_bytes(shown);
        for (const std::string word : {"nacre:scene", "nacre:axisX", "colorInteropID", "chromaticities"}) {
            EXPECT_NE(text.find(word), std::string::npos) << tool << " does not show " << word << "\n" << text;
        }
    }
}

TEST(Snippet, ShippedOnesAreWhatTheProgramPrints) {
    for (const std::string language : {"glsl", "hlsl"}) {
        EXPECT_EQ(run_nacre({"snippet", language}).out,
                  file_bytes(std::string(NACRE_SOURCE_DIR) + "/luts/nacre." + language));
    }
}

}  // namespace
}  // namespace nacre::test
