// The accuracy contract of films and stacks, judged by a second road: what `nacre bake --accuracy DE` writes is fetched
// as a shader would, between texels too, and compared with tests/reference/model.h, which shares no line with
// src/. NACRE_LAYERED_SWEEP=1 takes all 200 random scenes, NACRE_LAYERED_SWEEP=0 a few, so that sanitizers end in
// seconds. Of every fourth what is seen through it comes first.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "reference/lut.h"
#include "reference/model.h"
#include "reference/random_scenes.h"
#include "support/program.h"
#include "support/written_lut.h"

namespace nacre::test {
namespace {

using reference::Model;
using reference::ModelScene;
using reference::Pixels;

// The program measures at fewer points than all: a random one may err more than the worst that it met, by a little.
constexpr double share_beyond_reached = 1.05;
// Digits of the header, and what the judge's own sum may err by.
constexpr double judges_share = 0.02;

// Films beyond it take the program ten seconds each: they are for the sweep.
constexpr double thickest_of_normal_run_nm = 20000.0;

bool is_too_thick(const ModelScene& scene) {
    const auto* film = std::get_if<Film>(&scene.mechanism);
    return film != nullptr && film->thickness_nm > thickest_of_normal_run_nm;
}

std::vector<ModelScene> scenes_of_this_run() {
    std::vector<ModelScene> all = reference::random_layers();
    for (std::size_t i = all.size(); i-- > 0;) {
        if (i % 4 == 0) all.insert(all.begin() + static_cast<std::ptrdiff_t>(i), *reference::seen_through(all[i]));
    }
    const char* sweep = std::getenv("NACRE_LAYERED_SWEEP");
    if (sweep != nullptr && std::string(sweep) == "1") return all;
    all.erase(std::remove_if(all.begin(), all.end(), is_too_thick), all.end());
    all.resize(sweep != nullptr && std::string(sweep) == "0" ? 8 : 30);
    return all;
}

// ---- The judge ----

struct Point {
    double x = 0.0, y = 0.0, error = 0.0;
};

class Judge {
public:
    Judge(const WrittenLut& lut, const ModelScene& scene)
        : lut_(lut.pixels),
          scale_(scale_of(lut.pixels)),
          model_(scene, 0.5 * judges_share * scene.max_de00, scale_),
          critical_(critical_coordinates(scene)) {}

    // Random coordinates, a third of them towards grazing; the cells in which total reflection begins; and then the
    // neighbourhood of the worst.
    Point worst(double operations) {
        const auto count = static_cast<int>(std::clamp(operations / model_.cost(), 24.0, 400.0));
        std::vector<Point> points{look(0.0, random()), look(1.0, random())};
        for (int i = 0; i < count; ++i) points.push_back(look(i % 3 == 0 ? 0.3 * random() : random(), random()));
        for (const double x : critical()) {
            for (const double cells : {-0.5, -0.2, -0.05, 0.0, 0.05, 0.2, 0.5})
                points.push_back(look(std::clamp(x + cells / lut_.width, 0.0, 1.0), random()));
        }
        std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.error > b.error; });
        Point worst = points.front();
        for (std::size_t i = 0; i < 4; ++i) {
            for (int k = 0; k < std::max(2, count / 16); ++k) {
                const double step_x = (random() - 0.5) / lut_.width, step_y = (random() - 0.5) / lut_.height;
                const Point near =
                    look(std::clamp(points[i].x + step_x, 0.0, 1.0), std::clamp(points[i].y + step_y, 0.0, 1.0));
                if (near.error > worst.error) worst = near;
            }
        }
        return worst;
    }

    std::size_t unconverged() const { return model_.unconverged(); }

private:
    // At most so many, spread evenly.
    std::vector<double> critical() const {
        constexpr std::size_t most = 6;
        const std::vector<double>& all = critical_;
        if (all.size() <= most) return all;
        std::vector<double> some;
        for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * (all.size() - 1) / (most - 1)]);
        return some;
    }
    Point look(double x, double y) const { return {x, y, reference::error_at(lut_, scale_, x, y, model_.at(x, y))}; }
    // Weyl's sequence of the golden ratio's relatives would hit texels in step: a plain generator (Knuth, MMIX) does
    // not.
    double random() {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state_ >> 11U) * 0x1p-53;
    }

    const Pixels& lut_;
    double scale_ = 1.0;
    Model model_;
    std::vector<double> critical_;
    std::uint64_t state_ = 20260;
};

struct Tally {
    std::size_t luts = 0, refused = 0, violations = 0, unconverged = 0;
    double worst_share = 0.0, worst_of_reached = 0.0;
    std::string worst_name, worst_of_reached_name;
};

