// The accuracy contract, judged by a second road: what `nacre bake --accuracy DE` writes is fetched as a shader would,
// between texels too, and compared with tests/reference/model.h, which shares no line with src/.
// NACRE_ACCURACY_SWEEP=0 takes the first of the random scenes only, so that it ends in seconds under sanitizers too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "reference/lut.h"
#include "reference/model.h"
#include "reference/paper_scenes.h"
#include "reference/random_scenes.h"
#include "support/program.h"
#include "support/written_lut.h"

namespace nacre::test {
namespace {

using reference::Density;
using reference::FixedLut;
using reference::Model;
using reference::ModelScene;
using reference::Pixels;
using reference::StoredAs;

// What the manifest calls things; everything about accuracy lies in one object.
namespace keys {
constexpr const char* accuracy = "accuracy";
constexpr const char* asked = "max_de00";
constexpr const char* predicted = "predicted";
constexpr const char* reached = "reached";
}  // namespace keys

constexpr int largest_size = 16384;
// Below it a LUT with two axes may take millions of texels.
constexpr double smallest_budget_of_two_axes = 0.1;
// A prediction is held against what was measured only if either matters: a constant LUT may be predicted as it likes.
constexpr double negligible_share = 0.05;
constexpr double largest_misprediction = 2.0;
// A refusal is wrong only where the largest LUT keeps the budget beyond doubt: at a kink of the model two judges that
// look at different points differ by some percent.
constexpr double beyond_doubt = 0.9;
// A size that the program passed over may keep the budget by a hair, or seem to where ten points per cell miss a bend.
constexpr double clearly = 0.9;

bool is_sweep() {
    const char* value = std::getenv("NACRE_ACCURACY_SWEEP");
    return value == nullptr || std::string(value) != "0";
}

// ---- Scenes ----

// The first ones and two whose second axis needs texels; all of them in a sweep.
std::vector<ModelScene> scenes_for(double budget) {
    constexpr std::array early_pair{119, 139};
    std::vector<ModelScene> chosen;
    int index = 0;
    for (const ModelScene& scene : reference::random_palettes()) {
        const bool early = index < 22 || std::find(early_pair.begin(), early_pair.end(), index) != early_pair.end();
        ++index;
        if (!is_sweep() && !early) continue;
        if (scene.y && budget < smallest_budget_of_two_axes) continue;
        chosen.push_back(scene);
    }
    return chosen;
}

// A scene that ships, its sizes left to the program.
std::string shipped_text(const std::string& name) {
    std::istringstream lines(file_bytes(std::string(NACRE_SOURCE_DIR) + "/configs/scenes/" + name + ".toml"));
    std::string text;
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("size", 0) != 0) text += line + "\n";
    return text;
}

// ---- What the program wrote ----

struct Verdict {
    std::string name;
    bool is_refused = false;
    bool is_float = false;
    std::size_t texels = 0;
    double measured = 0.0, predicted = 0.0, reached = 0.0;
};

// At least ten points per cell, and enough in all that a small LUT is not asked at a few points alone.
Density density_for(const Pixels& lut) {
    Density density;
    const int longest = std::max(lut.width, lut.height);
    if (lut.height == 1) {
        density.oversample = std::max(10, 4000 / (lut.width - 1));
    } else {
        density.oversample = std::max(4, 96 / (longest - 1));
        density.most_points = is_sweep() ? 4000000 : 400000;
    }
    return density;
}

reference::ColourAt colours_of(const Model& model) {
    return [&model](double x, double y) { return model.at(x, y); };
}

bool would_do(const Model& model, int width, int height, StoredAs format, double budget) {
    const Pixels lut = reference::make_lut(colours_of(model), width, height, format);
    Density density = density_for(lut);
    density.enough = budget;
    if (reference::dense_error(lut, colours_of(model), density) > budget) return false;
    if (height == 1) return true;
    // Some cells of a LUT with two axes kept the budget: look at all before the program is accused.
    density.most_points = Density{}.most_points;
    return reference::dense_error(lut, colours_of(model), density) <= budget;
}

// Within a factor of two of the fewest texels: a quarter of them must not do, however it is shaped.
void expect_quarter_is_too_small(const Model& model, const WrittenLut& lut, double budget) {
    const int width = lut.pixels.width, height = lut.pixels.height;
    std::vector<std::pair<int, int>> quarters{{width / 4, height}};
    if (height > 1) quarters.insert(quarters.end(), {{width / 2, height / 2}, {width, height / 4}});
    for (const auto& [w, h] : quarters) {
        if (w < 2 || h < (height > 1 ? 2 : 1)) continue;
        EXPECT_FALSE(would_do(model, w, h, lut.format, clearly * budget))
            << "wrote " << width << " x " << height << " where " << w << " x " << h << " keeps the budget";
    }
}

void expect_refusal_is_right(const ModelScene& scene, double budget) {
    if (scene.y) return;  // 4096 x 4096 texels to show it
    EXPECT_FALSE(would_do(Model(scene), largest_size, 1, StoredAs::single_float, beyond_doubt * budget))
        << "refused, but " << largest_size << " texels of float keep the budget";
}

void read_accuracy(const nlohmann::json& manifest, double budget, Verdict& verdict) {
    ASSERT_TRUE(manifest.contains(keys::accuracy)) << "the manifest has no \"" << keys::accuracy << '"';
    const auto& accuracy = manifest[keys::accuracy];
    for (const char* key : {keys::asked, keys::predicted, keys::reached})
        ASSERT_TRUE(accuracy.contains(key)) << keys::accuracy << " has no \"" << key << '"';
    EXPECT_EQ(accuracy[keys::asked].get<double>(), budget);
    verdict.predicted = accuracy[keys::predicted].get<double>();
    verdict.reached = accuracy[keys::reached].get<double>();
    verdict.is_refused = verdict.reached > budget;
}

void expect_manifest_describes(const nlohmann::json& manifest, const WrittenLut& lut) {
    EXPECT_EQ(manifest.value("width", 0), lut.pixels.width);
    EXPECT_EQ(manifest.value("height", 0), lut.pixels.height);
    EXPECT_EQ(manifest.value("format", ""), lut.format_name());
    for (const int side : {lut.pixels.width, lut.pixels.height}) {
        EXPECT_LE(side, largest_size);
        EXPECT_EQ(side & (side - 1), 0) << side << " is no power of two";
    }
}

// Measured and predicted error of one LUT against the contract. A LUT that is not there was refused.
Verdict judge(const std::filesystem::path& folder, const ModelScene& scene, double budget) {
    SCOPED_TRACE("budget " + std::to_string(budget) + "\n" + reference::scene_text(scene));
    Verdict verdict;
    verdict.name = scene.name;
    const auto lut = read_written_lut(folder / (scene.name + ".exr"));
    const std::string text = file_bytes(folder / (scene.name + ".json"));
    if (!lut || text.empty()) {
        EXPECT_EQ(lut.has_value(), !text.empty()) << "one file without the other";
        verdict.is_refused = true;
        expect_refusal_is_right(scene, budget);
        return verdict;
    }
    const auto manifest = nlohmann::json::parse(text);
    expect_manifest_describes(manifest, *lut);
    read_accuracy(manifest, budget, verdict);
    verdict.is_float = lut->format == StoredAs::single_float;
    verdict.texels = lut->pixels.rgb.size();

    const Model model(scene);
    verdict.measured = reference::dense_error(lut->pixels, colours_of(model), density_for(lut->pixels));
    if (verdict.is_refused) {
        expect_refusal_is_right(scene, budget);
        return verdict;
    }
    EXPECT_LE(verdict.measured, budget);
    const double floor = negligible_share * budget;
    const double ratio = std::max(verdict.predicted, floor) / std::max(verdict.measured, floor);
    EXPECT_LE(ratio, largest_misprediction) << "predicted " << verdict.predicted << ", is " << verdict.measured;
    EXPECT_GE(ratio, 1.0 / largest_misprediction) << "predicted " << verdict.predicted << ", is " << verdict.measured;
    expect_quarter_is_too_small(model, *lut, budget);
    return verdict;
}

// ---- Summary: one line per budget ----

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    std::string lowest, highest;

