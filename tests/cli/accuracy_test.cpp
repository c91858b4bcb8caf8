// Accuracy as a user asks for it, and what is said of it. That the numbers are true is accuracy_contract_test.cpp's.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/image/lut_file.h"
#include "support/program.h"

namespace nacre::test {
namespace {

constexpr const char* morpho =
    "[material.morpho]\n"
    "shape = 0.26\n"
    "picks = [ { angle_deg = 0,  peak_nm = 460, width_nm = 70, height = 1.0 },\n"
    "          { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n";

ProgramResult run(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
    return run_nacre(arguments, {folder.path(), {}, {}, {}});
}

ProgramResult bake(const TemporaryFolder& folder, const std::string& scene, std::vector<std::string> more) {
    folder.file("s.toml", scene);
    std::vector<std::string> arguments{"bake", "s.toml", "-o", "out", "--no-preview"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(folder, arguments);
}

TEST(Accuracy, AskedAndReachedStandInHeaderManifestAndSummary) {
    const TemporaryFolder folder;
    const ProgramResult result = bake(folder, morpho, {"--accuracy", "0.5"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const LutHeader header = read_lut((folder.path() / "out/morpho.exr").string()).header;
    EXPECT_EQ(header.value("accuracyAsked"), "0.5");
    const double reached = std::stod(header.value("accuracyReached"));
    EXPECT_GT(reached, 0.1);
    EXPECT_LE(reached, 0.5);
    const auto accuracy = nlohmann::json::parse(file_bytes(folder.path() / "out/morpho.json"))["accuracy"];
    EXPECT_EQ(accuracy["max_de00"], 0.5);
    EXPECT_EQ(accuracy["reached"], reached);
    EXPECT_NEAR(accuracy["predicted"].get<double>(), reached, 0.01 * reached);
    EXPECT_NE(result.out.find("morpho.exr  128 x 1 half  lin_rec709 (config nacre)  dE00 0.41 of 0.5"),
              std::string::npos)
        << result.out;
}

TEST(Accuracy, TheOptionWinsOverTheSceneAndTheSceneOverTheDefault) {
    const TemporaryFolder folder;
    const std::string scene = std::string("[accuracy]\nmax_de00 = 1\n") + morpho;
    ASSERT_EQ(bake(folder, scene, {}).exit_code, 0);
    EXPECT_EQ(read_lut((folder.path() / "out/morpho.exr").string()).header.value("accuracyAsked"), "1");
    ASSERT_EQ(bake(folder, scene, {"--accuracy", "0.05"}).exit_code, 0);
    EXPECT_EQ(read_lut((folder.path() / "out/morpho.exr").string()).header.value("accuracyAsked"), "0.05");
    ASSERT_EQ(bake(folder, morpho, {}).exit_code, 0);
    EXPECT_EQ(read_lut((folder.path() / "out/morpho.exr").string()).header.value("accuracyAsked"), "0.1");
}

struct OutOfReach {
    const char* name;
    const char* scene;  // before the material
    const char* lut;    // after it
    const char* bound;
    const char* message;
};

class AccuracyOutOfReach : public testing::TestWithParam<OutOfReach> {};

TEST_P(AccuracyOutOfReach, SaysWhatStandsInTheWayWithExitCode4AndWritesNothing) {
    const TemporaryFolder folder;
    const ProgramResult result =
        bake(folder, std::string(GetParam().scene) + morpho + GetParam().lut, {"--accuracy", GetParam().bound});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err,
              std::string("nacre: s.toml:") + GetParam().message +
                  "\nnacre: nothing was written; --best-effort writes the most accurate LUTs that nacre found\n");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

TEST_P(AccuracyOutOfReach, IsWrittenWithAWarningUnderBestEffort) {
    const TemporaryFolder folder;
    const ProgramResult result = bake(folder, std::string(GetParam().scene) + morpho + GetParam().lut,
                                      {"--accuracy", GetParam().bound, "--best-effort"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find(std::string("nacre: warning: s.toml:") + GetParam().message), std::string::npos)
        << result.err;
    const LutHeader header = read_lut((folder.path() / "out/morpho.exr").string()).header;
    EXPECT_EQ(header.value("accuracyAsked"), GetParam().bound);
    EXPECT_GT(std::stod(header.value("accuracyReached")), std::stod(GetParam().bound));
    EXPECT_EQ(run(folder, {"verify", "out/morpho.exr"}).exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Obstacles, AccuracyOutOfReach,
    testing::Values(
        OutOfReach{
            "Half", "", "[lut.morpho]\nformat = \"half\"\n", "0.02",
            "5:6 morpho: max_de00 = 0.02 cannot be reached; the best is 0.0685, with 512 x 1 half: half costs 0.069: "
            "use float"},
        OutOfReach{
            "Size", "[accuracy]\nsize = 64\n", "", "0.5",
            "3:11 morpho: max_de00 = 0.5 cannot be reached; the best is 1.69, with 64 x 1 half: interpolation between "
            "64 x 1 texels costs 1.7: leave size out, or give a larger one"},
        OutOfReach{
            "Wavelengths", "[accuracy]\nwavelengths = 48\n", "", "0.5",
            "3:11 morpho: max_de00 = 0.5 cannot be reached; the best is 1.34, with 128 x 1 half: 48 wavelengths cost "
            "1.4: leave wavelengths out"},
        OutOfReach{"Everything", "", "", "1e-05",
                   "1:11 morpho: max_de00 = 1e-05 cannot be reached; the best is 2.55e-05, with 16384 x 1 float: "
                   "interpolation between 16384 x 1 texels costs 2.5e-05, and 16384 texels are the most that nacre "
                   "tries: give a larger bound"}),
    [](const auto& parameters) { return std::string(parameters.param.name); });

TEST(Accuracy, OneLutOutOfReachLeavesAllUnwritten) {
    const TemporaryFolder folder;
    const std::string scene = std::string(morpho) + "[lut.good]\n[lut.bad]\nsize = 4\n";
    const ProgramResult result = bake(folder, scene, {"--accuracy", "0.5"});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
    EXPECT_EQ(bake(folder, scene, {"--accuracy", "0.5", "--only", "good"}).exit_code, 0);
}

TEST(Accuracy, WhoGivesASizeAndNoBoundGetsWhatHeAskedForAndIsToldTheError) {
    const TemporaryFolder folder;
    const ProgramResult result = bake(folder, std::string("[accuracy]\nsize = 16\n") + morpho, {});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out.find("morpho.exr  16 x 1 half  lin_rec709 (config nacre)  dE00 20  "), 0U) << result.out;
    EXPECT_EQ(read_lut((folder.path() / "out/morpho.exr").string()).header.value("accuracyAsked"), "none");
    const auto manifest = nlohmann::json::parse(file_bytes(folder.path() / "out/morpho.json"));
    EXPECT_TRUE(manifest["accuracy"]["max_de00"].is_null());
}

// Encoded texels are filtered before a shader decodes them: that error counts too.
TEST(Accuracy, HoldsForEncodedSpacesAndGamutRules) {
    for (const char* colour : {"space = \"acescct_ap1\"", "space = \"srgb_rec709\"", "gamut = \"clip\"",
                               "gamut = \"compress\"", "space = \"lin_ap1\""}) {
        const TemporaryFolder folder;
        const ProgramResult result = bake(folder, std::string("[colour]\n") + colour + "\n" + morpho, {});
        ASSERT_EQ(result.exit_code, 0) << colour << result.err;
        const auto manifest = nlohmann::json::parse(file_bytes(folder.path() / "out/morpho.json"));
        EXPECT_LE(manifest["accuracy"]["reached"].get<double>(), 0.1) << colour;
        EXPECT_GT(manifest["accuracy"]["reached"].get<double>(), 0.01) << colour;
    }
}

TEST(Verify, ReportsTheErrorOfWhatAShaderFetchesAndNoticesAFalsePromise) {
    const TemporaryFolder folder;
    ASSERT_EQ(bake(folder, morpho, {}).exit_code, 0);
    const std::string path = (folder.path() / "out/morpho.exr").string();
    EXPECT_EQ(run(folder, {"verify", "out/morpho.exr"}).out,
              "out/morpho.exr: verified: header complete, 512 texels equal a re-bake, dE00 up to 0.069\n");
    StoredLut lut = read_lut(path);
    for (auto& [name, value] : lut.header.nacre) {
        if (name == "accuracyReached") value = "0.01";
    }
    folder.file("out/morpho.exr", encode_lut(lut.image, lut.format, lut.header));
    const ProgramResult result = run(folder, {"verify", "out/morpho.exr"});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_NE(result.out.find("contradicts its scene in nacre:accuracyReached"), std::string::npos) << result.out;
}

TEST(Plan, IsATableOfWhatWillBeBakedAndWritesNothing) {
    const TemporaryFolder folder;
    folder.file("s.toml",
                std::string(morpho) + "[lut.one]\n[lut.two]\ny = { parameter = \"height\", from = 0, to = 1 }\n");
    const ProgramResult result = run(folder, {"plan", "s.toml", "--accuracy", "0.5"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    std::istringstream lines(result.out);
    std::string heading, one, two, line;
    std::getline(lines, heading);
    std::getline(lines, one);
    std::getline(lines, two);
    std::vector<std::string> absent;
    std::vector<std::string> errors;
    std::vector<std::string> notes;
    while (std::getline(lines, line)) {
        // Notes of clamped picks are prose, which may wrap anywhere.
        EXPECT_TRUE(line.size() <= 100 || line.starts_with("morpho: ")) << "does not fit a terminal: " << line;
        if (line.starts_with("effects not in "))
            absent.push_back(line);
        else if (line.starts_with("    ") && !absent.empty())
            absent.back() += line.substr(3);
        if (line.starts_with("errors of ")) errors.push_back(line);
        if (line.empty()) notes.clear();
        if (!line.empty()) notes.push_back(line);
    }
    for (const char* word : {"LUT", "axes", "texels", "format", "integral", "expected dE00", "bake time"})
        EXPECT_NE(heading.find(word), std::string::npos) << word;
    ASSERT_EQ(errors.size(), 2U);
    EXPECT_TRUE(errors.front().starts_with("errors of one: interpolation 0.")) << errors.front();
    EXPECT_NE(errors.front().find(", storage 0."), std::string::npos) << errors.front();
    EXPECT_EQ(one.find("one  sqrt_cos_theta"), 0U) << one;
    EXPECT_NE(one.find("128 x 1  half    exact       0.40 of 0.5"), std::string::npos) << one;
    EXPECT_NE(two.find("height 0 to 1"), std::string::npos) << two;
    const std::string every =
        ": dispersion, absorption, polarisation, incoherent_layers, thickness_spread, base, tilt, roughness, "
        "higher_orders, "
        "size_spread";
    EXPECT_EQ(absent, (std::vector<std::string>{"effects not in one" + every, "effects not in two" + every}));
    EXPECT_EQ(notes, (std::vector<std::string>{
                         "morpho: clamped above 85 deg, where its picks lead to a number outside its range",
                         "one.preview.png: preview", "two.preview.png: preview"}));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.toml"});
}

TEST(Plan, JsonSaysTheSameAsTheBakeThatFollows) {
    const TemporaryFolder folder;
    const std::string scene =
        std::string(morpho) +
        "[lut.one]\n[lut.two]\nx = \"theta_deg\"\ny = { parameter = \"width_nm\", from = 50, to = 90 }\n";
    folder.file("s.toml", scene);
    const ProgramResult planned = run(folder, {"plan", "s.toml", "--json"});
    ASSERT_EQ(planned.exit_code, 0) << planned.err;
    const auto plan = nlohmann::json::parse(planned.out)["luts"];
    const auto baked = nlohmann::json::parse(bake(folder, scene, {"--json"}).out)["luts"];
    ASSERT_EQ(plan.size(), 2U);
    ASSERT_EQ(baked.size(), 2U);
    for (std::size_t i = 0; i < plan.size(); ++i) {
        for (const char* key : {"lut", "material", "mechanism", "x", "width", "height", "format"})
            EXPECT_EQ(plan[i][key], baked[i][key]) << key;
        EXPECT_EQ(plan[i]["max_de00"], baked[i]["accuracy"]["max_de00"]);
        EXPECT_TRUE(plan[i]["reached"].get<bool>());
        // Work is counted, not timed: a plan knows it to the last integral.
        EXPECT_EQ(plan[i]["work"], baked[i]["work"]);
        const double predicted = plan[i]["predicted"]["de00"].get<double>();
        const double reached = baked[i]["accuracy"]["reached"].get<double>();
        EXPECT_GT(predicted, 0.5 * reached);
        EXPECT_LT(predicted, 2.0 * reached);
        const auto& split = plan[i]["predicted"];
        EXPECT_LE(predicted, 1.01 * (split["spectrum"].get<double>() + split["interpolation"].get<double>() +
                                     split["storage"].get<double>()));
        EXPECT_GT(plan[i]["seconds"]["baking"].get<double>(), 0.0);
    }
}

TEST(Plan, ABoundOutOfReachIsExitCode4) {
    const TemporaryFolder folder;
    folder.file("s.toml", morpho);
    const ProgramResult result = run(folder, {"plan", "s.toml", "--accuracy", "0.00001"});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_NE(result.out.find("16384 x 1  float"), std::string::npos) << result.out;
    EXPECT_NE(result.err.find("max_de00 = 1e-05 cannot be reached"), std::string::npos) << result.err;
}

TEST(Plan, AndBakeSayThatALutIsWiderThanSomeDevicesTake) {
    const TemporaryFolder folder;
    folder.file("s.toml", morpho);
    const std::string wide = "wider than 4096, which is more than some phones and browsers take";
    const ProgramResult plan = run(folder, {"plan", "s.toml", "--accuracy", "0.0001"});
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_NE(plan.out.find("\nmorpho: " + wide + "; a larger bound needs fewer texels\n"), std::string::npos)
        << plan.out;
    const ProgramResult baked = bake(folder, morpho, {"--accuracy", "0.0001"});
    EXPECT_EQ(baked.exit_code, 0) << baked.err;
    EXPECT_NE(baked.out.find("morpho.exr  16384 x 1 float"), std::string::npos) << baked.out;
    EXPECT_NE(baked.out.find("  " + wide), std::string::npos) << baked.out;
    EXPECT_EQ(run(folder, {"verify", "out/morpho.exr"}).exit_code, 0);
    EXPECT_EQ(run(folder, {"plan", "s.toml", "--accuracy", "0.001"}).out.find("wider"), std::string::npos);
}

TEST(Plan, AnUnknownLutIsAnErrorThatNamesTheKnown) {
    const TemporaryFolder folder;
    folder.file("s.toml", morpho);
    const ProgramResult result = run(folder, {"plan", "s.toml", "--only", "morfo"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "nacre: --only \"morfo\": the scenes have no LUT or swatch of that name; known: morpho\n");
}

TEST(Cost, SweepsBoundsMethodsAndSizesAsTableCsvAndPicture) {
    const TemporaryFolder folder;
    folder.file("s.toml", morpho);
    const ProgramResult result = run(folder, {"cost", "s.toml", "-o", "out", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["lut"], "morpho");
    EXPECT_EQ(json["max_de00"], 0.1);
    const auto de00_of = [&](const std::string& family, const std::string& label, const std::string& axis,
                             const std::string& format) {
        for (const auto& entry : json["cases"]) {
            if (entry["family"] == family && entry["label"] == label && entry["axis"] == axis &&
                entry["format"] == format)
                return entry["de00"].get<double>();
        }
        ADD_FAILURE() << family << " " << label << " " << axis << " " << format << " is missing";
        return 0.0;
    };
    for (const auto& entry : json["cases"]) {
        const auto computing = entry["computing_seconds"].get<double>();
        const auto deciding = entry["deciding_seconds"].get<double>();
        const auto measuring = entry["measuring_seconds"].get<double>();
        EXPECT_GT(computing, 0.0) << entry;
        EXPECT_GT(measuring, 0.0) << entry << ": every way is checked";
        EXPECT_EQ(deciding > 0.0, entry["family"] == "choice") << entry << ": a palette has no sampling to decide on";
        EXPECT_DOUBLE_EQ(entry["all_seconds"].get<double>(), computing + deciding + measuring) << entry;
        if (entry["family"] == "choice") {
            EXPECT_LE(entry["de00"].get<double>(), entry["max_de00"].get<double>());
        }
    }
    // What the methods are known for: finer sums err less, and fits of the observer more than any of its tables.
    const std::string x = "sqrt_cos_theta";
    double last = de00_of("integral", "exact integral", x, "float");
    for (const char* sum : {"1 nm sum", "2 nm sum", "5 nm sum", "10 nm sum", "20 nm sum"}) {
        EXPECT_GT(de00_of("integral", sum, x, "float"), last) << sum;
        last = de00_of("integral", sum, x, "float");
    }
    EXPECT_GT(de00_of("integral", "Wyman fit at 5 nm", x, "float"), de00_of("integral", "5 nm sum", x, "float"));
    EXPECT_GT(de00_of("integral", "three wavelengths", x, "float"), 10.0);
    for (const char* axis : {"sqrt_cos_theta", "cos_theta", "theta_deg"}) {
        for (const char* size : {"32", "64", "128", "256", "512", "1024"}) {
            de00_of("fixed_size", size, axis, "half");
            de00_of("fixed_size", size, axis, "float");
        }
    }
    for (const char* mistake : {"none of these", "5 nm sum", "half texel missing"})
        de00_of("mistake", mistake, x, "half");
    de00_of("mistake", "8-bit sRGB texture", x, "8 bit");
    de00_of("mistake", "cosine axis", "cos_theta", "half");

    EXPECT_EQ(file_bytes(folder.path() / "out/morpho_cost.png").substr(1, 3), "PNG");
    std::istringstream csv(file_bytes(folder.path() / "out/morpho_cost.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line.find("# What accuracy costs: LUT morpho"), 0U);
    std::getline(csv, line);
    const auto columns = std::count(line.begin(), line.end(), ',');
    std::size_t rows = 0;
    for (; std::getline(csv, line); ++rows) EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
    EXPECT_EQ(rows, json["cases"].size());
}

TEST(Cost, WithoutAFolderItWritesNothing) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string("[accuracy]\nsize = [32, 8]\n") + morpho +
                              "[lut.two]\ny = { parameter = \"height\", from = 0.2, to = 1 }\n");
    const ProgramResult result = run(folder, {"cost", "s.toml", "--lut", "two", "--accuracy", "2"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("from spectrum to XYZ"), std::string::npos);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"s.toml"});
    const ProgramResult wrong = run(folder, {"cost", "s.toml", "--lut", "three"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_EQ(wrong.err, "nacre: --lut \"three\": the scene has no LUT of that name; known: two\n");
}

}  // namespace
}  // namespace nacre::test
