// What the page asks of nacre, without the page: a session against the program's own ways.
#include "web/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/image/lut_file.h"
#include "nacre/base/error.h"
#include "support/folders.h"
#include "web/page_spaces.h"
#include "web/plain_exr.h"

namespace nacre::test {
namespace {

const std::filesystem::path root = NACRE_ROOT;

std::string shipped(const std::string& scene) {
    return file_bytes(root / "configs" / "scenes" / (scene + ".toml"));
}

nlohmann::json parsed(const Json& json) {
    return nlohmann::json::parse(json.text());
}

nlohmann::json opened(Session& session, const std::string& text) {
    nlohmann::json answer = parsed(session.open(text));
    EXPECT_TRUE(answer["mistakes"].empty()) << answer["mistakes"];
    return answer;
}

constexpr const char* film = "[material.film]\nmechanism = \"film\"\nindex = 1.33\nthickness_nm = 400\n";

// ---- files

LutHeader some_header() {
    LutHeader header;
    header.software = "nacre 1.2.3";
    header.interop_id = "lin_rec709_scene";
    header.chromaticities = {0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f};
    header.nacre = {{"lut", "one"}, {"accuracyReached", "0.07"}, {"scene", std::string(70000, 's')}};
    return header;
}

TEST(PlainExr, HasTheBytesThatOpenImageIoWrites) {
    Image<Rgb> image(37, 5);
    double value = -0.1;
    for (Rgb& texel : image) {
        texel = {value, value * 3.0, 1.0 - value};
        value += 0.0137;
    }
    image.at(3, 2) = {0.0, -0.0, 6e-8};  // zeros, and the smallest half
    LutHeader bare;
    bare.software = "nacre";
    for (const PixelFormat format : {PixelFormat::half_float, PixelFormat::single_float}) {
        EXPECT_EQ(plain_exr(image, format, some_header()), encode_lut(image, format, some_header()));
        EXPECT_EQ(plain_exr(image, format, bare), encode_lut(image, format, bare));
    }
}

TEST(PlainExr, RefusesWhatTheFormatCannotHold) {
    Image<Rgb> image(1, 1);
    image.at(0, 0) = {70000.0, 0.0, 0.0};
    EXPECT_THROW(plain_exr(image, PixelFormat::half_float, some_header()), Error);
    EXPECT_NO_THROW(plain_exr(image, PixelFormat::single_float, some_header()));
    image.at(0, 0).r = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(plain_exr(image, PixelFormat::single_float, some_header()), Error);
}

class FileOfThePage : public testing::TestWithParam<const char*> {};

// The texels and the header of the shipped texture, which the program wrote; of the transform's text only its form may
// differ, because OpenColorIO wrote the other.
TEST_P(FileOfThePage, IsThatOfTheProgram) {
    const TemporaryFolder folder;
    const std::string scene = GetParam();
    Session session;
    opened(session, shipped(scene));
    const std::string lut = session.luts().front();
    const StoredLut ours = read_lut((folder.path() / folder.file("page.exr", session.exr(lut))).string());
    const StoredLut theirs = read_lut((root / "luts" / (lut + ".exr")).string());
    EXPECT_EQ(ours.breach, "");
    ASSERT_EQ(ours.image.size(), theirs.image.size());
    EXPECT_TRUE(std::equal(ours.image.begin(), ours.image.end(), theirs.image.begin()));
    EXPECT_EQ(ours.header.chromaticities, theirs.header.chromaticities);
    ASSERT_EQ(ours.header.nacre.size(), theirs.header.nacre.size());
    for (const auto& [name, value] : theirs.header.nacre) {
        if (name != "colourTransform") {
            EXPECT_EQ(ours.header.value(name), value) << name;
        }
    }
    EXPECT_EQ(session.manifest(lut), file_bytes(root / "luts" / (lut + ".json")));
}

INSTANTIATE_TEST_SUITE_P(Scenes, FileOfThePage,
                         testing::Values("morpho", "beetle_stack", "picked_pair", "blue_sky", "oil_film",
                                         "compact_disc"));

// ---- reading a scene

TEST(SessionOpen, EveryShippedSceneOpens) {
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(root / "configs" / "scenes");  // where measured.toml finds its table
    for (const auto& entry : std::filesystem::directory_iterator(".")) {
        if (entry.path().extension() != ".toml") continue;
        Session session;
        const nlohmann::json answer = opened(session, file_bytes(entry.path()));
        EXPECT_FALSE(answer["luts"].empty()) << entry.path();
        EXPECT_FALSE(answer["values"].empty()) << entry.path();
    }
    std::filesystem::current_path(before);
}

TEST(SessionOpen, SaysWhereTheMistakesAre) {
    Session session;
    nlohmann::json mistakes =
        parsed(session.open("[material.a]\npicks = [ { angle_deg = 95, peak_nm = 500, width_nm = 90,"
                            " height = 1 } ]\nshap = 0.3\n"))["mistakes"];
    ASSERT_EQ(mistakes.size(), 2u);
    EXPECT_EQ(mistakes[0]["line"], 2);
    EXPECT_EQ(mistakes[0]["column"], 25);
    EXPECT_EQ(mistakes[1]["line"], 3);
    EXPECT_NE(mistakes[1]["message"].get<std::string>().find("did you mean shape?"), std::string::npos) << mistakes;
    mistakes = parsed(session.open("[material.a\n"))["mistakes"];
    ASSERT_EQ(mistakes.size(), 1u);
    EXPECT_EQ(mistakes[0]["line"], 1);
}

TEST(SessionOpen, KeepsTheLastGoodScene) {
    Session session;
    EXPECT_THROW(session.bake("film"), Error);
    opened(session, film);
    session.open("nonsense");
    EXPECT_EQ(parsed(session.bake("film").json)["name"], "film");
    EXPECT_THROW(session.bake("other"), Error);
}

// A value is changed in the text where it stands, and nothing else of the text.
TEST(SessionOpen, ValuesHaveTheirPlaces) {
    Session session;
    const std::string text =
        "# \xC3\xA4 comment\n[material.one]\npicks = [\n"
        "  { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1.0 }, # first\n]\n";
    const nlohmann::json values = opened(session, text)["values"];
    const nlohmann::json& peak = values["material.one.picks[0].peak_nm"];
    EXPECT_EQ(peak["value"], 460.0);
    EXPECT_EQ(peak["place"]["line"], 4);
    EXPECT_EQ(peak["place"]["column"], 30);
    EXPECT_EQ(peak["place"]["endColumn"], 33);
    const nlohmann::json& picks = values["material.one.picks"];
    EXPECT_EQ(picks["place"]["endLine"], 5);
    EXPECT_FALSE(picks.contains("value"));
}

TEST(SessionOpen, PicksAreBandsAndTheirColours) {
    Session session;
    const nlohmann::json answer =
        opened(session,
               "[material.a]\npicks = [ { angle_deg = 0, colour = \"#22aa44\" }, { angle_deg = 60, peak_nm = 450, "
               "width_nm = 80, height = 0.5 } ]\n");
    const nlohmann::json& picks = answer["materials"][0]["picks"];
    EXPECT_EQ(picks[0]["colour"], "#22aa44");
    // sRGB of IEC 61966-2-1: 0x22, 0xaa and 0x44 as light.
    const double light[] = {0.0159963, 0.4019778, 0.0578054};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(picks[0]["rgb"][i].get<double>(), light[i], 1e-6);
    EXPECT_FALSE(picks[1].contains("colour"));
    EXPECT_EQ(answer["materials"][0]["curve"].size(), 91u);
    EXPECT_EQ(answer["materials"][0]["curve"][60]["peakNm"], 450.0);
}

// Under incandescent light too a picked colour is shown as it was picked: the light's white is adapted to D65.
TEST(SessionOpen, PicksUnderAnotherLightAreAdapted) {
    Session session;
    const nlohmann::json answer = opened(
        session, "[light]\nilluminant = \"A\"\n[material.a]\npicks = [ { angle_deg = 0, colour = \"#22aa44\" } ]\n");
    const nlohmann::json& pick = answer["materials"][0]["picks"][0];
    const double light[] = {0.0159963, 0.4019778, 0.0578054};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(pick["rgb"][i].get<double>(), light[i], 1e-6);
    // The band is the last of its field, which is one wide and two high, if it is as wide and high as that.
    const Lobe lobe{pick["peakNm"], 0.0, 0.0, pick["floor"], pick["flatness"]};
    const std::vector<float> field = session.palette_field(lobe, pick["widthNm"], 2, 2);
    const double share = pick["height"];
    for (std::size_t i = 0; i < 3; ++i) {
        const double low = static_cast<double>(field[3 + i]);
        const double high = static_cast<double>(field[9 + i]);
        EXPECT_NEAR(low + share * (high - low), light[i], 1e-5);  // colours are linear in the height
    }
}

TEST(SessionOpen, RefusesAConfigOfOpenColorIo) {
    Session session;
    const nlohmann::json mistakes =
        parsed(session.open(std::string("[colour]\nconfig = \"studio.ocio\"\n") + film))["mistakes"];
    ASSERT_EQ(mistakes.size(), 1u);
    EXPECT_NE(mistakes[0]["message"].get<std::string>().find("no OpenColorIO"), std::string::npos) << mistakes;
}

// ---- baking

double largest_difference(const std::vector<float>& coarse, std::size_t coarse_width, const std::vector<float>& fine,
                          std::size_t width) {
    double largest = 0.0;
    for (std::size_t i = 0; i < coarse_width; ++i) {
        const std::size_t j = i * (width - 1) / (coarse_width - 1);
        if (j * (coarse_width - 1) != i * (width - 1)) continue;  // no texel of both
        for (std::size_t c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(static_cast<double>(coarse[3 * i + c] - fine[3 * j + c])));
    }
    return largest;
}

TEST(SessionBake, ACoarseAnswerIsNearTheExactOne) {
    Session session;
    opened(session, shipped("tortoise_beetle"));
    const std::string lut = session.luts().front();
    const Session::Answer coarse = session.bake(lut, true);
    const Session::Answer exact = session.bake(lut);
    EXPECT_FALSE(parsed(coarse.json).contains("reached"));
    EXPECT_LE(parsed(exact.json)["reached"].get<double>(), 0.1);
    const std::size_t width = parsed(exact.json)["width"];
    EXPECT_LT(parsed(coarse.json)["width"].get<std::size_t>(), width);
    EXPECT_LT(largest_difference(coarse.numbers, parsed(coarse.json)["width"], exact.numbers, width), 0.02);
}

// Without polarisation these colours are wrong by far more than the bound, and no texture can help.
TEST(SessionBake, RefusesABoundThatIsOutOfReach) {
    Session session;
    opened(session, shipped("beetle_stack") + "\n[accuracy]\nmax_de00 = 0.1\nwithout = [\"polarisation\"]\n");
    for (const bool is_coarse : {true, false}) {
        try {
            session.bake(session.luts().front(), is_coarse);
            ADD_FAILURE() << "was baked";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("max_de00 = "), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("cannot be reached; the best is"), std::string::npos);
        }
    }
}

// Nobody gave the bound: it is a goal, and the best there is comes with a word about it.
TEST(SessionBake, WarnsOfADefaultBoundThatIsOutOfReach) {
    Session session;
    opened(session, shipped("beetle_stack") + "\n[accuracy]\nwithout = [\"polarisation\"]\n");
    const nlohmann::json warnings = parsed(session.bake(session.luts().front()).json)["warnings"];
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].get<std::string>().find("the default max_de00 = 0.1 cannot be reached"), std::string::npos);
    opened(session, film);
    EXPECT_TRUE(parsed(session.bake("film").json)["warnings"].empty());
}

