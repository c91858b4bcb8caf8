#include "io/ocio/colour_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>
#include <iterator>
#include <limits>
#include <utility>

#include "nacre/base/error.h"

namespace nacre {
namespace {

const std::string data_folder = std::string(NACRE_TEST_DATA_DIR) + "/ocio/";
const std::string where = "scene.toml:4";

ColourConfig builtin() {
    unsetenv("OCIO");
    return ColourConfig::open({});
}
ColourConfig opened(const std::string& file, const std::string& interchange = {}) {
    return ColourConfig::open({data_folder + file, interchange, "scene.toml:2"});
}

template <typename Action>
std::string message_of(Action action) {
    try {
        action();
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

// A file with a name of its own for the test that wants it.
std::string write_file(const std::string& name, const std::string& text) {
    const auto path = std::filesystem::path(testing::TempDir()) / ("nacre_colour_config_" + name);
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
}

Xyz white() {
    return d65_white;
}

void expect_near(Rgb actual, Rgb expected, double tolerance) {
    EXPECT_NEAR(actual.r, expected.r, tolerance);
    EXPECT_NEAR(actual.g, expected.g, tolerance);
    EXPECT_NEAR(actual.b, expected.b, tolerance);
}

// Saturated and neutral colours that cover the solid, for comparing conversions bit by bit.
Image<Xyz> many_colours() {
    Image<Xyz> image(64, 32);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double i = 64.0 * y + x;
            image.at(x, y) = {0.95 * std::fmod(0.618 * i, 1.0), std::fmod(0.377 * i, 1.0),
                              1.08 * std::fmod(0.755 * i, 1.0)};
        }
    }
    return image;
}

void expect_same_bits(const Image<Rgb>& a, const Image<Rgb>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a.data()[i], b.data()[i]) << "pixel " << i;
}

// XYZ of the primaries as exact rationals: from the chromaticities of IEC 61966-2-1, SMPTE EG 432-1, ITU-R BT.2020 and
// Adobe RGB (1998) with white (0.3127, 0.3290), Y = 1. The first three are also those of CSS Color 4, section 18.
struct ExactSpace {
    std::string name;
    std::array<Xyz, 3> primaries;
};
const std::array<ExactSpace, 4> exact_spaces{
    {{"lin_rec709",
      {{{506752. / 1228815, 87098. / 409605, 7918. / 409605},
        {87881. / 245763, 175762. / 245763, 87881. / 737289},
        {12673. / 70218, 12673. / 175545, 1001167. / 1053270}}}},
     {"lin_p3d65",
      {{{608311. / 1250200, 35783. / 156275, 0.},
        {189793. / 714400, 247089. / 357200, 32229. / 714400},
        {198249. / 1000160, 198249. / 2500400, 5220557. / 5000800}}}},
     {"lin_rec2020",
      {{{63426534. / 99577255, 26158966. / 99577255, 0.},
        {20160776. / 139408157, 472592308. / 697040785, 19567812. / 697040785},
        {47086771. / 278816314, 8267143. / 139408157, 295819943. / 278816314}}}},
     {"lin_adobergb",
      {{{573536. / 994567, 591459. / 1989134, 53769. / 1989134},
        {263643. / 1420810, 6239551. / 9945670, 351524. / 4972835},
        {187206. / 994567, 374412. / 4972835, 4929758. / 4972835}}}}}};

TEST(OurConfig, PrimariesOfTheStandardsBecomeUnitVectors) {
    for (const ExactSpace& space : exact_spaces) {
        const ColourTransform transform = builtin().to_colour_space(space.name, where);
        // 15 digits of coefficients up to 3.3.
        expect_near(transform.to_rgb(space.primaries[0]), {1, 0, 0}, 1e-14);
        expect_near(transform.to_rgb(space.primaries[1]), {0, 1, 0}, 1e-14);
        expect_near(transform.to_rgb(space.primaries[2]), {0, 0, 1}, 1e-14);
    }
}

TEST(OurConfig, D65WhiteIsOneInEveryLinearSpace) {
    for (const char* name : {"lin_rec709", "lin_p3d65", "lin_rec2020", "lin_adobergb", "lin_ap0", "lin_ap1"}) {
        expect_near(builtin().to_colour_space(name, where).to_rgb(white()), {1, 1, 1}, 1e-14);
    }
}

// AMPAS S-2008-001 and S-2014-004: chromaticities of AP0 and AP1. Under their own white, hence adapted by Bradford.
TEST(OurConfig, AcesPrimariesAdaptedFromAcesWhiteBecomeUnitVectors) {
    using Primaries = std::array<Chromaticity, 3>;
    const std::array<std::pair<std::string, Primaries>, 2> spaces{
        {{"lin_ap0", Primaries{{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}}}},
         {"lin_ap1", Primaries{{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}}}}}};
    const glm::dmat3 bradford =
        glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
    const auto vector = [](Xyz c) { return glm::dvec3(c.x, c.y, c.z); };
    const glm::dvec3 scale =
        (bradford * vector(white())) / (bradford * vector(xyz_from_chromaticity({0.32168, 0.33767})));
    for (const auto& [name, primaries] : spaces) {
        const ColourTransform transform = builtin().to_colour_space(name, where);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 d65 =
                glm::inverse(bradford) * (scale * (bradford * vector(xyz_from_chromaticity(primaries[i]))));
            const Rgb rgb = transform.to_rgb({d65.x, d65.y, d65.z});
            // Only the direction: how bright a primary is follows from white, which the test above holds.
            glm::dvec3 unit(0.0);
            unit[static_cast<int>(i)] = rgb.r + rgb.g + rgb.b;
            expect_near(rgb, {unit.x, unit.y, unit.z}, 1e-13);
        }
    }
}

