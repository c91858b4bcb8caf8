// Every mistake in a scene is one clear line with file, line and column.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "io/ocio/ocio_spaces.h"
#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "pipeline/picked_colours.h"
#include "support/folders.h"

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
    std::string message;  // behind "s.toml"; empty where the words are OpenColorIO's or toml++'s
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

std::string message_of(const std::string& scene) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    const CurrentFolder here(folder.path());
    try {
        plan_scene(read_scene_file("s.toml"), scene_files_with_colours("s.toml", "", open_ocio_spaces));
    } catch (const Error& error) {
        return error.what();
    }
    return "was accepted";
}

class BadScene : public testing::TestWithParam<Mistake> {};

TEST_P(BadScene, IsOneLineThatSaysWhereAndWhat) {
    EXPECT_EQ(message_of(GetParam().scene), "s.toml" + GetParam().message);
}

const std::vector<Mistake> mistakes{
    {"UnknownTopKey", "illuminant = \"D65\"\n" + scene(""), ":1:1: unknown key \"illuminant\"; did you mean light?"},
    {"UnknownKey", scene("colour = \"red\"\n"),
     ":4:1 [material.m]: unknown key \"colour\"; known: mechanism, picks, shape, tilt_deg, roughness"},
    {"MisspeltRequiredKey", "[material.m]\npiks = []\n",
     ":2:1 [material.m]: unknown key \"piks\"; did you mean picks?"},
    {"MisspeltHeading", "[materail.m]\n", ":1:2: unknown key \"materail\"; did you mean material?"},
    {"ControlCharacters", scene("[lut.a]\nmaterial = \"m\\u0000\"\n"),
     ":5:12 [lut.a]: material is 2 bytes with control characters among them; give plain text of up to 4096 "
     "bytes"},
    {"MisspeltBound", scene("[accuracy]\nmax_de2000 = 0.1\n"),
     ":5:1 [accuracy]: unknown key \"max_de2000\"; did you mean max_de00?"},
    {"BoundOfNothing", scene("[accuracy]\nmax_de00 = 0\n"),
     ":5:12 [accuracy]: max_de00 = 0 is out of range; allowed [1e-05, 100]"},
    {"BoundThatIsNoNumber", scene("[accuracy]\nmax_de00 = \"small\"\n"),
     ":5:12 [accuracy]: max_de00 = \"small\" is a string; give a number"},
    {"UnknownSamplingCount", scene("[accuracy.sampling]\nrealisations = 8\n"),
     ":5:1 [accuracy.sampling]: unknown key \"realisations\"; known: nodes, thickness_samples, base_directions, radii, "
     "slices"},
    {"WrongType", picks("angle_deg = \"0\", peak_nm = 460, width_nm = 70, height = 1", pick_b),
     ":3:19 [material.beetle]: angle_deg = \"0\" is a string; give a number"},
    {"MissingKey", picks("angle_deg = 0, peak_nm = 460, width_nm = 70", pick_b),
     ":3:5 [material.beetle]: height is missing; it is required"},
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
     ":2:9 [material.beetle]: picks[0] and picks[1] are different colours at one angle, 0 degrees; give angles at "
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
     ":5:12 [light]: range_nm = [700, 400] is empty; give the smaller number first"},
    {"MissingCsv", scene("[light]\nilluminant = \"no.csv\"\n"),
     ":5:14: no.csv: cannot be opened: No such file or directory"},
    {"BothInterchanges", scene("[colour]\ninterchange = \"XYZ\"\naces_interchange = \"AP0\"\n"),
     ":6:20 [colour]: interchange and aces_interchange are both given; keep the one that names a space of the config: "
     "interchange for CIE XYZ D65, aces_interchange for ACES2065-1"},
    {"EmptyAcesInterchange", scene("[colour]\naces_interchange = \"\"\n"),
     ":5:20 [colour]: aces_interchange is empty; give a name, or remove the key"},
    {"UnknownGamut", scene("[colour]\ngamut = \"fold\"\n"),
     ":5:9 [colour]: unknown gamut \"fold\"; known: keep, clip, compress"},
    {"UnknownGamutOfALut", scene("[lut.a]\ngamut = \"fold\"\n"),
     ":5:9 [lut.a]: unknown gamut \"fold\"; known: keep, clip, compress"},
    {"EmptySpaceOfALut", scene("[lut.a]\nspace = \"\"\n"),
     ":5:9 [lut.a]: space is empty; give a name, or remove the key"},
    {"BoundOfALutOutOfRange", scene("[lut.a]\nmax_de00 = 0\n"),
     ":5:12 [lut.a]: max_de00 = 0 is out of range; allowed [1e-05, 100]"},
    {"SizeZero", scene("[lut.a]\nsize = 0\n"), ":5:8 [lut.a]: size = 0 is out of range; allowed [2, 16384] texels"},
    {"SizeOne", scene("[lut.a]\nsize = 1\n"), ":5:8 [lut.a]: size = 1 is out of range; allowed [2, 16384] texels"},
    {"SizeHuge", scene("[lut.a]\nsize = 100000\n"),
     ":5:8 [lut.a]: size = 100000 is out of range; allowed [2, 16384] texels"},
    {"SizeNoPower", scene("[lut.a]\nsize = 100\n"),
     ":5:8 [lut.a]: size = 100 is not a power of two; allowed 2, 4, 8 ... 16384 (engines rescale other sizes)"},
    {"SizeNotWhole", scene("[lut.a]\nsize = 256.0\n"), ":5:8 [lut.a]: size = 256 is a number; give a whole number"},
    {"SideTooLong", scene("[lut.a]\ny = { parameter = \"shape\", from = 0, to = 1 }\nsize = [16384, 64]\n"),
     ":6:9 [lut.a]: size = 16384 is out of range; allowed [2, 4096] texels"},
    {"TwoSizesOneAxis", scene("[lut.a]\nsize = [64, 64]\n"),
     ":5:8 [lut.a]: size has two numbers, but there is no y axis; give one"},
    {"UnknownAxis", scene("[lut.a]\nx = \"cos\"\n"),
     ":5:5 [lut.a]: unknown axis \"cos\"; known: sqrt_cos_theta, cos_theta, theta_deg, or { parameter = \"...\", from "
     "= ..., to = "
     "... }"},
    {"AxisOverMissingParameter", scene("[lut.a]\ny = { parameter = \"thickness_nm\", from = 100, to = 900 }\n"),
     ":5:19 [lut.a]: mechanism palette has no parameter \"thickness_nm\"; known: shape, peak_nm, width_nm, height, "
     "floor, flatness, picks[0].angle_deg, picks[0].peak_nm, picks[0].width_nm, picks[0].height, picks[0].floor, "
     "picks[0].flatness, picks[1].angle_deg, picks[1].peak_nm, picks[1].width_nm, picks[1].height, picks[1].floor, "
     "picks[1].flatness, tilt_deg, roughness"},
    {"AxisOutOfTheParametersRange", scene("[lut.a]\ny = { parameter = \"height\", from = 0, to = 2 }\n"),
     ":5:44 [lut.a]: to = 2 is out of range; allowed [0, 1]"},
    {"AxisWithoutLength", scene("[lut.a]\ny = { parameter = \"height\", from = 1, to = 1 }\n"),
     ":5:44 [lut.a]: from and to are both 1; an axis needs two different ends"},
    {"AxisThroughAnotherPick", scene("[lut.a]\ny = { parameter = \"picks[0].angle_deg\", from = 0, to = 60 }\n"),
     ":5:5 [lut.a]: picks[0].angle_deg from 0 to 60 passes picks[1] at 40 degrees; two picks at one angle have no "
     "colour "
     "between them"},
    {"TwoAngles", scene("[lut.a]\ny = \"cos_theta\"\n"),
     ":5:5 [lut.a]: x and y are both the angle; make one of them a parameter"},
    {"TwoAxesOneParameter",
     scene("[lut.a]\nx = { parameter = \"height\", from = 0, to = 1 }\ny = { parameter = \"picks[0].height\", from = "
           "0, to = 1 }\n"),
     ":6:5 [lut.a]: x and y both set picks[0].height; give two different parameters"},
    {"ParameterAsAxisWithoutItsEnds", scene("[lut.a]\ny = \"roughness\"\n"),
     ":5:5 [lut.a]: unknown axis \"roughness\"; known: sqrt_cos_theta, cos_theta, theta_deg, or { parameter = "
     "\"roughness\", from = ..., to = ... }"},
    {"RoughnessAsAxisOfATiltedMaterial",
     scene("tilt_deg = 3\n[lut.a]\ny = { parameter = \"roughness\", from = 0, to = 1 }\n"),
     ":5:1 [lut.a]: tilt_deg and roughness both say how the facets lean; remove one of them, or its axis"},
    {"RoughnessAndTiltAsAxes",
     scene(
         "[lut.a]\nx = { parameter = \"tilt_deg\", from = 0, to = 9 }\ny = { parameter = \"roughness\", from = 0, to = "
         "1 }\n"),
     ":4:1 [lut.a]: tilt_deg and roughness both say how the facets lean; remove one of them, or its axis"},
    {"UnknownMaterial", scene("[lut.a]\nmaterial = \"n\"\n"), ":5:12 [lut.a]: unknown material \"n\"; known: m"},
    {"UnknownFormat", scene("[lut.a]\nformat = \"double\"\n"),
     ":5:10 [lut.a]: unknown format \"double\"; known: half, float"},
    {"UnknownOutput", scene("[lut.a]\noutputs = [\"tiff\"]\n"),
     ":5:11 [lut.a]: unknown output \"tiff\"; known: exr, json, png"},
    {"TwoLutsOneFile", scene("[lut.a]\n[lut.A]\n"),
     ":5:6: this would write A.exr, and so would s.toml:4:6; rename one of them"},
    {"NameThatLeavesTheFolder", scene("[lut.\"../a\"]\n"),
     ":4:6 [lut]: the name \"../a\" cannot be the name of a file; give 1 to 100 characters out of A-Z a-z 0-9 _ - . "
     "that do not begin with - or . and do not end with ."},
    {"NoMaterial", "nacre = 1\n", ": material is missing; a scene needs a [material.NAME]"},
    {"NewerFormat", "nacre = 2\n" + scene(""),
     ":1:9: nacre = 2 means that the scene is made for a newer nacre; this program reads nacre = 1"},
    {"NoToml", "[material.m\n", ""},
    {"DuplicateKey", scene("shape = 1\nshape = 0\n"), ""},
    {"UnknownSwatch", scene("[swatch.a]\ndraw = \"cube\"\n"),
     ":5:8 [swatch.a]: unknown swatch \"cube\"; known: plane, palette, strip, sphere, bubble, disc, puddle, picks, "
     "contact_sheet, preview"},
    {"ExposureOfAPlane", scene("[swatch.a]\ndraw = \"plane\"\nexposure = 1\n"),
     ":6:12 [swatch.a]: exposure has no meaning for draw = \"plane\"; remove it, or draw a strip, sphere, bubble, disc "
     "or "
     "puddle"},
    {"ExposureBeyondReason", scene("[swatch.a]\ndraw = \"sphere\"\nexposure = 200\n"),
     ":6:12 [swatch.a]: exposure = 200 is out of range; allowed [-20, 20] EV"},
    {"AxisOfASphere", scene("[swatch.a]\ndraw = \"sphere\"\nx = \"cos_theta\"\n"),
     ":6:5 [swatch.a]: x has no meaning for draw = \"sphere\"; remove it, or draw a strip"},
    {"UnknownAxisOfAStrip", scene("[swatch.a]\ndraw = \"strip\"\nx = \"theta\"\n"),
     ":6:5 [swatch.a]: unknown axis \"theta\"; known: sqrt_cos_theta, cos_theta, theta_deg"},
    {"DiscOfAPalette", scene("[swatch.a]\ndraw = \"disc\"\n"),
     ":5:8 [swatch.a]: draw = \"disc\" shows a grating, and material \"m\" is a palette; draw a sphere"},
    {"SwatchOfNothing", scene("[swatch.a]\n"), ":4:1 [swatch.a]: draw is missing; it is required"},
    {"LightWithoutBlue",
     scene("[light]\nilluminant = { wavelength_nm = [360, 399, 400, 401, 402, 830], power = [0, 0, 1, 1, 0, 0] }\n"),
     ":5:14 [light]: the white of illuminant \"table\" cannot be adapted to D65; use adapt = \"none\", more "
     "wavelengths, or a broader spectrum"},
    {"LightThatIsNegative", scene("[light]\nilluminant = { wavelength_nm = [360, 830], power = [1, -1] }\n"),
     ":5:56 [light]: power = -1 is out of range; allowed [0, 1e+30]"},
    {"UnknownLutOfASwatch", scene("[swatch.a]\ndraw = \"strip\"\nlut = \"b\"\n"), ""},
    {"IncludeOfNothing", "include = [\"none.toml\"]\n" + scene(""), ""},
    {"IncludeOfItself", "include = [\"s.toml\"]\n" + scene(""), ":1:11: include of \"s.toml\" includes itself"},
    {"ADate", scene("shape = 1979-05-27\n"), ""},
};

