// `nacre pick`, as its users run it, where picks lead to films, stacks, gratings and crystals.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <ostream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"

namespace nacre::test {
namespace {

const std::string gold_beetle = std::string(NACRE_SOURCE_DIR) + "/configs/scenes/gold_beetle.csv";

using Arguments = std::vector<std::string>;

ProgramResult pick(Arguments arguments, const ProgramOptions& options = {}) {
    arguments.insert(arguments.begin(), "pick");
    return run_nacre(arguments, options);
}

Arguments with(Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

// The program's JSON is the last of what it prints.
nlohmann::json parsed(const ProgramResult& result) {
    return nlohmann::json::parse(result.out, nullptr, false);
}

// The numbers that a scene's comments say: "},  # dE00 4.7".
std::vector<double> commented_de00(const std::string& scene) {
    std::vector<double> numbers;
    const std::regex comment(R"(\},  # dE00 (\S+))");
    for (auto it = std::sregex_iterator(scene.begin(), scene.end(), comment); it != std::sregex_iterator(); ++it)
        numbers.push_back(std::stod((*it)[1]));
    return numbers;
}

int lines_with(const std::string& text, const std::string& words) {
    std::istringstream lines(text);
    int count = 0;
    for (std::string line; std::getline(lines, line);) count += line.find(words) != std::string::npos ? 1 : 0;
    return count;
}

// ---- Every mechanism

struct Found {
    const char* mechanism;
    Arguments picks;
    Arguments options;
    int warnings;
};
void PrintTo(const Found& found, std::ostream* out) {
    *out << found.mechanism;
}
class PickedMechanism : public testing::TestWithParam<Found> {};

TEST_P(PickedMechanism, IsASceneThatBakesAndKeepsItsWord) {
    const TemporaryFolder folder;
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const Found& asked = GetParam();
    const ProgramResult picked = pick(with(with(asked.picks, {"--mechanism", asked.mechanism}), asked.options), here);
    ASSERT_EQ(picked.exit_code, 0) << picked.err;
    EXPECT_EQ(lines_with(picked.err, " misses by CIEDE2000 "), asked.warnings) << picked.err;
    EXPECT_NE(picked.out.find("mechanism = \"" + std::string(asked.mechanism) + "\"\n"), std::string::npos)
        << picked.out;
    // The crystals are all much like one.
    if (std::string(asked.mechanism) != "crystal") {
        EXPECT_NE(picked.out.find("# Other answers; --choose N prints the N-th:\n#   2: "), std::string::npos)
            << picked.out;
    }
    const std::vector<double> promised = commented_de00(picked.out);
    ASSERT_EQ(promised.size(), asked.picks.size()) << picked.out;

    folder.file("s.toml", picked.out);
    const ProgramResult plan = run_nacre({"plan", "--json", "s.toml"}, here);
    ASSERT_EQ(plan.exit_code, 0) << plan.err;
    // Nothing is looked for in it.
    EXPECT_EQ(plan.err, "");
    const auto json = parsed(plan);
    ASSERT_FALSE(json.is_discarded()) << plan.out;
    EXPECT_FALSE(json.at("luts").at(0).contains("found"));
    const auto& reached = json.at("luts").at(0).at("picked");
    ASSERT_EQ(reached.size(), promised.size());
    for (std::size_t i = 0; i < promised.size(); ++i) {
        // Two digits.
        const double de00 = reached[i].at("de00");
        EXPECT_NEAR(promised[i], de00, 0.05 * std::max(de00, promised[i]) + 1e-3);
    }
    const ProgramResult baked = run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, here);
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
    for (const char* file : {"picked.exr", "picked_picks.png", "picked_strip.png", "picked_sphere.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / file)) << file;
    const ProgramResult verified = run_nacre({"verify", "out/picked.exr"}, here);
    EXPECT_EQ(verified.exit_code, 0) << verified.err;
}

INSTANTIATE_TEST_SUITE_P(All, PickedMechanism,
                         testing::Values(Found{"film", {"#3a6fd0@0", "#7030b0@40"}, {}, 2},
                                         Found{"stack", {"#3a6fd0@0", "#7030b0@40"}, {}, 0},
                                         Found{"crystal", {"#3a6fd0@0", "#7030b0@40"}, {}, 2},
                                         Found{"grating", {"#3a6fd0@15", "#7030b0@40"}, {"--with", "grooves = 3"}, 2}),
                         [](const auto& mechanism) { return std::string(mechanism.param.mechanism); });

// ---- Options

const Arguments blue_film{"#3a6fd0@0", "#7030b0@40", "--mechanism", "film"};

TEST(PickOptions, ChooseTakesAnotherAnswer) {
    const ProgramResult best = pick(blue_film);
    const ProgramResult second = pick(with(blue_film, {"--choose", "2"}));
    ASSERT_EQ(second.exit_code, 0) << second.err;
    // What was an other is now the one, and the other way round.
    const auto line_of = [](const std::string& text, const std::string& begin) {
        const auto at = text.find("\n" + begin);
        if (at == std::string::npos) return std::string("none");
        return text.substr(at + 1 + begin.size(), text.find('\n', at + 1) - at - 1 - begin.size());
    };
    EXPECT_EQ(line_of(best.out, "#   2: "), line_of(second.out, "# "));
    EXPECT_EQ(line_of(best.out, "# "), line_of(second.out, "#   1: "));
    EXPECT_EQ(second.out.find("#   2: "), std::string::npos);
    const auto worse = commented_de00(second.out), better = commented_de00(best.out);
    ASSERT_EQ(worse.size(), 2u);
    EXPECT_GT(std::hypot(worse[0], worse[1]), std::hypot(better[0], better[1]));
}

TEST(PickOptions, WithFixesAndBounds) {
    const ProgramResult result =
        pick(with(blue_film, {"--with", "index = \"water\"", "--with", "thickness_nm = { from = 100, to = 300 }",
                              "--with", "substrate = \"si\""}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("\nindex = \"water\"\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\nsubstrate = \"si\"\n"), std::string::npos) << result.out;
    const auto at = result.out.find("\nthickness_nm = ");
    ASSERT_NE(at, std::string::npos);
    const double nm = std::strtod(result.out.c_str() + at + 16, nullptr);
    EXPECT_GE(nm, 100.0);
    EXPECT_LE(nm, 300.0);
    // Nothing else was free.
    EXPECT_NE(result.out.find("\n# thickness_nm = "), std::string::npos) << result.out;
}

TEST(PickOptions, LayersMayBeFreeAndHaveATolerance) {
    const Arguments cavity{"#dbfffd@0",   "#fae7fd@60",
                           "--mechanism", "stack",
                           "--with",      "layers = [ { index = \"ag\" }, { index = \"sio2\" } ]",
                           "--with",      "substrate = \"ag\"",
                           "--with",      "tolerance = { thickness_nm = 2 }"};
    const ProgramResult result = pick(cavity);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("\n# layers[0].thickness_nm = 20.0"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("; thicknesses off by 2 nm move the colour by dE00 0."), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("    { index = \"ag\", thickness_nm = 20.0"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("tolerance"), std::string::npos) << result.out;
    const auto json = parsed(run_nacre(with({"--json", "pick"}, cavity)));
    const auto& tolerance = json["found"][0]["tolerance"];
    EXPECT_EQ(tolerance["thickness_nm"], 2.0);
    EXPECT_GT(tolerance["mean_de00"], 0.1);
    EXPECT_GT(tolerance["percentile_95_de00"], tolerance["mean_de00"]);
    EXPECT_GT(json["picked"][1]["tolerance"]["percentile_95_de00"], 0.1);
}

TEST(PickOptions, JsonHasPicksAnswersAndTheScene) {
    ProgramResult result = run_nacre(with({"--json", "pick"}, blue_film));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto json = parsed(result);
    ASSERT_FALSE(json.is_discarded()) << result.out;
    ASSERT_EQ(json["picked"].size(), 2u);
    EXPECT_EQ(json["picked"][0]["colour"], "#3a6fd0");
    EXPECT_EQ(json["picked"][1]["angle_deg"], 40.0);
    ASSERT_GE(json["found"].size(), 2u);
    double before = 0.0;
    for (const auto& found : json["found"]) {
        EXPECT_EQ(found["values"].size(), 3u);
        EXPECT_EQ(found["de00"].size(), 2u);
        EXPECT_EQ(found["nearest_materials"].size(), 2u);
        EXPECT_GE(found["error"], before);
        before = found["error"];
    }
    EXPECT_EQ(json["scene"], pick(blue_film).out);
}

TEST(PickOptions, StrictRefusesWhatIsMissed) {
    const ProgramResult refused = pick(with(blue_film, {"--strict"}));
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(refused.err.find("nacre: #3a6fd0 at 0 deg: the best film found misses by CIEDE2000 "), 0u) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    // What is met is not.
    const ProgramResult met = pick({"#3a6fd0@0", "#7030b0@40", "--mechanism", "stack", "--strict"});
    EXPECT_EQ(met.exit_code, 0) << met.err;
    EXPECT_EQ(met.err, "");
}

TEST(PickOptions, MeasuredFitsAPaletteOfSoManyPicks) {
    const TemporaryFolder folder;
    const ProgramOptions here{folder.path(), {}, {}, {}};
    for (const int picks : {2, 3}) {
        const ProgramResult result = pick({"--measured", gold_beetle, "--picks", std::to_string(picks)}, here);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        std::size_t count = 0;
        for (auto at = result.out.find("{ angle_deg = "); at != std::string::npos;
             at = result.out.find("{ angle_deg = ", at + 1))
            ++count;
        EXPECT_EQ(count, static_cast<std::size_t>(picks)) << result.out;
        folder.file("s.toml", result.out);
        const ProgramResult baked =
            run_nacre({"bake", "s.toml", "--no-preview", "-o", "out" + std::to_string(picks)}, here);
        EXPECT_EQ(baked.exit_code, 0) << baked.err;
    }
    const ProgramResult json = run_nacre({"--json", "pick", "--measured", gold_beetle});
    const auto parts = parsed(json);
    ASSERT_FALSE(parts.is_discarded()) << json.out;
    ASSERT_EQ(parts["angles"].size(), 12u);
    double sum = 0.0;
    for (const auto& angle : parts["angles"]) {
        const double de00 = angle["de00"];
        sum += de00 * de00;
    }
    EXPECT_NEAR(parts["error"], std::sqrt(sum / 12.0), 1e-9);
    EXPECT_LT(parts["error"], 10.0);
}

TEST(PickOptions, MeasuredLeadsToAFilmToo) {
    const TemporaryFolder folder;
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult result = pick(
        {"--measured", gold_beetle, "--mechanism", "film", "--with", "index = 1.7", "--with", "substrate = 2"}, here);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("picks = { measured = \"" + gold_beetle + "\" }"), std::string::npos) << result.out;
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("#    angle  measured peak"), std::string::npos) << result.out;
    folder.file("s.toml", result.out);
    const ProgramResult baked = run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, here);
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
}

TEST(PickOptions, SwatchIsAPng) {
    const TemporaryFolder folder;
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const Arguments palette{"#22cc66@0", "#1fb5c9@50"};
    const ProgramResult result = pick(with(palette, {"--swatch", "a.png"}), here);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, pick(palette).out);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.png"});
    EXPECT_EQ(file_bytes(folder.path() / "a.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
    const ProgramResult film = pick(with(blue_film, {"--with", "index = 2", "--swatch", "b.png"}), here);
    ASSERT_EQ(film.exit_code, 0) << film.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "b.png"}));
    EXPECT_EQ(file_bytes(folder.path() / "b.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
}

// ---- What others make of the same colours

constexpr double degree = std::numbers::pi / 180.0;
const Arguments green_to_purple{"#22aa44@0", "#8822cc@60"};

using Texel = std::array<float, 3>;

// Of a LUT with one axis; empty if it cannot be read.
std::vector<Texel> texels_of(const std::filesystem::path& file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) return {};
    std::vector<Texel> texels(static_cast<std::size_t>(input->spec().width));
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, texels.data())) return {};
    return texels;
}