// IEC 61966-2-1: 0.18 -> 1.055 * 0.18^(1/2.4) - 0.055; 0.001 -> 12.92 * 0.001. ITU-R BT.1886: 0.18^(1/2.4).
TEST(OurConfig, DisplaysAndTexturesUseTheCurvesOfTheirStandards) {
    const Xyz grey{0.18 * white().x, 0.18, 0.18 * white().z};
    const Xyz dark{0.001 * white().x, 0.001, 0.001 * white().z};
    const double srgb_grey = 1.055 * std::pow(0.18, 1.0 / 2.4) - 0.055;
    const double power_grey = std::pow(0.18, 1.0 / 2.4);
    const double tolerance = 1e-6;  // OpenColorIO's power function in float
    const ColourConfig config = builtin();
    for (const ColourTransform& srgb :
         {config.to_colour_space("srgb_rec709", where), config.to_display("sRGB", "", where),
          config.to_display("Display P3", "Standard", where)}) {
        expect_near(srgb.to_rgb(grey), {srgb_grey, srgb_grey, srgb_grey}, tolerance);
        // OpenColorIO makes the slope fit the power exactly: 12.92321 where the standard rounds to 12.92.
        expect_near(srgb.to_rgb(dark), {0.01292, 0.01292, 0.01292}, 5e-6);
        expect_near(srgb.to_rgb(white()), {1, 1, 1}, tolerance);
    }
    expect_near(config.to_display("Rec.1886", "", where).to_rgb(grey), {power_grey, power_grey, power_grey}, tolerance);
    // Wider primaries: Rec.709 red is not pure on Display P3.
    EXPECT_GT(config.to_display("Display P3", "", where).to_rgb(exact_spaces[0].primaries[0]).g, 0.1);
}

TEST(OurConfig, DefaultDisplayIsPlainSrgbAndSaysSo) {
    const ColourTransform transform = builtin().to_display("", "", where);
    EXPECT_EQ(transform.display(), "sRGB");
    EXPECT_EQ(transform.view(), "Standard");
    EXPECT_EQ(transform.name(), "sRGB / Standard");
    EXPECT_EQ(transform.interop_id(), "srgb_rec709_display");
    EXPECT_FALSE(transform.linear_matrix());
}

TEST(OurConfig, AliasesAndRolesAreResolvedToOneName) {
    const ColourConfig config = builtin();
    for (const char* name : {"lin_rec709", "LIN_REC709", "lin_srgb", "Linear Rec.709 (sRGB)", "scene_linear"}) {
        const ColourTransform transform = config.to_colour_space(name, where);
        EXPECT_EQ(transform.name(), "lin_rec709");
        EXPECT_EQ(transform.interop_id(), "lin_rec709_scene");
    }
    EXPECT_EQ(config.to_colour_space("sRGB - Texture", where).interop_id(), "srgb_rec709_scene");
    EXPECT_EQ(config.to_colour_space("ACES2065-1", where).name(), "lin_ap0");
}

TEST(OurConfig, XyzItselfIsAllowedThoughItsWhiteIsNotNeutral) {
    const ColourTransform transform = builtin().to_colour_space("lin_ciexyzd65_scene", where);
    expect_near(transform.to_rgb(Xyz{0.3, 0.2, 0.1}), {0.3, 0.2, 0.1}, 1e-15);
    EXPECT_EQ(transform.interop_id(), "lin_ciexyzd65_scene");
}

TEST(OurConfig, IsTheFileInTheRepository) {
    const ColourConfig file =
        ColourConfig::open({std::string(NACRE_TEST_DATA_DIR) + "/../../configs/ocio/config.ocio", "", where});
    EXPECT_EQ(builtin().description(), "nacre (built in)");
    EXPECT_EQ(file.description(), "config.ocio (nacre)");
    EXPECT_EQ(builtin().content_hash(), file.content_hash());
    EXPECT_EQ(file.content_hash().size(), 32U);
    EXPECT_NE(file.content_hash(), opened("wrong_white.ocio").content_hash());
    EXPECT_EQ(file.to_colour_space("lin_rec709", where).interop_id(), "lin_rec709_scene");
}