    void add(double value, const std::string& name) {
        if (value < low) low = value, lowest = name;
        if (value > high) high = value, highest = name;
    }
};

std::ostream& operator<<(std::ostream& out, const Range& range) {
    if (range.lowest.empty()) return out << "-";
    return out << range.low << " (" << range.lowest << ") to " << range.high << " (" << range.highest << ")";
}

void print_summary(double budget, const std::vector<Verdict>& verdicts, double bake_seconds) {
    Range share, predicted, reached;
    std::size_t refused = 0, floats = 0, texels = 0;
    for (const Verdict& verdict : verdicts) {
        refused += verdict.is_refused ? 1 : 0;
        if (verdict.is_refused) continue;
        floats += verdict.is_float ? 1 : 0;
        texels += verdict.texels;
        share.add(verdict.measured / budget, verdict.name);
        if (verdict.measured < negligible_share * budget) continue;
        predicted.add(verdict.predicted / verdict.measured, verdict.name);
        reached.add(verdict.reached / verdict.measured, verdict.name);
    }
    std::ostringstream line;
    line.precision(3);
    line << "[ ACCURACY ] DE " << budget << ": " << verdicts.size() << " LUTs, " << refused << " refused, " << floats
         << " float, " << texels << " texels; measured/budget up to " << share.high << " (" << share.highest
         << "); predicted/measured " << predicted << "; reached/measured " << reached << "; baked in " << bake_seconds
         << " s";
    std::cout << line.str() << std::endl;
}

// The shortest text that a person would type.
std::string text_of(double number) {
    std::ostringstream text;
    text << number;
    return text.str();
}

