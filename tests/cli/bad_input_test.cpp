// A mistake, in a scene or on the command line, is one line on standard error, exit code 2, and nothing is written. The
// mistakes of scenes word by word: tests/pipeline/bad_scene_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

namespace nacre::test {
namespace {

constexpr const char* good_picks =
    "picks = [ { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1.0 },\n"
    "          { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n";

std::string scene(const std::string& more) {
    return "[material.m]\n" + std::string(good_picks) + more;
}

struct Mistake {
    const char* name;
    std::string scene;
    std::string message;  // behind "nacre: s.toml"; empty where the words are OpenColorIO's
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

class BadSceneOfTheProgram : public testing::TestWithParam<Mistake> {};

TEST_P(BadSceneOfTheProgram, IsOneLineThatSaysWhereAndWhatAndWritesNothing) {
    const TemporaryFolder folder;
    folder.file("s.toml", GetParam().scene);
    const ProgramResult result = run_nacre({"bake", "s.toml", "-o", "out"}, {folder.path(), {}, {}, {}});
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(result.err.find("nacre: s.toml:"), 0u) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    if (!GetParam().message.empty()) {
        EXPECT_EQ(result.err, "nacre: s.toml" + GetParam().message + "\n");
    }
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.toml"});
}

// One of each kind that is found before the colours, and all that OpenColorIO has to say.
const std::vector<Mistake> mistakes{
    {"UnknownKey", "[materail.m]\n", ":1:2: unknown key \"materail\"; did you mean material?"},
    {"OutOfRange", scene("[accuracy]\nmax_de00 = 0\n"),
     ":5:12 [accuracy]: max_de00 = 0 is out of range; allowed [1e-05, 100]"},
    {"NoToml", "[material.m\n", ""},
    {"CompressIntoACurveOfALut", scene("[lut.a]\nspace = \"srgb_rec709\"\ngamut = \"compress\"\n"),
     ":5:9 [lut.a]: gamut = \"compress\" needs a linear space, and srgb_rec709 is not linear; use clip or keep"},
    {"CompressIntoACurve", scene("[colour]\nspace = \"srgb_rec709\"\ngamut = \"compress\"\n"),
     ":5:9 [colour]: gamut = \"compress\" needs a linear space, and srgb_rec709 is not linear; use clip or keep"},
    {"UnknownColourSpace", scene("[colour]\nspace = \"lin_rec907\"\n"), ""},
    {"DataSpace", scene("[colour]\nspace = \"Raw\"\n"), ""},
    {"MissingConfig", scene("[colour]\nconfig = \"no.ocio\"\n"), ""},
    {"UnknownDisplay", scene("[swatch.a]\ndraw = \"strip\"\ndisplay = \"IMAX\"\n"), ""},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, BadSceneOfTheProgram, testing::ValuesIn(mistakes),
                         [](const auto& mistake) { return std::string(mistake.param.name); });

std::string error_of(const std::vector<std::string>& arguments, const TemporaryFolder& folder, int code,
                     std::vector<std::pair<std::string, std::string>> environment = {}) {
    const ProgramResult result = run_nacre(arguments, {folder.path(), std::move(environment), {}, {}});
    EXPECT_EQ(result.exit_code, code) << result.err;
    return result.err;
}

TEST(BadCommandLine, NearestColourSpacesAreOffered) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene("[colour]\nspace = \"lin_rec907\"\n"));
    EXPECT_NE(error_of({"bake", "s.toml"}, folder, 2).find("lin_rec709"), std::string::npos);
}

TEST(BadCommandLine, ConfigOfTheEnvironmentThatIsMissingIsAnErrorAndAnEmptyOneIsOurs) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene(""));
    EXPECT_NE(error_of({"bake", "s.toml", "-o", "out"}, folder, 2, {{"OCIO", "/no/such.ocio"}}).find("$OCIO"),
              std::string::npos);
    error_of({"bake", "s.toml", "-o", "out", "--no-preview"}, folder, 0, {{"OCIO", ""}});
}

TEST(BadCommandLine, CsvThatDoesNotCoverTheRangeSaysWhatItCovers) {
    const TemporaryFolder folder;
    folder.file("lamp.csv", "wavelength_nm,power\n400,1\n700,1\n");
    folder.file("s.toml", scene("[light]\nilluminant = \"lamp.csv\"\n"));
    EXPECT_EQ(
        error_of({"bake", "s.toml"}, folder, 2),
        "nacre: s.toml:5:14 [light]: illuminant \"lamp.csv\" covers 400 to 700 nm; range_nm needs 360 to 830 nm\n");
}

TEST(BadCommandLine, CsvWithTwoOfOneWavelengthNamesTheLine) {
    const TemporaryFolder folder;
    folder.file("lamp.csv", "360,1\n360,1\n830,1\n");
    folder.file("s.toml", scene("[light]\nilluminant = \"lamp.csv\"\n"));
    EXPECT_EQ(
        error_of({"bake", "s.toml"}, folder, 2),
        "nacre: lamp.csv:2:1: wavelength 360 does not ascend; give every wavelength once, smallest or largest first\n");
}