std::string text_of(const Texel& texel) {
    return std::to_string(texel[0]) + "," + std::to_string(texel[1]) + "," + std::to_string(texel[2]);
}

TEST(PickBeside, NamesAStackThatKeepsItsWord) {
    const TemporaryFolder folder;
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult palette = pick(green_to_purple, here);
    ASSERT_EQ(palette.exit_code, 0) << palette.err;
    EXPECT_NE(palette.out.find("the colour passes through grey"), std::string::npos) << palette.out;
    std::smatch named;
    const std::regex line(
        R"(# also: (--mechanism stack)(?: --choose (\d+))?: dE00 (\S+) and (\S+), through cyan and blue\n)");
    ASSERT_TRUE(std::regex_search(palette.out, named, line)) << palette.out;

    Arguments typed = with(green_to_purple, {"--mechanism", "stack"});
    if (named[2].matched) typed = with(typed, {"--choose", named[2]});
    const ProgramResult stack = pick(typed, here);
    ASSERT_EQ(stack.exit_code, 0) << stack.err;
    const std::vector<double> de00 = commented_de00(stack.out);
    ASSERT_EQ(de00.size(), 2u);
    EXPECT_NEAR(de00[0], std::stod(named[3]), 0.01 + 0.05 * de00[0]);
    EXPECT_NEAR(de00[1], std::stod(named[4]), 0.01 + 0.05 * de00[1]);
    // Its texture is blue on the way: more blue than anything else, which neither end nor grey is.
    folder.file("s.toml", stack.out);
    ASSERT_EQ(run_nacre({"bake", "s.toml", "-o", "out"}, here).exit_code, 0);
    const std::vector<Texel> texels = texels_of(folder.path() / "out/picked.exr");
    ASSERT_FALSE(texels.empty());
    EXPECT_TRUE(std::any_of(texels.begin(), texels.end(), [&](const Texel& rgb) {
        const double x = static_cast<double>(&rgb - texels.data()) / static_cast<double>(texels.size() - 1);
        const bool is_between = x * x > std::cos(50.0 * degree) && x * x < std::cos(20.0 * degree);
        return is_between && rgb[2] > 2.0F * rgb[1] && rgb[2] > 3.0F * rgb[0];
    }));
}