TEST(SessionBake, APairIsOneDecision) {
    Session session;
    opened(session, std::string(film) + "[lut.bubble]\nquantity = \"both\"\n");
    const nlohmann::json reflected = parsed(session.bake("bubble_r").json);
    const nlohmann::json transmitted = parsed(session.bake("bubble_t").json);
    EXPECT_EQ(reflected["entry"], transmitted["entry"]);
    EXPECT_EQ(reflected["width"], transmitted["width"]);
    EXPECT_EQ(transmitted["quantity"], "transmittance");
}

TEST(SessionBake, MatricesLeadToRec709) {
    Session session;
    opened(session, std::string("[colour]\nspace = \"lin_ap1\"\n") + film);
    const Session::Answer wide = session.bake("film");
    const auto matrix = parsed(wide.json)["toRec709"].get<std::vector<double>>();
    opened(session, film);
    const std::vector<float> narrow = session.bake("film").numbers;
    for (std::size_t row = 0; row < 3; ++row) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 3; ++i) sum += matrix[3 * row + i] * static_cast<double>(wide.numbers[i]);
        EXPECT_NEAR(sum, static_cast<double>(narrow[row]), 1e-3);  // both are rounded to halves
    }
}

TEST(SessionCost, AWiderBoundCostsLess) {
    Session session;
    opened(session, shipped("beetle_stack"));
    const std::string lut = session.luts().front();
    const nlohmann::json wide = parsed(session.cost(lut, 1.0));
    const nlohmann::json narrow = parsed(session.cost(lut, 0.05));
    EXPECT_LT(wide["bytes"], narrow["bytes"]);
    EXPECT_LE(wide["reached"].get<double>(), 1.0);
    EXPECT_LE(narrow["reached"].get<double>(), 0.05);
    EXPECT_GT(narrow["seconds"]["deciding"], 0.0);
}