TEST(BadCommandLine, TwoScenesThatWriteOneFileAreRefused) {
    const TemporaryFolder folder;
    folder.file("a.toml", scene(""));
    folder.file("b.toml", scene(""));
    EXPECT_EQ(error_of({"bake", "a.toml", "b.toml", "-o", "out"}, folder, 2),
              "nacre: b.toml:1:11: this would write m.exr, and so would a.toml:1:11; rename one of them\n");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.toml", "b.toml"}));
}

TEST(BadCommandLine, UnknownNameOfOnlyIsAnError) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene(""));
    error_of({"bake", "s.toml", "--only", "q"}, folder, 2);
    error_of({"bake", "s.toml", "--shard", "3/2"}, folder, 2);
    error_of({"bake", "s.toml", "--threads", "-1"}, folder, 2);
    error_of({"bake"}, folder, 2);
    error_of({"bake", "s.toml", "--fast"}, folder, 2);
    EXPECT_EQ(error_of({"frobnicate"}, folder, 2),
              "nacre: unknown command \"frobnicate\"; known: init, bake, swatch, plan, cost, spectrum, pick, verify, "
              "list, snippet, figures\n");
    error_of({"snippet", "wgsl"}, folder, 2);
}

TEST(BadCommandLine, QuotesTheValueAndNamesTheHelpOfItsCommand) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene(""));
    const auto error = [&](std::vector<std::string> arguments) { return error_of(arguments, folder, 2); };
    EXPECT_EQ(error({"bake", "s.toml", "--threads", "many"}),
              "nacre: --threads \"many\" is not a whole number; allowed [0, 1024]; see nacre bake --help\n");
    EXPECT_EQ(error({"plan", "s.toml", "--accuracy", "-1"}),
              "nacre: --accuracy \"-1\" is out of range; allowed [1e-05, 100]; see nacre plan --help\n");
    EXPECT_EQ(error({"bake", "s.toml", "--treads", "3"}),
              "nacre: unknown option \"--treads\"; did you mean --threads?; see nacre bake --help\n");
    EXPECT_EQ(error({"bake", "s.toml", "--effects", "some"}),
              "nacre: --effects \"some\" is unknown; known: auto, all; see nacre bake --help\n");
    EXPECT_EQ(error({"bake", "s.toml", "-o"}), "nacre: --output needs a value: --output DIR; see nacre bake --help\n");
    EXPECT_EQ(error({"bake", "s.toml", "--accuracy", "1", "--accuracy", "2"}),
              "nacre: --accuracy is given twice; give it once; see nacre bake --help\n");
    EXPECT_EQ(error({"bake"}), "nacre: SCENE is required; see nacre bake --help\n");
    EXPECT_EQ(error({"snippet", "glsl", "hlsl"}), "nacre: unexpected argument \"hlsl\"; see nacre snippet --help\n");
    EXPECT_EQ(error({"--frob"}), "nacre: unknown option \"--frob\"; see nacre --help\n");
    EXPECT_NE(error({}).find("nacre: a command is missing; known: init, bake, "), std::string::npos);
}

TEST(Only, TakesSeveralNamesWithBlanksOrCommasAndLeavesTheScenesAlone) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene("[lut.a]\n[lut.b]\n[lut.c]\n"));
    const std::string both = "would write a.exr, a.json  256 x 1\nwould write b.exr, b.json  256 x 1\n";
    for (const std::vector<std::string>& only : {std::vector<std::string>{"--only", "a", "b", "s.toml"},
                                                 {"s.toml", "--only", "a", "b"},
                                                 {"--only", "a,b", "s.toml"},
                                                 {"s.toml", "--only=a,b"},
                                                 {"--only", "a", "--only", "b", "s.toml"},
                                                 {"--only", "a", "b", "--threads", "1", "s.toml"}}) {
        std::vector<std::string> arguments{"bake", "--dry-run", "--no-preview"};
        arguments.insert(arguments.end(), only.begin(), only.end());
        const ProgramResult result = run_nacre(arguments, {folder.path(), {}, {}, {}});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.out, both);
    }
}

TEST(BadCommandLine, SceneThatIsMissingIsAnInputError) {
    const TemporaryFolder folder;
    EXPECT_EQ(error_of({"bake", "none.toml"}, folder, 3),
              "nacre: none.toml: cannot be opened: No such file or directory\n");
    EXPECT_EQ(error_of({"bake", "."}, folder, 3), "nacre: .: is a folder; give a file\n");
}

TEST(BadPoints, RowsAreCheckedBeforeAnythingIsPrinted) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene(""));
    folder.file("p.csv", "material,angle_deg,wavelength_nm\nm,0,460\nq,0,460\n");
    EXPECT_EQ(error_of({"spectrum", "s.toml", "--points", "p.csv"}, folder, 2),
              "nacre: p.csv:3:1: unknown material \"q\"; known: m\n");
    folder.file("p.csv", "m,91,460\n");
    EXPECT_EQ(error_of({"spectrum", "s.toml", "--points", "p.csv"}, folder, 2),
              "nacre: p.csv:1:3: angle 91 is out of range; allowed [0, 90] degrees\n");
    folder.file("p.csv", "m,0,nan\n");
    EXPECT_EQ(error_of({"spectrum", "s.toml", "--points", "p.csv"}, folder, 2),
              "nacre: p.csv:1:5: \"nan\" is not a finite number\n");
}

}  // namespace
}  // namespace nacre::test