TEST(OurConfig, ListsWhatCanBeAskedFor) {
    const ColourConfig config = builtin();
    const std::vector<std::string> spaces = config.colour_spaces();
    EXPECT_EQ(spaces.front(), "lin_ciexyzd65_scene");
    EXPECT_EQ(std::count(spaces.begin(), spaces.end(), "Raw"), 0);
    EXPECT_EQ(config.displays(), (std::vector<std::string>{"sRGB", "Rec.1886", "Display P3"}));
    EXPECT_EQ(config.views("sRGB"), (std::vector<std::string>{"Standard", "Raw"}));
}

// The matrices of the three configs are given with 15 digits; ours are exact. 2e-14 is what was measured, doubled.
TEST(ThirdPartyConfigs, AgreeWithOurMatricesInEveryLinearSpaceThatTheyShare) {
    const std::array<std::pair<std::string, std::string>, 6> spaces{{{"ACES2065-1", "lin_ap0"},
                                                                     {"ACEScg", "lin_ap1"},
                                                                     {"Linear Rec.709 (sRGB)", "lin_rec709"},
                                                                     {"Linear P3-D65", "lin_p3d65"},
                                                                     {"Linear Rec.2020", "lin_rec2020"},
                                                                     {"Linear AdobeRGB", "lin_adobergb"}}};
    for (const char* file : {"aces-cg-1.0.0", "aces-studio-1.0.0", "cif-core-renderer-1.1.0"}) {
        const ColourConfig config = opened(std::string(file) + "/config.ocio");
        for (const auto& [theirs, ours] : spaces) {
            if (theirs == "Linear AdobeRGB" && std::string(file) != "cif-core-renderer-1.1.0") continue;
            const ColourTransform transform = config.to_colour_space(theirs, where);
            EXPECT_EQ(transform.name(), theirs);
            EXPECT_EQ(transform.interop_id(), ours + "_scene");
            const ColourTransform own = builtin().to_colour_space(ours, where);
            for (const Xyz colour : exact_spaces[0].primaries)
                expect_near(transform.to_rgb(colour), own.to_rgb(colour), 2e-14);
        }
    }
}

TEST(ThirdPartyConfigs, InactiveSpacesAreReachedAndADisplaySpaceIsNotToneMapped) {
    const ColourConfig config = opened("aces-cg-1.0.0/config.ocio");
    const ColourTransform transform = config.to_colour_space("sRGB - Display", where);
    EXPECT_EQ(transform.interop_id(), "srgb_rec709_display");
    expect_near(transform.to_rgb(white()), {1, 1, 1}, 1e-6);
}

// ACES 1.0 SDR maps diffuse white to about 0.81 and is neutral; "Un-tone-mapped" maps it to 1.
TEST(ThirdPartyConfigs, AViewAppliesItsToneMapAndStatesTheEncodingOfTheDisplay) {
    const ColourConfig config = opened("aces-cg-1.0.0/config.ocio");
    const ColourTransform film = config.to_display("", "", where);
    EXPECT_EQ(film.name(), "sRGB - Display / ACES 1.0 - SDR Video");
    EXPECT_EQ(film.interop_id(), "srgb_rec709_display");
    const Rgb rgb = film.to_rgb(white());
    EXPECT_NEAR(rgb.g, 0.81, 0.01);
    EXPECT_NEAR(rgb.r, rgb.g, 1e-3);
    EXPECT_NEAR(rgb.b, rgb.g, 1e-3);
    expect_near(config.to_display("sRGB - Display", "Un-tone-mapped", where).to_rgb(white()), {1, 1, 1}, 1e-6);
}

TEST(ThirdPartyConfigs, AConfigWithNothingButDataViewsHasNoSwatches) {
    EXPECT_EQ(message_of([] { opened("cif-core-renderer-1.1.0/config.ocio").to_display("", "", where); }),
              "scene.toml:4: view \"Raw\" shows data without conversion on display \"Raw\" in config "
              "\"config.ocio (core-renderer-config-v1.1.0)\"; it has no view that converts colours");
}

TEST(Interchange, AcesRoleThatNamesAnotherSpaceIsFoundByASaturatedColour) {
    EXPECT_EQ(message_of([] { opened("wrong_aces_role.ocio").to_colour_space("lin_rec709", where); }),
              "scene.toml:4: role \"aces_interchange\" (\"ACEScg\") of config \"wrong_aces_role.ocio (wrong)\" is "
              "wrong: it turns Rec.709 red into (0.692, 0.045, -0.002) in \"lin_rec709\", which should be (1.000, "
              "0.000, 0.000); correct "
              "the config, "
              "or name its scene-referred CIE XYZ D65 space as `interchange` or its ACES2065-1 space as "
              "`aces_interchange`");
}