// Bakes files into out/ and judges every scene of theirs.
void bake_and_judge(const TemporaryFolder& folder, const std::vector<std::string>& files,
                    const std::vector<ModelScene>& scenes, double budget) {
    std::vector<std::string> arguments{"bake"};
    arguments.insert(arguments.end(), files.begin(), files.end());
    arguments.insert(arguments.end(),
                     {"-o", "out", "--accuracy", text_of(budget), "--best-effort", "--no-preview", "--quiet"});
    for (const ModelScene& scene : scenes) arguments.insert(arguments.end(), {"--only", scene.name});
    const auto start = std::chrono::steady_clock::now();
    const ProgramResult result = run_nacre(arguments, {folder.path(), {}, {}, {}});
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    ASSERT_TRUE(result.exit_code == 0 || result.exit_code == 4) << result.exit_code << ": " << result.err;

    std::vector<Verdict> verdicts;
    for (const ModelScene& scene : scenes) verdicts.push_back(judge(folder.path() / "out", scene, budget));
    print_summary(budget, verdicts, elapsed.count());
    if (result.exit_code == 4) {
        EXPECT_TRUE(std::any_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.is_refused; }))
            << "exit 4, but every LUT keeps its budget: " << result.err;
    }
}

// ---- The judge is judged first ----

TEST(ReferencePaletteInFiles, TexelsOfAFixedSizeAreWhatItSays) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments{"bake"};
    std::vector<ModelScene> scenes = scenes_for(1.0);
    for (const ModelScene& scene : scenes) {
        const FixedLut fixed{32, scene.y ? 8 : 1, StoredAs::single_float};
        arguments.push_back(folder.file(scene.name + ".toml", reference::scene_text(scene, fixed)));
    }
    arguments.insert(arguments.end(), {"-o", "out", "--no-preview"});
    const ProgramResult result = run_nacre(arguments, {folder.path(), {}, {}, {}});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const ModelScene& scene : scenes) {
        const auto written = read_written_lut(folder.path() / "out" / (scene.name + ".exr"));
        ASSERT_TRUE(written) << scene.name;
        const Model model(scene);
        const Pixels own = reference::make_lut(colours_of(model), 32, scene.y ? 8 : 1, StoredAs::single_float);
        ASSERT_EQ(written->pixels.rgb.size(), own.rgb.size()) << scene.name;
        // Single precision.
        for (std::size_t i = 0; i < own.rgb.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(written->pixels.rgb[i][c], own.rgb[i][c], 1e-5) << scene.name;
    }
}

TEST(ReferencePaletteInFiles, LinearFilterErrsWithTheSquareOfTheStep) {
    // Measured in files: a fetch that were half a texel off would err with the step itself.
    const TemporaryFolder folder;
    const Model model(reference::paper_morpho());
    std::vector<double> errors;
    for (const int width : {256, 512}) {
        folder.file("s.toml",
                    reference::scene_text(reference::paper_morpho(), FixedLut{width, 1, StoredAs::single_float}));
        ASSERT_EQ(run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, {folder.path(), {}, {}, {}}).exit_code, 0);
        const auto lut = read_written_lut(folder.path() / "out/morpho.exr");
        ASSERT_TRUE(lut);
        errors.push_back(reference::dense_error(lut->pixels, colours_of(model), {}));
    }
    EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.2);
}

// ---- The contract ----

class AccuracyContract : public testing::TestWithParam<double> {};

TEST_P(AccuracyContract, NoFetchIsFartherFromTheModelThanWasAsked) {
    const TemporaryFolder folder;
    const std::vector<ModelScene> scenes = scenes_for(GetParam());
    std::vector<std::string> files;
    for (const ModelScene& scene : scenes)
        files.push_back(folder.file(scene.name + ".toml", reference::scene_text(scene)));
    bake_and_judge(folder, files, scenes, GetParam());
}

TEST_P(AccuracyContract, HoldsForTheScenesThatShip) {
    const TemporaryFolder folder;
    const std::vector<std::string> files{folder.file("morpho.toml", shipped_text("morpho")),
                                         folder.file("beetle.toml", shipped_text("beetle"))};
    std::vector<ModelScene> scenes{reference::paper_morpho(), reference::paper_beetle()};
    if (GetParam() >= smallest_budget_of_two_axes) scenes.push_back(reference::paper_morpho_width());
    bake_and_judge(folder, files, scenes, GetParam());
}

std::string name_of_budget(const testing::TestParamInfo<double>& info) {
    std::string name = "De" + text_of(info.param);
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Budgets, AccuracyContract, testing::Values(2.0, 1.0, 0.5, 0.1, 0.02, 0.005), name_of_budget);

TEST(AccuracyContractRefusal, UnreachableBudgetExitsWith4AndWritesNothingUnlessBestEffortIsAsked) {
    // A third of what 16384 texels can do.
    const TemporaryFolder folder;
    folder.file("s.toml", reference::scene_text(reference::paper_morpho()) + "[lut.other]\nmaterial = \"morpho\"\n");
    const std::vector<std::string> arguments{"bake", "s.toml", "-o", "out", "--accuracy", "0.00001"};
    const ProgramResult result = run_nacre(arguments, {folder.path(), {}, {}, {}});
    EXPECT_EQ(result.exit_code, 4) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/morpho.exr"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/other.exr"));
}

}  // namespace
}  // namespace nacre::test