TEST(PaletteField, HasTheColourOfThePickAtItsPlace) {
    Session session;
    const nlohmann::json picks = opened(session, shipped("morpho"))["materials"][0]["picks"];
    // 70 nm wide and 1 high is the second of three columns, the last row.
    const std::vector<float> field = session.palette_field({460.0, 0.0, 0.0, 0.0, 0.0}, 140.0, 3, 3);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(static_cast<double>(field[3 * (2 * 3 + 1) + i]), picks[0]["rgb"][i].get<double>(), 1e-6);
    EXPECT_EQ(field[0], 0.0f);
}

// ---- finding

TEST(FindStructure, FindsAFilmThatShowsThePicks) {
    Session session;
    opened(session,
           "[material.a]\npicks = [ { angle_deg = 0, colour = \"#d4a017\" }, { angle_deg = 55, colour = \"#3c9d9b\" "
           "} ]\n");
    int steps = 0;
    const nlohmann::json found = parsed(session.find_structure("a", "film", [&](int done) { steps = done + 1; }));
    EXPECT_GT(steps, 10);
    const nlohmann::json answer = opened(session, found["text"]);
    EXPECT_EQ(answer["materials"][0]["mechanism"], "film");
    EXPECT_FALSE(found["summary"].get<std::string>().empty());
    EXPECT_THROW(session.find_structure("a", "stack", {}), Error);  // no palette any more
}

TEST(FindStructure, CanBeStopped) {
    Session session;
    opened(session, shipped("morpho"));
    struct Stop {};
    EXPECT_THROW(session.find_structure("morpho", "film", [](int) { throw Stop(); }), Stop);
    EXPECT_EQ(parsed(session.bake("morpho").json)["name"], "morpho");
}

}  // namespace
}  // namespace nacre::test
