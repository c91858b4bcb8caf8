// Every mistake is one clear line with file, line and column, exit code 2, and nothing is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "support/program.h"

namespace nacre::test {
namespace {

constexpr const char* good_picks =
    "picks = [ { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1.0 },\n"
    "          { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n";

std::string scene(const std::string& more) {
    return "[material.m]\n" + std::string(good_picks) + more;
}

std::string picks(const std::string& first, const std::string& second) {
    return "[material.beetle]\npicks = [\n    { " + first + " },\n    { " + second + " },\n]\n";
}

constexpr const char* pick_a = "angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1";
constexpr const char* pick_b = "angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7";

struct Mistake {
    const char* name;
    std::string scene;
    std::string message;  // behind "nacre: s.toml"
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

class BadScene : public testing::TestWithParam<Mistake> {};

TEST_P(BadScene, IsOneLineThatSaysWhereAndWhatAndWritesNothing) {
    const TemporaryFolder folder;
    folder.file("s.toml", GetParam().scene);
    const ProgramResult result = run_nacre({"bake", "s.toml", "-o", "out"}, {folder.path(), {}, {}, {}});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "nacre: s.toml" + GetParam().message + "\n");
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.toml"});
}

const std::vector<Mistake> mistakes{
    {"UnknownTopKey", "illuminant = \"D65\"\n" + scene(""),
     ":1:1: unknown key \"illuminant\"; known: include, nacre, accuracy, light, colour, material, lut, swatch"},
    {"UnknownKey", scene("colour = \"red\"\n"),
     ":4:1 [material.m]: unknown key \"colour\"; known: mechanism, picks, shape, tilt_deg"},
    {"MisspeltRequiredKey", "[material.m]\npiks = []\n",
     ":2:1 [material.m]: unknown key \"piks\"; did you mean picks?"},
    {"MisspeltHeading", "[materail.m]\n", ":1:2: unknown key \"materail\"; did you mean material?"},
    {"ControlCharacters", scene("[lut.a]\nmaterial = \"m\\u0000\"\n"),
     ":5:12 [lut.a]: material is 2 bytes with control characters among them; allowed is plain text of up to 4096 "
     "bytes"},
    {"MisspeltBound", scene("[accuracy]\nmax_de2000 = 0.1\n"),
     ":5:1 [accuracy]: unknown key \"max_de2000\"; known: max_de00, wavelengths, integral, nodes, realisations, "
     "effects, without, base_directions, radii, slices, size"},
    {"BoundOfNothing", scene("[accuracy]\nmax_de00 = 0\n"),
     ":5:12 [accuracy]: max_de00 = 0 is out of range; allowed [1e-05, 100]"},
    {"BoundThatIsNoNumber", scene("[accuracy]\nmax_de00 = \"small\"\n"),
     ":5:12 [accuracy]: max_de00 = \"small\" is a string; give a number"},
    {"UnknownIntegral", scene("[accuracy]\nintegral = \"riemann\"\n"),
     ":5:12 [accuracy]: unknown integral \"riemann\"; known: exact, fast"},
    {"IntegralAndWavelengths", scene("[accuracy]\nwavelengths = 50\nintegral = \"fast\"\n"),
     ":6:12 [accuracy]: integral says how to do without wavelengths, and wavelengths is given; leave one of them out"},
    {"WrongType", picks("angle_deg = \"0\", peak_nm = 460, width_nm = 70, height = 1", pick_b),
     ":3:19 [material.beetle]: angle_deg = \"0\" is a string; give a number"},
    {"MissingKey", picks("angle_deg = 0, peak_nm = 460, width_nm = 70", pick_b),
     ":3:5 [material.beetle]: height is missing; it has no default"},
    {"NegativeWidth", picks("angle_deg = 0, peak_nm = 460, width_nm = -20, height = 1", pick_b),
     ":3:48 [material.beetle]: width_nm = -20 is out of range; allowed [0, 1000] nm"},
    {"NaN", picks("angle_deg = 0, peak_nm = nan, width_nm = 20, height = 1", pick_b),
     ":3:32 [material.beetle]: peak_nm = nan is not a finite number; allowed [100, 2000] nm"},
    {"Infinity", picks("angle_deg = 0, peak_nm = 460, width_nm = inf, height = 1", pick_b),
     ":3:48 [material.beetle]: width_nm = inf is not a finite number; allowed [0, 1000] nm"},
    {"AngleBeyondGrazing", picks("angle_deg = 90.5, peak_nm = 460, width_nm = 20, height = 1", pick_b),
     ":3:19 [material.beetle]: angle_deg = 90.5 is out of range; allowed [0, 90] degrees"},
    {"NegativeAngle", picks("angle_deg = -1, peak_nm = 460, width_nm = 20, height = 1", pick_b),
     ":3:19 [material.beetle]: angle_deg = -1 is out of range; allowed [0, 90] degrees"},
    {"HeightAboveOne", picks("angle_deg = 0, peak_nm = 460, width_nm = 20, height = 1.01", pick_b),
     ":3:61 [material.beetle]: height = 1.01 is out of range; allowed [0, 1]"},
    {"ShapeOutside", scene("shape = 1.5\n"), ":4:9 [material.m]: shape = 1.5 is out of range; allowed [0, 1]"},
    {"NoPick", "[material.m]\npicks = [ ]\n", ":2:9 [material.m]: picks has 0 entries; allowed 1 to 100"},
    {"OneAngleTwoColours", picks(pick_a, "angle_deg = 0, peak_nm = 500, width_nm = 70, height = 1"),
     ":2:9 [material.beetle]: picks[0] and picks[1] are different colours at one angle, 0 degrees; allowed are angles "
     "at "
     "least 1e-09 degrees apart"},
    {"UnknownMechanism", "[material.m]\nmechanism = \"stuck\"\n",
     ":2:13 [material.m]: unknown mechanism \"stuck\"; known: palette, film, stack, grating, crystal, scatter, "
     "measured"},
    {"UnknownIlluminant", scene("[light]\nilluminant = \"D66\"\n"),
     ":5:14 [light]: unknown illuminant \"D66\"; known: D65, D50, D55, D75, A, E, FL2, FL7, FL11, or the name of a "
     ".csv file "
     "of wavelength_nm,power"},
    {"UnknownObserver", scene("[light]\nobserver = \"cie1932\"\n"),
     ":5:12 [light]: unknown observer \"cie1932\"; known: cie1931_2deg, cie1964_10deg"},
    {"UnknownAdaptation", scene("[light]\nadapt = \"cat02\"\n"),
     ":5:9 [light]: unknown adapt \"cat02\"; known: bradford, cat16, none"},
    {"RangeBeyondTheTables", scene("[light]\nrange_nm = [350, 830]\n"),
     ":5:13 [light]: range_nm = 350 is out of range; allowed [360, 830] nm"},
    {"EmptyRange", scene("[light]\nrange_nm = [700, 400]\n"),
     ":5:12 [light]: range_nm = [700, 400] is empty; the first must be smaller"},
    {"MissingCsv", scene("[light]\nilluminant = \"no.csv\"\n"),
     ":5:14: no.csv: cannot be opened: No such file or directory"},
    {"UnknownColourSpace", scene("[colour]\nspace = \"lin_rec907\"\n"), ""},
    {"DataSpace", scene("[colour]\nspace = \"Raw\"\n"), ""},
    {"MissingConfig", scene("[colour]\nconfig = \"no.ocio\"\n"), ""},
    {"UnknownGamut", scene("[colour]\ngamut = \"fold\"\n"),
     ":5:9 [colour]: unknown gamut \"fold\"; known: keep, clip, compress"},
    {"CompressIntoACurve", scene("[colour]\nspace = \"srgb_rec709\"\ngamut = \"compress\"\n"),
     ":5:9 [colour]: gamut = \"compress\" needs a linear space, and srgb_rec709 is none; use clip or keep"},
    {"SizeZero", scene("[lut.a]\nsize = 0\n"), ":5:8 [lut.a]: size = 0 is out of range; allowed [2, 4096] texels"},
    {"SizeOne", scene("[lut.a]\nsize = 1\n"), ":5:8 [lut.a]: size = 1 is out of range; allowed [2, 4096] texels"},
    {"SizeHuge", scene("[lut.a]\nsize = 100000\n"),
     ":5:8 [lut.a]: size = 100000 is out of range; allowed [2, 4096] texels"},
    {"SizeNoPower", scene("[lut.a]\nsize = 100\n"),
     ":5:8 [lut.a]: size = 100 is no power of two; allowed 2, 4, 8 ... 4096 (engines rescale other sizes)"},
    {"SizeNotWhole", scene("[lut.a]\nsize = 256.0\n"), ":5:8 [lut.a]: size = 256 is a number; give a whole number"},
    {"TwoSizesOneAxis", scene("[lut.a]\nsize = [64, 64]\n"),
     ":5:8 [lut.a]: size has two numbers, but there is no y axis; give one"},
    {"UnknownAxis", scene("[lut.a]\nx = \"cos\"\n"),
     ":5:5 [lut.a]: unknown axis \"cos\"; known: sqrt_cos_theta, cos_theta, theta_deg, or { parameter = \"...\", from "
     "= ..., to = "
     "... }"},
    {"AxisOverMissingParameter", scene("[lut.a]\ny = { parameter = \"thickness_nm\", from = 100, to = 900 }\n"),
     ":5:19 [lut.a]: mechanism palette has no parameter \"thickness_nm\"; known: shape, peak_nm, width_nm, height, "
     "picks[0].angle_deg, picks[0].peak_nm, picks[0].width_nm, picks[0].height, picks[1].angle_deg, picks[1].peak_nm, "
     "picks[1].width_nm, picks[1].height, tilt_deg"},
    {"AxisOutOfTheParametersRange", scene("[lut.a]\ny = { parameter = \"height\", from = 0, to = 2 }\n"),
     ":5:44 [lut.a]: to = 2 is out of range; allowed [0, 1]"},
    {"AxisWithoutLength", scene("[lut.a]\ny = { parameter = \"height\", from = 1, to = 1 }\n"),
     ":5:44 [lut.a]: from and to are both 1; an axis needs two different ends"},
    {"AxisThroughAnotherPick", scene("[lut.a]\ny = { parameter = \"picks[0].angle_deg\", from = 0, to = 60 }\n"),
     ":5:5 [lut.a]: picks[0].angle_deg from 0 to 60 passes picks[1] at 40 degrees; two picks at one angle have no "
     "colour "
     "between them"},
    {"TwoAngles", scene("[lut.a]\ny = \"cos_theta\"\n"),
     ":5:5 [lut.a]: x and y are both the angle; one of them has to be a parameter"},
    {"TwoAxesOneParameter",
     scene("[lut.a]\nx = { parameter = \"height\", from = 0, to = 1 }\ny = { parameter = \"picks[0].height\", from = "
           "0, to = 1 }\n"),
     ":6:5 [lut.a]: x and y both set picks[0].height; give two different parameters"},
    {"UnknownMaterial", scene("[lut.a]\nmaterial = \"n\"\n"), ":5:12 [lut.a]: unknown material \"n\"; known: m"},
    {"UnknownFormat", scene("[lut.a]\nformat = \"double\"\n"),
     ":5:10 [lut.a]: unknown format \"double\"; known: half, float"},
    {"UnknownOutput", scene("[lut.a]\noutputs = [\"tiff\"]\n"),
     ":5:11 [lut.a]: unknown output \"tiff\"; known: exr, json, png"},
    {"TwoLutsOneFile", scene("[lut.a]\n[lut.A]\n"),
     ":5:6: this would write A.exr, and so would s.toml:4:6; rename one of them"},
    {"NameThatLeavesTheFolder", scene("[lut.\"../a\"]\n"),
     ":4:6 [lut]: the name \"../a\" cannot be a file's name; allowed are 1 to 100 of A-Z a-z 0-9 _ - . (not first: - "
     ".)"},
    {"NoMaterial", "nacre = 1\n", ": material is missing; a scene needs a [material.NAME]"},
    {"NewerFormat", "nacre = 2\n" + scene(""), ":1:9: nacre = 2 is out of range; allowed [1, 1]"},
    {"NoToml", "[material.m\n", ""},
    {"DuplicateKey", scene("shape = 1\nshape = 0\n"), ""},
    {"UnknownSwatch", scene("[swatch.a]\ndraw = \"cube\"\n"),
     ":5:8 [swatch.a]: unknown swatch \"cube\"; known: plane, palette, strip, sphere, picks"},
    {"SwatchOfNothing", scene("[swatch.a]\n"), ":4:1 [swatch.a]: draw is missing; it has no default"},
    {"LightWithoutBlue",
     scene("[light]\nilluminant = { wavelength_nm = [360, 399, 400, 401, 402, 830], power = [0, 0, 1, 1, 0, 0] }\n"),
     ":5:14 [light]: the white of illuminant \"table\" cannot be adapted to D65; use adapt = \"none\", more "
     "wavelengths, or a broader spectrum"},
    {"LightThatIsNegative", scene("[light]\nilluminant = { wavelength_nm = [360, 830], power = [1, -1] }\n"),
     ":5:56 [light]: power = -1 is out of range; allowed [0, 1e+30]"},
    {"UnknownLutOfASwatch", scene("[swatch.a]\ndraw = \"strip\"\nlut = \"b\"\n"), ""},
    {"UnknownDisplay", scene("[swatch.a]\ndraw = \"strip\"\ndisplay = \"IMAX\"\n"), ""},
    {"IncludeOfNothing", "include = [\"none.toml\"]\n" + scene(""), ""},
    {"IncludeOfItself", "include = [\"s.toml\"]\n" + scene(""), ":1:11: include of \"s.toml\" includes itself"},
    {"ADate", scene("shape = 1979-05-27\n"), ""},
};

// Where the words are another room's (OpenColorIO, toml++), one line that begins with the place is enough here.
class BadSceneOfOtherRooms : public testing::TestWithParam<Mistake> {};

TEST_P(BadSceneOfOtherRooms, IsOneLineThatNamesTheFileAndWritesNothing) {
    const TemporaryFolder folder;
    folder.file("s.toml", GetParam().scene);
    const ProgramResult result = run_nacre({"bake", "s.toml", "-o", "out"}, {folder.path(), {}, {}, {}});
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(result.err.find("nacre: s.toml:"), 0u) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.toml"});
}

std::vector<Mistake> with_message(bool wanted) {
    std::vector<Mistake> result;
    for (const Mistake& mistake : mistakes) {
        if (mistake.message.empty() != wanted) result.push_back(mistake);
    }
    return result;
}

const auto name_of_case = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(Mistakes, BadScene, testing::ValuesIn(with_message(true)), name_of_case);
INSTANTIATE_TEST_SUITE_P(Mistakes, BadSceneOfOtherRooms, testing::ValuesIn(with_message(false)), name_of_case);

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
    error_of({"bake", "s.toml", "-o", "out"}, folder, 0, {{"OCIO", ""}});
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
    EXPECT_EQ(error_of({"bake", "s.toml"}, folder, 2),
              "nacre: lamp.csv:2: wavelength 360 does not ascend; give every wavelength once, smallest first\n");
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
              "nacre: unknown command \"frobnicate\"; known: bake, swatch, plan, cost, spectrum, pick, verify, "
              "snippet, figures\n");
    error_of({"snippet", "wgsl"}, folder, 2);
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