TEST(PickBeside, IsLeftOutForAPaletteThatWasAskedFor) {
    const ProgramResult palette = pick(with(green_to_purple, {"--mechanism", "palette"}));
    EXPECT_EQ(palette.exit_code, 0) << palette.err;
    EXPECT_EQ(palette.out.find("# also: "), std::string::npos) << palette.out;
    const auto json = parsed(run_nacre(with({"--json", "pick"}, green_to_purple)));
    ASSERT_EQ(json["beside"].size(), 1u) << json;
    EXPECT_EQ(json["beside"][0]["mechanism"], "stack");
    EXPECT_EQ(json["beside"][0]["through"], (std::vector<std::string>{"cyan", "blue"}));
}

TEST(PickAuto, RanksAllMechanismsAndPrintsTheOneThatIsChosen) {
    const Arguments automatic = with(green_to_purple, {"--mechanism", "auto"});
    const auto json = parsed(run_nacre(with({"--json", "pick"}, automatic)));
    ASSERT_EQ(json["ranked"].size(), 5u) << json;
    EXPECT_EQ(json["ranked"][0]["mechanism"], "palette");  // it alone meets both
    double before = 0.0;
    for (const auto& one : json["ranked"]) {
        EXPECT_GE(one["error"], before);
        before = one["error"];
    }
    const std::string second = json["ranked"][1]["mechanism"], best = json["scene"];
    EXPECT_NE(best.find("\nmechanism = \"palette\"\n"), std::string::npos) << best;
    EXPECT_NE(best.find("#   2: " + second + ": "), std::string::npos) << best;
    const ProgramResult other = pick(with(automatic, {"--choose", "2"}));
    EXPECT_NE(other.out.find("\nmechanism = \"" + second + "\"\n"), std::string::npos) << other.out;
    EXPECT_NE(other.out.find("#   1: palette (dE00 0 and 0, through grey)\n"), std::string::npos) << other.out;
}

