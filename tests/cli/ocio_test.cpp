// OpenColorIO as users have it: configs from elsewhere, $OCIO, and the options that win over the scene.
#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/image/lut_file.h"
#include "support/program.h"

namespace nacre::test {
namespace {

const std::string configs = std::string(NACRE_SOURCE_DIR) + "/tests/io/ocio/";
const std::string aces = configs + "aces-cg-1.0.0/config.ocio";
const std::string plain = configs + "plain_linear.ocio";

// Of a fixed size, so that nothing has to be decided.
const std::string scene =
    "[accuracy]\nsize = 16\n[material.m]\n"
    "picks = [ { angle_deg = 0,  peak_nm = 460, width_nm = 70, height = 1.0 },\n"
    "          { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n";

struct Asked {
    std::string command = "bake";
    std::vector<std::string> options;
    std::string ocio;  ///< $OCIO
};

ProgramResult nacre(const TemporaryFolder& folder, const Asked& asked) {
    std::vector<std::string> arguments{asked.command, "s.toml"};
    if (asked.command != "plan") arguments.insert(arguments.end(), {"-o", "out"});
    arguments.insert(arguments.end(), asked.options.begin(), asked.options.end());
    ProgramOptions options{folder.path(), {}, {}, {}};
    if (!asked.ocio.empty()) options.environment = {{"OCIO", asked.ocio}};
    return run_nacre(arguments, options);
}

std::string error_of(const std::string& text, const Asked& asked) {
    const TemporaryFolder folder;
    folder.file("s.toml", text);
    const ProgramResult result = nacre(folder, asked);
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
    return result.err;
}

StoredLut baked(const TemporaryFolder& folder, const std::string& text, const Asked& asked) {
    folder.file("s.toml", text);
    const ProgramResult result = nacre(folder, asked);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_lut((folder.path() / "out/m.exr").string());
}

// ---- the default space

TEST(DefaultSpace, ThatAConfigLacksIsSaidAndSceneLinearIsOfferedByName) {
    EXPECT_EQ(error_of(scene, {"bake", {"--ocio", plain}, ""}),
              "nacre: s.toml: config \"plain_linear.ocio (plain)\" has no lin_rec709, which is nacre's default space; "
              "name one of its spaces with [colour] space or --space, for example \"Linear\", its role scene_linear\n");
    const std::string in_scene = scene + "[colour]\nconfig = \"" + plain + "\"\n";
    EXPECT_NE(error_of(in_scene, {}).find("s.toml:6:1 [colour]: config \"plain_linear.ocio (plain)\" has no "),
              std::string::npos)
        << error_of(in_scene, {});
    // A config without the role: all that it has.
    const TemporaryFolder folder;
    std::string text = file_bytes(plain);
    text.replace(text.find(", scene_linear: Linear"), 22, "");
    EXPECT_EQ(
        error_of(scene, {"bake", {"--ocio", folder.file("no_role.ocio", text)}, ""}),
        "nacre: s.toml: config \"no_role.ocio (plain)\" has no lin_rec709, which is nacre's default space; name one "
        "of its spaces with [colour] space or --space; known: Linear, Linear ACES, film_rec709, lin_rec790, screen\n");
}

TEST(DefaultSpace, IsNotLookedForIfEveryLutNamesItsOwn) {
    const TemporaryFolder folder;
    const std::string own = scene + "[lut.m]\nspace = \"Linear\"\n";
    EXPECT_EQ(baked(folder, own, {"bake", {"--ocio", plain}, ""}).header.value("colourSpace"), "Linear");
    EXPECT_NE(error_of(own + "[lut.n]\n", {"bake", {"--ocio", plain}, ""}).find("has no lin_rec709"),
              std::string::npos);
}

TEST(DefaultSpace, OfAConfigInTheEnvironmentIsItsSceneLinear) {
    const TemporaryFolder folder;
    const StoredLut acescg = baked(folder, scene, {"bake", {}, aces});
    EXPECT_EQ(acescg.header.value("colourSpace"), "ACEScg");
    EXPECT_EQ(acescg.header.interop_id, "lin_ap1_scene");
    EXPECT_EQ(baked(folder, scene, {"bake", {}, plain}).header.value("colourSpace"), "Linear");
    // The scene says otherwise: its own space, its own config, its LUT's space.
    EXPECT_EQ(baked(folder, scene + "[colour]\nspace = \"lin_rec709\"\n", {"bake", {}, aces}).header.interop_id,
              "lin_rec709_scene");
    EXPECT_EQ(baked(folder, scene + "[lut.m]\nspace = \"lin_ap0\"\n", {"bake", {}, aces}).header.interop_id,
              "lin_ap0_scene");
    EXPECT_EQ(baked(folder, scene + "[colour]\nconfig = \"" + aces + "\"\n", {"bake", {}, plain}).header.interop_id,
              "lin_rec709_scene");
    // So does the command line.
    EXPECT_EQ(baked(folder, scene, {"bake", {"--ocio", aces}, plain}).header.interop_id, "lin_rec709_scene");
    EXPECT_EQ(baked(folder, scene, {"bake", {"--space", "lin_p3d65"}, aces}).header.interop_id, "lin_p3d65_scene");
}

TEST(DefaultSpace, OfTheEnvironmentGivesTheNumbersOfThatSpaceAndVerifies) {
    const TemporaryFolder folder;
    const StoredLut piped = baked(folder, scene, {"bake", {}, aces});
    EXPECT_EQ(run_nacre({"verify", (folder.path() / "out/m.exr").string()}).exit_code, 0);
    const StoredLut named = baked(folder, scene, {"bake", {"--space", "lin_ap1"}, ""});
    ASSERT_EQ(piped.image.size(), named.image.size());
    // Another config's matrix has fewer digits: one unit of a half at 1 is 9.8e-4.
    for (std::size_t i = 0; i < piped.image.size(); ++i)
        EXPECT_NEAR(piped.image.data()[i].b, named.image.data()[i].b, 1e-3);
}

TEST(DefaultSpace, OfAnEnvironmentWithoutSceneLinearIsLinearRec709) {
    const TemporaryFolder folder;
    std::string text = file_bytes(aces);
    text.replace(text.find("  scene_linear: ACEScg\n"), 23, "");
    EXPECT_EQ(baked(folder, scene, {"bake", {}, folder.file("no_role.ocio", text)}).header.interop_id,
              "lin_rec709_scene");
}

TEST(Interchange, AConfigWithoutRolesIsBakedWithTheKey) {
    const TemporaryFolder folder;
    const std::string old = "[colour]\nconfig = \"" + configs + "aces_names_no_role.ocio\"\nspace = \"scene_linear\"\n";
    EXPECT_NE(error_of(scene + old, {}).find("or give [colour] aces_interchange = \"ACES - ACES2065-1\"\n"),
              std::string::npos);
    const StoredLut lut = baked(folder, scene + old + "aces_interchange = \"ACES - ACES2065-1\"\n", {});
    EXPECT_EQ(lut.header.interop_id, "lin_ap1_scene");
    EXPECT_EQ(lut.header.value("colourSpace"), "ACES - ACEScg");
}

// ---- which config it was

TEST(ConfigInForce, IsNamedInEveryLineOfALutAndInItsManifest) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    const ProgramResult result = nacre(folder, {"bake", {}, aces});
    EXPECT_EQ(result.out.substr(0, result.out.find("  dE00")),
              "m.exr  16 x 1 half  ACEScg (config cg-config-v1.0.0_aces-v1.3_ocio-v2.1)");
    EXPECT_EQ(nlohmann::json::parse(file_bytes(folder.path() / "out/m.json"))["colour_config"],
              "config.ocio (cg-config-v1.0.0_aces-v1.3_ocio-v2.1)");
    const std::string plan = nacre(folder, {"plan", {"--space", "lin_p3d65"}, ""}).out;
    EXPECT_NE(plan.find("bake time  space\n"), std::string::npos) << plan;
    EXPECT_NE(plan.find("  lin_p3d65 (config nacre)\n"), std::string::npos) << plan;
    const auto json = nlohmann::json::parse(nacre(folder, {"plan", {"--json"}, plain}).out)["luts"][0];
    EXPECT_EQ(json["colour_space"], "Linear");
    EXPECT_EQ(json["colour_config"], "plain_linear.ocio (plain)");
}

TEST(ConfigInForce, OfAnotherVersionOfOpenColorIoIsRefusedByName) {
    const std::string inside = "ocio://cg-config-v9.0.0_aces-v2.0_ocio-v9.0";
    const std::string refused =
        " OCIO config \"" + inside + "\" is one that OpenColorIO contains from version 9.0 on; ";
    EXPECT_EQ(error_of(scene, {"bake", {"--ocio", inside}, ""}).find("nacre: --ocio:" + refused), 0U);
    EXPECT_EQ(error_of(scene, {"bake", {}, inside}).find("nacre: $OCIO:" + refused), 0U);
    // Not a file beside the scene.
    EXPECT_EQ(
        error_of(scene + "[colour]\nconfig = \"" + inside + "\"\n", {}).find("nacre: s.toml:7:10 [colour]:" + refused),
        0U);
}

// ---- --space, --display and --view

TEST(ColourOptions, SpaceWinsOverTheSceneAndOverEachLut) {
    const TemporaryFolder folder;
    const std::string three = scene + "[colour]\nspace = \"lin_ap0\"\n[lut.m]\nspace = \"lin_ap1\"\n[lut.n]\n";
    EXPECT_EQ(baked(folder, three, {"bake", {"--space", "lin_p3d65"}, ""}).header.interop_id, "lin_p3d65_scene");
    const StoredLut other = read_lut((folder.path() / "out/n.exr").string());
    EXPECT_EQ(other.header.interop_id, "lin_p3d65_scene");
    EXPECT_NE(other.header.value("scene").find("space = \"lin_p3d65\""), std::string::npos);
    EXPECT_EQ(run_nacre({"verify", (folder.path() / "out/n.exr").string()}).exit_code, 0);
    for (const char* command : {"bake", "plan", "swatch"}) {
        EXPECT_EQ(error_of(scene, {command, {"--space", "lin_rec710"}, ""}),
                  "nacre: --space: unknown colour space \"lin_rec710\" in config \"nacre (built in)\"; nearest: "
                  "lin_rec709, lin_rec2020\n");
    }
    EXPECT_EQ(error_of(scene + "[colour]\ngamut = \"compress\"\n", {"bake", {"--space", "srgb_rec709"}, ""}),
              "nacre: --space: gamut = \"compress\" needs a linear space, and srgb_rec709 is not linear; use clip or "
              "keep\n");
}

TEST(ColourOptions, DisplayAndViewAreThoseOfAllPictures) {
    const TemporaryFolder folder;
    folder.file("s.toml",
                scene +
                    "[lut.m]\noutputs = [\"exr\", \"png\"]\n[swatch.own]\ndraw = \"strip\"\ndisplay = \"Monitor\"\n"
                    "view = \"Bright\"\n[swatch.any]\ndraw = \"strip\"\n");
    const auto pictures = [&](std::vector<std::string> options) {
        options.insert(options.end(), {"--ocio", plain, "--space", "Linear", "--force"});
        const ProgramResult result = nacre(folder, {"bake", options, ""});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result.out.substr(result.out.find('\n') + 1);
    };
    EXPECT_EQ(pictures({}),
              "m.preview.png  preview  Monitor / Standard\nown.png  strip  Monitor / Bright\n"
              "any.png  strip  Monitor / Standard\n");
    const std::string texels = file_bytes(folder.path() / "out/m.png");
    EXPECT_EQ(pictures({"--display", "Beamer"}),
              "m.preview.png  preview  Beamer / Cinema\nown.png  strip  Beamer / Cinema\n"
              "any.png  strip  Beamer / Cinema\n");
    EXPECT_NE(file_bytes(folder.path() / "out/m.png"), texels);
    EXPECT_EQ(pictures({"--view", "Standard"}),
              "m.preview.png  preview  Monitor / Standard\n"
              "own.png  strip  Monitor / Standard\nany.png  strip  Monitor / Standard\n");
    EXPECT_EQ(file_bytes(folder.path() / "out/m.png"), texels);
    EXPECT_EQ(pictures({"--display", "Beamer", "--view", "Standard"}),
              "m.preview.png  preview  Beamer / Standard\nown.png  strip  Beamer / Standard\n"
              "any.png  strip  Beamer / Standard\n");
    // Monitor and Beamer have the same curve in their view Standard.
    EXPECT_EQ(file_bytes(folder.path() / "out/m.png"), texels);
}

TEST(ColourOptions, UnknownDisplaysAndViewsAreErrorsEvenIfNothingIsDrawn) {
    for (const char* command : {"bake", "plan", "swatch"}) {
        EXPECT_EQ(error_of(scene, {command, {"--display", "sRBG"}, ""}),
                  "nacre: --display: unknown display \"sRBG\" in config \"nacre (built in)\"; known: sRGB, Rec.1886, "
                  "Display P3\n");
    }
    EXPECT_EQ(
        error_of(scene, {"bake", {"--no-preview", "--view", "Film"}, ""}),
        "nacre: --view: unknown view \"Film\" of display \"sRGB\" in config \"nacre (built in)\"; known: Standard\n");
    EXPECT_EQ(error_of(scene, {"bake", {"--display", "Rec.1886", "--view", "Film"}, ""}),
              "nacre: --display, --view: unknown view \"Film\" of display \"Rec.1886\" in config \"nacre (built in)\"; "
              "known: Standard\n");
}

}  // namespace
}  // namespace nacre::test