// Where the words are another room's (OpenColorIO, toml++), one line that begins with the place is enough here.
class BadSceneOfOtherRooms : public testing::TestWithParam<Mistake> {};

TEST_P(BadSceneOfOtherRooms, IsOneLineThatNamesTheFile) {
    const std::string message = message_of(GetParam().scene);
    EXPECT_EQ(message.find("s.toml:"), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
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

// Several mistakes in one scene: all of them, in the order of the file, and nothing that only follows from them.
struct Mistakes {
    const char* name;
    std::string scene;
    std::string message;
};

void PrintTo(const Mistakes& several, std::ostream* out) {
    *out << several.name;
}

class ManyMistakes : public testing::TestWithParam<Mistakes> {};

TEST_P(ManyMistakes, AreAllReportedInFileOrder) {
    EXPECT_EQ(message_of(GetParam().scene), GetParam().message);
}

const std::vector<Mistakes> many_mistakes{
    {"OfOnePick",
     "[material.m]\npicks = [ { angle_deg = 91, peak_nm = 1, width_nm = \"wide\", height = 2, colr = 1 },\n"
     "          { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n",
     "s.toml:2:25 [material.m]: angle_deg = 91 is out of range; allowed [0, 90] degrees\n"
     "s.toml:2:39 [material.m]: peak_nm = 1 is out of range; allowed [100, 2000] nm\n"
     "s.toml:2:53 [material.m]: width_nm = \"wide\" is a string; give a number\n"
     "s.toml:2:70 [material.m]: height = 2 is out of range; allowed [0, 1]\n"
     "s.toml:2:73 [material.m]: unknown key \"colr\"; did you mean colour?"},
    {"OfSeveralPicks",
     "[material.m]\nshape = 2\npicks = [ { angle_deg = 0, colour = \"#12\" },\n"
     "          { angle_deg = 0, colour = \"red\" } ]\n",
     "s.toml:2:9 [material.m]: shape = 2 is out of range; allowed [0, 1]\n"
     "s.toml:3:37 [material.m]: colour = \"#12\" is not a colour; give \"#rrggbb\", \"#rgb\" or [r, g, b]\n"
     "s.toml:4:37 [material.m]: colour = \"red\" is not a colour; give \"#rrggbb\", \"#rgb\" or [r, g, b]"},
    {"UnknownKeysComeBeforeMissingOnes", "[material.m]\nmechanism = \"film\"\nior = 1.4\nfoo_bar_baz = 1\n",
     "s.toml:3:1 [material.m]: unknown key \"ior\"; did you mean index?\n"
     "s.toml:4:1 [material.m]: unknown key \"foo_bar_baz\"; known: mechanism, incident, index, thickness_nm, "
     "substrate, "
     "thickness_spread_nm, base, tilt_deg, roughness, polarisation\n"
     "s.toml:1:1 [material.m]: thickness_nm is missing; it is required"},
    {"OfEverySection",
     "[accuracy]\nmax_de00 = 0\n[light]\nobserver = \"me\"\nrange_nm = [1, 2]\n[colour]\ngamut = \"fold\"\nspce = "
     "\"a\"\n"
     "[material.a]\nmechanism = \"film\"\nindex = \"Water\"\nthickness_nm = -1\n"
     "[material.b]\nmechanism = \"stuck\"\n"
     "[lut.a]\nmaterial = \"a\"\nsize = 100\nformat = \"double\"\n[lut.c]\nmaterial = \"c\"\n"
     "[swatch.s]\ndraw = \"cube\"\n[swatch.t]\ndraw = \"strip\"\nlut = \"a\"\n",
     "s.toml:2:12 [accuracy]: max_de00 = 0 is out of range; allowed [1e-05, 100]\n"
     "s.toml:4:12 [light]: unknown observer \"me\"; known: cie1931_2deg, cie1964_10deg\n"
     "s.toml:5:13 [light]: range_nm = 1 is out of range; allowed [360, 830] nm\n"
     "s.toml:5:16 [light]: range_nm = 2 is out of range; allowed [360, 830] nm\n"
     "s.toml:7:9 [colour]: unknown gamut \"fold\"; known: keep, clip, compress\n"
     "s.toml:8:1 [colour]: unknown key \"spce\"; did you mean space?\n"
     "s.toml:11:9: unknown material \"Water\"; nearest: water; `nacre list materials` prints all; a .yml or .csv file "
     "is also allowed\n"
     "s.toml:12:16 [material.a]: thickness_nm = -1 is out of range; allowed [0, 1e+08] nm\n"
     "s.toml:17:8 [lut.a]: size = 100 is not a power of two; allowed 2, 4, 8 ... 16384 (engines rescale other sizes)\n"
     "s.toml:18:10 [lut.a]: unknown format \"double\"; known: half, float\n"
     "s.toml:20:12 [lut.c]: unknown material \"c\"; known: a, b\n"
     "s.toml:22:8 [swatch.s]: unknown swatch \"cube\"; known: plane, palette, strip, sphere, bubble, disc, puddle, "
     "picks, contact_sheet, preview"},
    {"OfLayers",
     "[material.m]\nmechanism = \"stack\"\nlayers = [ { ior = 1.5, thickness_nm = 1 },\n"
     "  { index = 1.5, thickness = 3 },\n  { repeat = 2, layers = [ { index = 0, thickness_nm = 5 } ] } ]\ntilt_deg = "
     "99\n",
     "s.toml:3:14 [material.m]: unknown key \"ior\"; did you mean index?\n"
     "s.toml:4:18 [material.m]: unknown key \"thickness\"; did you mean thickness_nm?\n"
     "s.toml:5:38 [material.m]: index = 0 is out of range; allowed [1e-06, 1000]\n"
     "s.toml:6:12 [material.m]: tilt_deg = 99 is out of range; allowed [0, 60] degrees"},
    {"AMaterialThatIsWrongIsNotWrongAgainInItsLut",
     "[material.m]\npicks = 3\n[lut.a]\ny = { parameter = \"no\", from = 0, to = 1 }\nsize = [64, 64]\nangl_deg = 3\n",
     "s.toml:2:9 [material.m]: picks = 3 is a whole number; give an array\n"
     "s.toml:6:1 [lut.a]: unknown key \"angl_deg\"; did you mean angle_deg?"},
    {"ASearchDoesNotBeginWithMistakes",
     "[material.m]\nmechanism = \"film\"\npicks = [ { angle_deg = 0, colour = \"#22cc66\" } ]\nthicknes = 3\n",
     "s.toml:4:1 [material.m]: unknown key \"thicknes\"; did you mean thickness_nm?"},
    {"BothSpellings", "[colour]\ngamut = \"clip\"\n[color]\ngamut = \"keep\"\n" + scene(""),
     "s.toml:3:2: color and colour are the same key, and both are given; remove one of them"},
};

INSTANTIATE_TEST_SUITE_P(Scenes, ManyMistakes, testing::ValuesIn(many_mistakes), name_of_case);

TEST(MistakesOfAScene, AfterTwentyAreCounted) {
    std::string text = "[material.m]\n" + std::string(good_picks);
    std::string expected;
    for (int i = 1; i <= 27; ++i) {
        text += "wrong_key_" + std::to_string(i) + " = 1\n";
        if (i <= 20) {
            expected += "s.toml:" + std::to_string(3 + i) + ":1 [material.m]: unknown key \"wrong_key_" +
                        std::to_string(i) + "\"; known: mechanism, picks, shape, tilt_deg, roughness\n";
        }
    }
    EXPECT_EQ(message_of(text), expected + "... and 7 more");
}

TEST(Spelling, OfColourIsBritishOrAmerican) {
    const std::string american =
        "[color]\ngamut = \"clip\"\n[material.m]\npicks = [ { angle_deg = 0, color = \"#22cc66\" },\n"
        "          { angle_deg = 60, colour = \"#2266cc\" } ]\n";
    EXPECT_EQ(message_of(american), "was accepted");
}

TEST(Spelling, OfNamesThatTheUserChoseIsTheirs) {
    EXPECT_EQ(message_of("[material.color]\n" + std::string(good_picks) + "[material.colour]\n" + good_picks),
              "was accepted");
}

// What people write instead of TOML: the message says what to write.
const std::vector<Mistake> toml_mistakes{
    {"ColourWithoutQuotes", "[material.m]\npicks = [\n    { angle_deg = 0, colour = #22cc66 },\n]\n",
     ":3:31: a colour needs quotes, because # begins a comment; write colour = \"#22cc66\" instead of colour = "
     "#22cc66"},
    {"DecimalComma", "[material.m]\nshape = 0,7\n",
     ":2:10: a number has a decimal point; write shape = 0.7 instead of shape = 0,7"},
    {"DecimalCommaInATable", "[material.m]\npicks = [ { angle_deg = 12,5, colour = \"#fff\" } ]\n",
     ":2:29: a number has a decimal point; write angle_deg = 12.5 instead of angle_deg = 12,5"},
    {"CurlyQuotes",
     "[material.m]\nmechanism = \xE2\x80\x9C"
     "film\xE2\x80\x9D\n",
     ":2:13: quotation marks must be straight; write mechanism = \"film\" instead of mechanism = "
     "\xE2\x80\x9C"
     "film\xE2\x80\x9D"},
    {"Utf16", std::string("\xFF\xFE[\0m\0]\0", 8), ":1: the file is UTF-16; save it as UTF-8"},
    {"LineBreakInATable", "[material.m]\npicks = [\n    { angle_deg = 0,\n      colour = \"#fff\" },\n]\n",
     ":3:21: a table between { and } must stand on one line; join this line and those up to the }: { angle_deg = 0,"},
    {"WordWithoutQuotes", "[material.m]\nmechanism = film\n",
     ":2:14: text needs quotes; write mechanism = \"film\" instead of mechanism = film"},
    {"CapitalBoolean", "[material.m]\nincoherent = True\n",
     ":2:14: true and false have small letters; write incoherent = true instead of incoherent = True"},
    {"NoHint", "[material.m\n", ":1:12: not TOML: Error while parsing table header: expected ']', saw '\\n'"},
};
INSTANTIATE_TEST_SUITE_P(Toml, BadScene, testing::ValuesIn(toml_mistakes), name_of_case);

}  // namespace
}  // namespace nacre::test