// A film is simpler than a palette of two picks, if it meets them: three numbers instead of seven.
TEST(PickAuto, TakesTheFilmThatTheColoursCameFrom) {
    const TemporaryFolder folder;
    const ProgramOptions here{folder.path(), {}, {}, {}};
    folder.file("film.toml",
                "[material.m]\nmechanism = \"film\"\nindex = 1.5\nthickness_nm = 330\nsubstrate = 3\n"
                "[lut.m]\nmaterial = \"m\"\nx = \"theta_deg\"\nsize = 128\nformat = \"float\"\n");
    ASSERT_EQ(run_nacre({"bake", "film.toml", "-o", "out"}, here).exit_code, 0);
    const std::vector<Texel> texels = texels_of(folder.path() / "out/m.exr");
    ASSERT_EQ(texels.size(), 128u);
    const Arguments colours{text_of(texels[0]) + "@0", text_of(texels[64]) + "@" + std::to_string(90.0 * 64.0 / 127.0)};
    const ProgramResult found = pick(with(colours, {"--mechanism", "auto", "--space", "lin_rec709"}), here);
    ASSERT_EQ(found.exit_code, 0) << found.err;
    EXPECT_NE(found.out.find("\nmechanism = \"film\"\n"), std::string::npos) << found.out;
}

// ---- Picks at the edge of sense