TEST(Interchange, InterchangeOfTheSceneOverrulesAWrongRole) {
    const ColourTransform transform =
        opened("wrong_aces_role.ocio", "XYZ reference").to_colour_space("lin_rec709", where);
    expect_near(transform.to_rgb(exact_spaces[0].primaries[0]), {1, 0, 0}, 1e-13);
}

TEST(Interchange, RoleThatColoursWhiteIsRefusedForSpacesAndForViews) {
    const std::string message =
        "scene.toml:4: role \"aces_interchange\" (\"Studio XYZ\") of config \"wrong_white.ocio (wrong)\" is wrong: "
        "with it, D65 white "
        "becomes (1.205, 0.948, 0.909) in \"Studio Linear\"; correct the config, or name its scene-referred CIE XYZ "
        "D65 space as "
        "`interchange` or its ACES2065-1 space as `aces_interchange`";
    EXPECT_EQ(message_of([] { opened("wrong_white.ocio").to_colour_space("Studio Linear", where); }), message);
    EXPECT_EQ(message_of([] { opened("wrong_white.ocio").to_display("", "", where); }), message);
}

TEST(Interchange, RolesThatContradictEachOtherAreRefused) {
    EXPECT_EQ(message_of([] { opened("contradicting_roles.ocio").to_colour_space("Studio AP1", where); }),
              "scene.toml:4: role \"aces_interchange\" (\"Studio AP1\") and role \"cie_xyz_d65_interchange\" (\"Screen "
              "XYZ\") of "
              "config \"contradicting_roles.ocio (studio)\" contradict each other; correct the config, or name its "
              "scene-referred "
              "CIE XYZ D65 space as `interchange` or its ACES2065-1 space as `aces_interchange`");
}

TEST(Interchange, ConfigWithoutRolesNeedsAnInterchangeAndTakesIt) {
    EXPECT_EQ(message_of([] { opened("no_interchange.ocio").to_colour_space("Studio Linear", where); }),
              "scene.toml:4: config \"no_interchange.ocio (studio)\" has neither role \"aces_interchange\" nor role "
              "\"cie_xyz_d65_interchange\"; add one, or name its scene-referred CIE XYZ D65 space as `interchange` "
              "or its ACES2065-1 space as `aces_interchange`");
    const ColourConfig config = opened("no_interchange.ocio", "Studio XYZ");
    const ColourTransform transform = config.to_colour_space("scene_linear", where);
    EXPECT_EQ(transform.name(), "Studio Linear");
    EXPECT_EQ(transform.interop_id(), "lin_rec709_scene");
    expect_near(transform.to_rgb(white()), {1, 1, 1}, 1e-14);
    // Inactive, and yet asked for by name.
    EXPECT_EQ(config.to_colour_space("Studio Old", where).interop_id(), "lin_ap1_scene");
    const std::vector<std::string> listed = config.colour_spaces();
    EXPECT_EQ(std::count(listed.begin(), listed.end(), "Studio Old"), 0);
}

TEST(Interchange, InterchangeThatIsNotXyzIsRefused) {
    EXPECT_EQ(message_of([] {
                  opened("no_interchange.ocio", "Studio Old").to_colour_space("Studio Linear", where);
              }).substr(0, 86),
              "scene.toml:4: interchange \"Studio Old\" of config \"no_interchange.ocio (studio)\" is wro");
    EXPECT_EQ(message_of([] { opened("no_interchange.ocio", "Studio Data").to_colour_space("Studio Linear", where); }),
              "scene.toml:4: interchange \"Studio Data\" is a data space of config \"no_interchange.ocio (studio)\"; "
              "it must be CIE "
              "XYZ D65");
    EXPECT_EQ(message_of([] { opened("no_interchange.ocio", "Studio XYY").to_colour_space("Studio Linear", where); }),
              "scene.toml:4: unknown colour space \"Studio XYY\" in config \"no_interchange.ocio (studio)\"; nearest: "
              "Studio XYZ, "
              "Studio Old");
}

ColourConfig with_aces(const std::string& file, const std::string& aces_interchange) {
    return ColourConfig::open({data_folder + file, "", "scene.toml:2", aces_interchange});
}