void judge(const std::filesystem::path& folder, const ModelScene& scene, Tally& tally) {
    const std::string& name = scene.name;
    SCOPED_TRACE("max_de00 " + std::to_string(scene.max_de00) + "\n" + reference::scene_text(scene));
    const auto lut = read_written_lut(folder / (name + ".exr"));
    ASSERT_TRUE(lut) << name << " was not written";
    ASSERT_GE(lut->reached, 0.0) << "the header has no nacre:accuracyReached";
    ++tally.luts;
    constexpr double operations = 6e6;  // about a third of a second
    Judge judge(*lut, scene);
    const Point worst = judge.worst(operations);
    tally.unconverged += judge.unconverged();
    const bool is_refused = lut->reached > scene.max_de00;
    tally.refused += is_refused ? 1 : 0;
    const double slack = judges_share * scene.max_de00;
    std::ostringstream what;
    what << name << ": " << worst.error << " of " << scene.max_de00 << ", reached " << lut->reached << " at ("
         << worst.x << ", " << worst.y << "), " << lut->pixels.width << " x " << lut->pixels.height << " "
         << lut->format_name() << ", " << judge.unconverged() << " points unconverged";
    if (!is_refused) {
        EXPECT_LE(worst.error, scene.max_de00 + slack) << what.str();
    }
    EXPECT_LE(worst.error, share_beyond_reached * lut->reached + slack) << what.str();
    const bool is_wrong = (!is_refused && worst.error > scene.max_de00 + slack) ||
                          worst.error > share_beyond_reached * lut->reached + slack;
    tally.violations += is_wrong ? 1 : 0;
    if (std::getenv("NACRE_ACCURACY_VERBOSE") != nullptr)
        std::cout << what.str() << (is_wrong ? "  WRONG" : "") << "\n";
    if (is_refused) return;
    const double share = worst.error / scene.max_de00;
    if (share > tally.worst_share) tally.worst_share = share, tally.worst_name = name;
    const double of_reached = worst.error / std::max(lut->reached, 0.1 * scene.max_de00);
    if (of_reached > tally.worst_of_reached) tally.worst_of_reached = of_reached, tally.worst_of_reached_name = name;
}

TEST(ReferenceLayersInFiles, GiveTheSpectrumThatTheProgramPrints) {
    const TemporaryFolder folder;
    const auto scenes = reference::random_layers();
    for (std::size_t i = 0; i < 60; i += 5) {
        const ModelScene& scene = scenes[i];
        folder.file("s.toml", reference::scene_text(scene));
        const ProgramResult result =
            run_nacre({"spectrum", "s.toml", "--material", scene.name, "--angle", "50"}, {folder.path(), {}, {}, {}});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        std::istringstream lines(result.out);
        std::string line;
        std::getline(lines, line);
        ASSERT_EQ(line, "material,angle_deg,wavelength_nm,R_s,R_p,R");
        std::size_t compared = 0;
        while (std::getline(lines, line)) {
            double nm = 0.0, reflectance = 0.0;
            ASSERT_EQ(std::sscanf(line.c_str(), "%*[^,],%*[^,],%lf,%*[^,],%*[^,],%lf", &nm, &reflectance), 2) << line;
            // Tables of k have digits, formulas none: 5e-5 of melanin's k is some 1e-6 here.
            ASSERT_NEAR(reference::reflectance(scene.mechanism, std::cos(std::numbers::pi * 50.0 / 180.0), nm),
                        reflectance, 1e-5)
                << nm << "\n"
                << reference::scene_text(scene);
            ++compared;
        }
        EXPECT_EQ(compared, 471u);
    }
}

// ---- The contract ----

TEST(LayeredAccuracyContract, NoFetchIsFartherFromTheModelThanWasAsked) {
    const TemporaryFolder folder;
    const std::vector<ModelScene> scenes = scenes_of_this_run();
    std::map<double, std::vector<std::string>> files;
    for (const ModelScene& scene : scenes) {
        const std::string& name = scene.name;
        files[scene.max_de00].push_back(folder.file(name + ".toml", reference::scene_text(scene)));
    }
    const auto start = std::chrono::steady_clock::now();
    for (const auto& [bound, of_bound] : files) {
        std::ostringstream text;
        text << bound;
        std::vector<std::string> arguments{"bake",          "-o",           "out",    "--accuracy", text.str(),
                                           "--best-effort", "--no-preview", "--quiet"};
        arguments.insert(arguments.end(), of_bound.begin(), of_bound.end());
        const ProgramResult result = run_nacre(arguments, {folder.path(), {}, {}, {}});
        ASSERT_TRUE(result.exit_code == 0 || result.exit_code == 4) << result.exit_code << ": " << result.err;
    }
    const std::chrono::duration<double> baked = std::chrono::steady_clock::now() - start;

    std::map<double, Tally> tallies;
    for (const ModelScene& scene : scenes) judge(folder.path() / "out", scene, tallies[scene.max_de00]);
    const std::chrono::duration<double> all = std::chrono::steady_clock::now() - start;
    for (const auto& [bound, tally] : tallies) {
        std::cout << "[ ACCURACY ] DE " << bound << ": " << tally.luts << " LUTs, " << tally.refused << " refused, "
                  << tally.violations << " wrong; measured/budget up to " << tally.worst_share << " ("
                  << tally.worst_name << "); measured/reached up to " << tally.worst_of_reached << " ("
                  << tally.worst_of_reached_name << "); " << tally.unconverged << " points unconverged\n";
    }
    std::cout << "[ ACCURACY ] baked in " << baked.count() << " s, judged in " << (all - baked).count() << " s"
              << std::endl;
}

}  // namespace
}  // namespace nacre::test