struct Degenerate {
    const char* name;
    Arguments picks;
    int palette_exit;
    const char* palette_says;  // in its errors and warnings; empty: it says nothing
    int film_exit;
    const char* film_says;
};
void PrintTo(const Degenerate& degenerate, std::ostream* out) {
    *out << degenerate.name;
}
class DegeneratePicks : public testing::TestWithParam<Degenerate> {};

void expect_outcome(const ProgramResult& result, int exit_code, const std::string& says) {
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    if (says.empty()) {
        EXPECT_EQ(result.err, "");
    }
    EXPECT_NE(result.err.find(says), std::string::npos) << result.err;
    if (exit_code == 0) {
        EXPECT_EQ(result.out.find("nan"), std::string::npos) << result.out;
        EXPECT_EQ(result.out.find("inf"), std::string::npos) << result.out;
    } else {
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
}

TEST_P(DegeneratePicks, HaveADefinedOutcome) {
    const TemporaryFolder folder;
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const Degenerate& degenerate = GetParam();
    const ProgramResult palette = pick(degenerate.picks, here);
    expect_outcome(palette, degenerate.palette_exit, degenerate.palette_says);
    const ProgramResult film = pick(with(degenerate.picks, {"--mechanism", "film"}), here);
    expect_outcome(film, degenerate.film_exit, degenerate.film_says);
    for (const ProgramResult& result : {palette, film}) {
        if (result.exit_code != 0) continue;
        folder.file("s.toml", result.out);
        const ProgramResult planned = run_nacre({"plan", "s.toml"}, here);
        EXPECT_EQ(planned.exit_code, 0) << planned.err << result.out;
    }
}

constexpr const char* film_misses = "; a stack may come closer (mechanism = \"stack\")";
constexpr const char* not_finite = "is not a finite number; allowed [-65504, 65504]";

INSTANTIATE_TEST_SUITE_P(
    All, DegeneratePicks,
    testing::Values(
        Degenerate{"Black", {"#000@0", "#000@50"}, 0, "", 0, ""},
        Degenerate{"White", {"#fff@0", "#fff@50"}, 0, "", 0, film_misses},
        Degenerate{"Grey", {"#808080@0", "#808080@70"}, 0, "", 0, film_misses},
        Degenerate{"Equal", {"#2c6@0", "#2c6@50"}, 0, "", 0, film_misses},
        Degenerate{"TwoAtOneAngle", {"#2c6@10", "#c62@10"}, 2, "different colours at one angle", 0, film_misses},
        Degenerate{"TheSameTwice", {"#2c6@10", "#2c6@10"}, 0, "", 0, film_misses},
        Degenerate{"One", {"#38c@0"}, 0, "one pick gives the same colour at every angle", 0, film_misses},
        Degenerate{"Grazing", {"#2c6@0", "#b94@90"}, 0, "", 0, "at 90 degrees every surface reflects all light"},
        Degenerate{"NegativeAndBright", {"-0.1,0.5,2@0", "0.2,0.3,0.1@50"}, 0, "is dimmed to ", 0, film_misses},
        Degenerate{"AllNegative", {"-1,-1,-1@0", "#222@50"}, 0, "is shown as black", 0, film_misses},
        Degenerate{"NaN", {"0.1,nan,0.3@0", "#123@50"}, 2, not_finite, 2, not_finite},
        Degenerate{"Infinite", {"inf,0,0@0", "#123@50"}, 2, not_finite, 2, not_finite},
        Degenerate{"BeyondAHalf",
                   {"70000,0,0@0", "#123@50"},
                   2,
                   "colour = 70000 is out of range; allowed [-65504, 65504]",
                   2,
                   "colour = 70000 is out of range; allowed [-65504, 65504]"}),
    [](const auto& degenerate) { return std::string(degenerate.param.name); });

TEST(DegeneratePick, ABrightColourOfNothingElseIsMissedByAll) {
    for (const char* mechanism : {"stack", "crystal"}) {
        const ProgramResult result = pick({"-3,40,900@0", "#000@60", "--mechanism", mechanism});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2) << result.err;
        EXPECT_EQ(result.out.find("nan"), std::string::npos) << result.out;
    }
}

// ---- Mistakes

struct Mistake {
    const char* name;
    Arguments arguments;
    int exit_code;
    const char* says;
};
void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}
class BadPickCommand : public testing::TestWithParam<Mistake> {};