TEST(Interchange, AnOldAcesConfigHasTheSpaceButNoRoleAndIsOfferedTheKey) {
    EXPECT_EQ(message_of([] { opened("aces_names_no_role.ocio").to_colour_space("scene_linear", where); }),
              "scene.toml:4: config \"aces_names_no_role.ocio (old aces)\" has neither role \"aces_interchange\" nor "
              "role \"cie_xyz_d65_interchange\"; add one, or give [colour] aces_interchange = \"ACES - ACES2065-1\"");
    const ColourConfig config = with_aces("aces_names_no_role.ocio", "ACES - ACES2065-1");
    const ColourTransform acescg = config.to_colour_space("scene_linear", where);
    EXPECT_EQ(acescg.name(), "ACES - ACEScg");
    EXPECT_EQ(acescg.interop_id(), "lin_ap1_scene");
    // Rec.709 red in ACEScg, adapted by Bradford: the first column of the matrix that the ACES CG config prints for it.
    expect_near(acescg.to_rgb(exact_spaces[0].primaries[0]), {0.613097, 0.070194, 0.020616}, 1e-6);
    expect_near(acescg.to_rgb(white()), {1, 1, 1}, 1e-9);
    expect_near(config.to_colour_space("Utility - Linear - sRGB", where).to_rgb(exact_spaces[0].primaries[0]),
                {1, 0, 0}, 1e-9);
}

// ACEScg keeps white white: only a saturated colour shows the mistake.
TEST(Interchange, AnAcesInterchangeThatIsNotAcesIsRefused) {
    const auto message = [](const std::string& file, const std::string& aces) {
        return message_of([&] { with_aces(file, aces).to_colour_space("scene_linear", where); });
    };
    EXPECT_EQ(
        message("aces_names_no_role.ocio", "ACES - ACEScg"),
        "scene.toml:4: aces_interchange \"ACES - ACEScg\" of config \"aces_names_no_role.ocio (old aces)\" is "
        "wrong: it turns Rec.709 red into (0.692, 0.045, -0.002) in \"Utility - Linear - sRGB\", which should be "
        "(1.000, 0.000, 0.000); correct the config, or name its scene-referred CIE XYZ D65 space as `interchange` "
        "or its ACES2065-1 space as `aces_interchange`");
    EXPECT_EQ(message("no_interchange.ocio", "Studio Data"),
              "scene.toml:4: aces_interchange \"Studio Data\" is a data space of config \"no_interchange.ocio "
              "(studio)\"; it must be ACES2065-1");
    EXPECT_EQ(message("no_interchange.ocio", "Studio XYZ").substr(0, 110),
              "scene.toml:4: aces_interchange \"Studio XYZ\" of config \"no_interchange.ocio (studio)\" is wrong: with "
              "it, D65 wh");
    EXPECT_EQ(
        message("aces_names_no_role.ocio", "ACES - ACES2056-1"),
        "scene.toml:4: unknown colour space \"ACES - ACES2056-1\" in config \"aces_names_no_role.ocio (old aces)\"; "
        "nearest: ACES - ACES2065-1");
}

TEST(Interchange, AnAcesInterchangeOverrulesAWrongRole) {
    std::ifstream file(data_folder + "aces_names_no_role.ocio");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    text.replace(text.find("roles: {"), 8, "roles: {aces_interchange: ACES - ACEScg, ");
    const std::string wrong = write_file("wrong_role.ocio", text);
    EXPECT_NE(message_of([&] {
                  ColourConfig::open({wrong, "", "--ocio"}).to_colour_space("scene_linear", where);
              }).find("role \"aces_interchange\" (\"ACES - ACEScg\")"),
              std::string::npos);
    const auto transform =
        ColourConfig::open({wrong, "", "--ocio", "ACES - ACES2065-1"}).to_colour_space("scene_linear", where);
    expect_near(transform.to_rgb(exact_spaces[0].primaries[0]), {0.613097, 0.070194, 0.020616}, 1e-6);
}

TEST(Interchange, AToneMapOnTheOnlyRoadIsRefused) {
    EXPECT_EQ(message_of([] { opened("tone_map_between.ocio").to_colour_space("Studio Linear", where); }),
              "scene.toml:4: role \"cie_xyz_d65_interchange\" (\"Screen XYZ\") of config \"tone_map_between.ocio "
              "(studio)\" is "
              "display-referred, the target is not, and the default view transform between is more than a matrix; give "
              "the config "
              "role \"aces_interchange\", or name its scene-referred CIE XYZ D65 space as `interchange`");
    expect_near(opened("tone_map_between.ocio").to_colour_space("Screen RGB", where).to_rgb(white()), {1, 1, 1}, 1e-6);
}

TEST(Interchange, WithBothRolesTheSceneIsEnteredOnItsOwnSide) {
    const ColourConfig config = opened("tone_map_and_both_roles.ocio");
    const ColourTransform scene = config.to_colour_space("Studio Linear", where);
    EXPECT_EQ(scene.interop_id(), "lin_rec709_scene");
    EXPECT_TRUE(scene.linear_matrix());
    // The display space without the tone map (a square root), the view with it.
    const Xyz grey{0.25 * white().x, 0.25, 0.25 * white().z};
    expect_near(config.to_colour_space("Screen RGB", where).to_rgb(grey), {0.25, 0.25, 0.25}, 1e-6);
    const ColourTransform plain = builtin().to_colour_space("lin_rec709", where);
    expect_near(config.to_display("", "", where).to_rgb(grey),
                plain.to_rgb(Xyz{std::sqrt(grey.x), std::sqrt(grey.y), std::sqrt(grey.z)}), 1e-6);
}