TEST_P(BadPickCommand, IsOneLine) {
    const TemporaryFolder folder;
    const ProgramResult result = pick(GetParam().arguments, {folder.path(), {}, {}, {}});
    EXPECT_EQ(result.exit_code, GetParam().exit_code);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.find("nacre: "), 0u) << result.err;
    EXPECT_NE(result.err.find(GetParam().says), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(folder.names().empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, BadPickCommand,
    testing::Values(
        Mistake{"UnknownMechanism",
                {"#123@0", "#223@40", "--mechanism", "foo"},
                2,
                "unknown mechanism \"foo\"; known: palette, film, stack, grating, crystal"},
        Mistake{"Scatter",
                {"#123@0", "#223@40", "--mechanism", "scatter"},
                2,
                "picks have no meaning for mechanism scatter"},
        Mistake{"MeasuredAsMechanism",
                {"#123@0", "#223@40", "--mechanism", "measured"},
                2,
                "picks have no meaning for mechanism measured"},
        Mistake{"BrokenToml", with(blue_film, {"--with", "index ="}), 2, "not TOML"},
        Mistake{"UnknownKey", with(blue_film, {"--with", "indx = 1.3"}), 2,
                "unknown key \"indx\"; did you mean index?"},
        Mistake{"UnknownMaterial", with(blue_film, {"--with", "index = \"watr\""}), 2, "watr"},
        Mistake{"NoSuchAnswer", with(blue_film, {"--choose", "99"}), 2, "--choose 99: the answers are 1 to "},
        Mistake{"AnswerNought", with(blue_film, {"--choose", "0"}), 2, "--choose"},
        Mistake{"Tilt", with(blue_film, {"--with", "tilt_deg = 3"}), 2, "tilt_deg and picks: "},
        Mistake{"NoProfile", {"#123@10", "--mechanism", "grating", "--with", "profile = \"square\""}, 2, "profile"},
        Mistake{"NoColours", {}, 2, "give one of the two"},
        Mistake{"ColoursAndMeasured", {"#123@0", "--measured", "x.csv"}, 2, "give one of the two"},
        Mistake{"NoFile", {"--measured", "nix.csv"}, 3, "nix.csv: cannot be opened"},
        Mistake{"NoFileOfAFilm", {"--measured", "nix.csv", "--mechanism", "film"}, 2, "nix.csv: cannot be opened"},
        Mistake{"TooManyPicks", {"--measured", gold_beetle, "--picks", "30"}, 2, "has 12 angles"},
        Mistake{"MeasuredGrating",
                {"--measured", gold_beetle, "--mechanism", "grating", "--with", "profile = \"lamellar\""},
                2,
                "measured spectra describe mirror reflection"},
        Mistake{"WithMeasuredPalette", {"--measured", gold_beetle, "--with", "shape = 0.3"}, 2, "leave --with out"},
        Mistake{"WithTwice", with(blue_film, {"--with", "index = 1.3", "--with", "index=1.4"}), 2,
                "--with index is given twice"},
        Mistake{"WithOfTwoLines", with(blue_film, {"--with", "index = 1.3\n[light]"}), 2, "is not a key and a value"},
        Mistake{"WithoutQuotes", with(blue_film, {"--with", "index = water"}), 2, "put text in quotes"},
        Mistake{"NoSuchMechanism",
                {"#2c6@0", "--mechanism", "auto", "--choose", "6"},
                2,
                "--choose 6: the answers are 1 to 5; give one of these numbers"},
        Mistake{"AutoOfMeasured",
                {"--measured", gold_beetle, "--mechanism", "auto"},
                2,
                "compares what mechanisms make of colours"},
        Mistake{"AutoWithAKey",
                {"#2c6@0", "--mechanism", "auto", "--with", "index = 1.3"},
                2,
                "each mechanism has keys of its own; name one of palette, film, stack, grating, crystal"},
        Mistake{
            "ChooseOfAPalette", {"#2c6@0", "#2c9@40", "--choose", "2"}, 2, "--choose: a palette is the only answer"},
        Mistake{"PicksOfNothingMeasured", {"#2c6@0", "#2c9@40", "--picks", "3"}, 2, "--picks sets the number"},
        Mistake{"NoPng", {"#2c6@0", "#2c9@40", "--swatch", "a.jpg"}, 2, "end its name in .png"},
        Mistake{"UnknownSpace", with(blue_film, {"--space", "lin_rec907"}), 2, "lin_rec907"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

}  // namespace
}  // namespace nacre::test