TEST(Interchange, AScenesXyzIsPreferredToAcesBecauseItNeedsNoAdaptation) {
    const ColourTransform transform = opened("two_scene_roles.ocio").to_colour_space("Studio Linear", where);
    expect_near(transform.to_rgb(exact_spaces[0].primaries[0]), {1, 0, 0}, 1e-13);
}

TEST(Targets, UnknownNamesAreAnsweredWithTheNearest) {
    EXPECT_EQ(message_of([] { builtin().to_colour_space("lin_rec710", where); }),
              "scene.toml:4: unknown colour space \"lin_rec710\" in config \"nacre (built in)\"; nearest: lin_rec709, "
              "lin_rec2020");
    EXPECT_EQ(
        message_of([] { builtin().to_colour_space("kodachrome", where); }),
        "scene.toml:4: unknown colour space \"kodachrome\" in config \"nacre (built in)\"; known: lin_ciexyzd65_scene, "
        "lin_rec709, lin_p3d65, lin_rec2020, lin_adobergb, lin_ap0, lin_ap1, acescct_ap1, srgb_rec709, "
        "lin_ciexyzd65_display, srgb_rec709_display, g24_rec709_display, srgb_p3d65_display");
    EXPECT_EQ(
        message_of([] { builtin().to_display("sRBG", "", where); }),
        "scene.toml:4: unknown display \"sRBG\" in config \"nacre (built in)\"; known: sRGB, Rec.1886, Display P3");
    EXPECT_EQ(
        message_of([] { builtin().to_display("sRGB", "Film", where); }),
        "scene.toml:4: unknown view \"Film\" of display \"sRGB\" in config \"nacre (built in)\"; known: Standard");
}

// lin_rec790 and film_rec709 are encoded: the one says so, the other is made of a power.
TEST(Targets, WhoAsksForALinearSpaceIsOfferedNoEncodedOne) {
    const std::string unknown = "scene.toml:4: unknown colour space ";
    EXPECT_EQ(message_of([] { opened("plain_linear.ocio").to_colour_space("lin_rec709", where); }),
              unknown + "\"lin_rec709\" in config \"plain_linear.ocio (plain)\"; its role scene_linear is \"Linear\"");
    EXPECT_EQ(message_of([] { opened("plain_linear.ocio").to_colour_space("Linaer", where); }),
              unknown + "\"Linaer\" in config \"plain_linear.ocio (plain)\"; nearest: Linear");
    EXPECT_EQ(message_of([] { opened("plain_linear.ocio").to_colour_space("fim_rec709", where); }),
              unknown + "\"fim_rec709\" in config \"plain_linear.ocio (plain)\"; nearest: film_rec709");
}

TEST(Targets, DataIsNoColour) {
    EXPECT_EQ(message_of([] { builtin().to_colour_space("data", where); }),
              "scene.toml:4: \"Raw\" is a data space of config \"nacre (built in)\"; a colour space is needed");
    EXPECT_EQ(
        message_of([] { builtin().to_display("sRGB", "Raw", where); }),
        "scene.toml:4: view \"Raw\" shows data without conversion on display \"sRGB\" in config \"nacre (built in)\"; "
        "known: Standard");
}

TEST(Targets, ConfigWithoutDisplaysHasNoSwatches) {
    EXPECT_EQ(message_of([] { opened("no_interchange.ocio", "Studio XYZ").to_display("", "", where); }),
              "scene.toml:4: config \"no_interchange.ocio (studio)\" has no displays; pictures need a config with a "
              "display and a "
              "view");
}

TEST(Opening, EnvironmentNamesTheConfigUnlessThePathDoes) {
    const std::string studio = data_folder + "no_interchange.ocio";
    setenv("OCIO", studio.c_str(), 1);
    EXPECT_EQ(ColourConfig::open({}).description(), "no_interchange.ocio (studio)");
    EXPECT_EQ(opened("wrong_white.ocio").description(), "wrong_white.ocio (wrong)");
    setenv("OCIO", "", 1);
    EXPECT_EQ(ColourConfig::open({}).description(), "nacre (built in)");
    setenv("OCIO", "/nowhere/config.ocio", 1);
    EXPECT_EQ(message_of([] { ColourConfig::open({}); }),
              "$OCIO: OCIO config \"/nowhere/config.ocio\" cannot be read (No such file or directory); name a readable "
              "config.ocio");
    unsetenv("OCIO");
    EXPECT_EQ(ColourConfig::open({}).description(), "nacre (built in)");
}

TEST(Opening, AConfigKnowsItsNameItsRolesAndWhoChoseIt) {
    EXPECT_EQ(builtin().name(), "nacre");
    EXPECT_FALSE(builtin().is_from_environment());
    const std::string named = data_folder + "plain_linear.ocio";
    setenv("OCIO", named.c_str(), 1);
    EXPECT_TRUE(ColourConfig::open({}).is_from_environment());
    EXPECT_FALSE(opened("plain_linear.ocio").is_from_environment());
    unsetenv("OCIO");
    const ColourConfig config = opened("plain_linear.ocio");
    EXPECT_EQ(config.name(), "plain");
    EXPECT_EQ(config.space_called("scene_linear"), "Linear");
    EXPECT_EQ(config.space_called("lin_rec709"), "");
    EXPECT_EQ(opened("aces-cg-1.0.0/config.ocio").space_called("lin_rec709"), "Linear Rec.709 (sRGB)");
    EXPECT_EQ(ColourConfig::open({write_file("nameless.ocio",
                                             "ocio_profile_version: 2\nroles: {default: a}\ncolorspaces:\n"
                                             "  - !<ColorSpace> {name: a}\n"),
                                  "", "--ocio"})
                  .name(),
              "nacre_colour_config_nameless.ocio");
}

// With a newer OpenColorIO the archive is a broken one, and the config is read.
TEST(Opening, WhatANewerOpenColorIoReadsIsRefusedByNameOrRead) {
    const auto message = [](const std::string& path) {
        return message_of([&] { ColourConfig::open({path, "", "--ocio"}); });
    };
    const std::string archive = write_file("packed.ocioz", "PK\x03\x04...");
    const std::string answer = message(archive);
    EXPECT_EQ(answer.substr(0, 21 + archive.size()), "--ocio: OCIO config \"" + archive);
    EXPECT_EQ(answer.find("yaml-cpp"), std::string::npos) << answer;
    const std::string inside = message("ocio://cg-config-v1.0.0_aces-v1.3_ocio-v2.1");
    EXPECT_TRUE(inside == "no error" ||
                inside.starts_with("--ocio: OCIO config \"ocio://cg-config-v1.0.0_aces-v1.3_ocio-v2.1\" is one that "
                                   "OpenColorIO contains from version 2.2 on; give a config that OpenColorIO 2.1, "))
        << inside;
}

TEST(Opening, WhatIsNoConfigIsRefusedInOneLine) {
    const auto message = [](const std::string& path) {
        return message_of([&] { ColourConfig::open({path, "", "--ocio"}); });
    };
    const std::string folder = data_folder.substr(0, data_folder.size() - 1);
    EXPECT_EQ(message(folder), "--ocio: OCIO config \"" + folder + "\" is a folder; name the config.ocio in it");
    const std::string empty = write_file("empty.ocio", "");
    EXPECT_EQ(message(empty),
              "--ocio: OCIO config \"" + empty + "\" is empty; an OCIO config begins with ocio_profile_version");
    const std::string large = write_file("large.ocio", std::string((std::size_t{16} << 20U) + 1, '#'));
    EXPECT_EQ(message(large), "--ocio: OCIO config \"" + large + "\" is longer than 16 MiB; that is the limit");
    std::filesystem::remove(large);
    for (const std::string& text :
         {std::string("garbage"), std::string("ocio_profile_version: 2.1\n"), std::string(1, '\0'),
          std::string("a: [1\nb: 2"), std::string("ocio_profile_version: 9.5\n")}) {
        const std::string path = write_file("bad.ocio", text);
        const std::string answer = message(path);
        EXPECT_EQ(answer.substr(0, 25 + path.size()), "--ocio: OCIO config \"" + path + "\" is");
        EXPECT_EQ(answer.find('\n'), std::string::npos);
        EXPECT_NE(answer.find("; give a config that OpenColorIO "), std::string::npos) << answer;
    }
    EXPECT_NE(message(write_file("bad.ocio", "ocio_profile_version: 9.5\n")).find("version 9.5"), std::string::npos);
}

TEST(Ctf, CarriesMatricesCurvesTablesAndToneMapsBitForBit) {
    const ColourConfig ours = builtin();
    const ColourConfig aces = opened("aces-cg-1.0.0/config.ocio");
    const Image<Xyz> colours = many_colours();
    for (const ColourTransform& transform :
         {ours.to_colour_space("lin_rec709", where), ours.to_colour_space("lin_ap1", where),
          ours.to_display("", "", where), aces.to_colour_space("ACEScc", where), aces.to_display("", "", where),
          aces.to_display("Rec.2100-PQ - Display", "", where)}) {
        const ColourTransform again = ColourTransform::from_ctf(transform.transform_text(), transform.name(), "a.exr");
        expect_same_bits(transform.to_rgb(colours), again.to_rgb(colours));
        EXPECT_EQ(transform.transform_text(), again.transform_text());
        EXPECT_EQ(transform.linear_matrix().has_value(), again.linear_matrix().has_value());
        EXPECT_EQ(again.name(), transform.name());
    }
}

TEST(Ctf, NamesNoFileAndLeavesNone) {
    // A folder of its own: other tests run beside this one.
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "nacre_colour_config_tmp";
    std::filesystem::create_directories(folder);
    setenv("TMPDIR", folder.c_str(), 1);
    const ColourTransform transform = opened("aces-cg-1.0.0/config.ocio").to_colour_space("ACEScc", where);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    EXPECT_EQ(transform.transform_text().find(folder.string()), std::string::npos);
    EXPECT_EQ(transform.transform_text().find(".ocio"), std::string::npos);
    std::filesystem::remove_all(folder);
    EXPECT_NE(message_of([] { builtin().to_colour_space("srgb_rec709", where); }).find("is $TMPDIR right?"),
              std::string::npos);
    unsetenv("TMPDIR");
}

TEST(Ctf, HostileTextIsRefused) {
    const auto message = [](const std::string& text) {
        return message_of([&] { ColourTransform::from_ctf(text, "x", "a.exr"); });
    };
    EXPECT_EQ(message("hello"), "a.exr: the OCIO transform is not a CTF; it must be a ProcessList");
    EXPECT_EQ(message("<ProcessList version=\"1.3\"><Reference path=\"/etc/passwd\"/></ProcessList>"),
              "a.exr: the OCIO transform refers to other files; it must contain everything itself");
    EXPECT_EQ(message("<ProcessList version=\"1.3\"><rEFERENCE path=\"/etc/passwd\"/></ProcessList>"),
              "a.exr: the OCIO transform refers to other files; it must contain everything itself");
    EXPECT_EQ(message("<!DOCTYPE x [<!ENTITY r \"y\">]><ProcessList/>"),
              "a.exr: the OCIO transform refers to other files; it must contain everything itself");
    const std::string cut = builtin().to_colour_space("lin_rec709", where).transform_text().substr(0, 200);
    const std::string answer = message(cut);
    EXPECT_EQ(answer.substr(0, 41), "a.exr: OpenColorIO refuses the transform:");
    EXPECT_EQ(answer.find('\n'), std::string::npos);
    EXPECT_EQ(answer.find("/tmp"), std::string::npos);
}

TEST(Apply, FirstPixelThatIsNotFiniteIsNamedBeforeOcioSeesIt) {
    Image<Xyz> image(3, 2, {0.1, 0.2, 0.3});
    image.at(2, 1).y = std::numeric_limits<double>::quiet_NaN();
    image.at(1, 1).z = std::numeric_limits<double>::infinity();
    const std::string message =
        "XYZ on the way to \"lin_rec709\": pixel (1, 1) is (0.1, 0.2, inf); only finite numbers are allowed";
    EXPECT_EQ(message_of([&] { builtin().to_colour_space("lin_rec709", where).to_rgb(image); }), message);
    image.at(1, 1).z = 1e300;  // finite, but not in float
    EXPECT_NE(
        message_of([&] { builtin().to_colour_space("srgb_rec709", where).to_rgb(image); }).find("(0.1, 0.2, 1e+300)"),
        std::string::npos);
}

TEST(Apply, ImagesKeepTheirShapeAndTheirOrder) {
    for (const char* name : {"lin_rec709", "srgb_rec709"}) {
        const ColourTransform transform = builtin().to_colour_space(name, where);
        const Image<Xyz> image = many_colours();
        const Image<Rgb> rgb = transform.to_rgb(image);
        ASSERT_EQ(rgb.width(), 64);
        ASSERT_EQ(rgb.height(), 32);
        // SIMD and scalar code of OpenColorIO may differ in the last bit.
        expect_near(rgb.at(5, 7), transform.to_rgb(image.at(5, 7)), 1e-6);
        EXPECT_EQ(transform.to_rgb(Image<Xyz>()).size(), 0U);
    }
}

TEST(Apply, LinearMatrixIsWhatIsApplied) {
    const ColourTransform transform = builtin().to_colour_space("lin_p3d65", where);
    ASSERT_TRUE(transform.linear_matrix());
    const glm::dvec3 rgb = *transform.linear_matrix() * glm::dvec3(0.3, 0.2, 0.1);
    EXPECT_EQ(transform.to_rgb(Xyz{0.3, 0.2, 0.1}), (Rgb{rgb.x, rgb.y, rgb.z}));
    EXPECT_FALSE(builtin().to_colour_space("srgb_rec709", where).linear_matrix());
}

}  // namespace
}  // namespace nacre
