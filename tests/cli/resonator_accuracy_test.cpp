// The accuracy contract where light goes to and fro: gaps next to metals, cavities, mirrors with defects, long stacks,
// thick films, and what refines them. Each LUT that `nacre bake --accuracy DE` writes is fetched densely between its
// texels and compared with the reference model, whose wavelengths are as close as resonances need. The bound
// may be exceeded nowhere, and the error that the header claims in hardly any LUT. NACRE_RESONATOR_SWEEP=1 takes all
// 400 structures, NACRE_RESONATOR_SWEEP=0 a few, so that sanitizers end in seconds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "reference/curve.h"
#include "reference/random_scenes.h"
#include "support/program.h"
#include "support/written_lut.h"

namespace nacre::test {
namespace {

using reference::ModelCurve;
using reference::ModelScene;
using reference::Worst;

// Digits of the header, and what the judge's own sums may err by.
constexpr double judges_share = 0.015;
constexpr int most_texels = 16384;

// What a header claims is an estimate. Of the 1200 LUTs three claim too little, and keep their bound or are refused: a
// long stack over a base under a lamp with lines (by 5 and 60 %), and a film of 20 micrometres.
constexpr std::size_t luts_per_low_claim = 200;

constexpr std::array<const char*, 3> bounds{"1", "0.1", "0.02"};

std::vector<ModelScene> scenes_of_this_run() {
    std::vector<ModelScene> all = reference::random_resonators();
    const char* sweep = std::getenv("NACRE_RESONATOR_SWEEP");
    if (sweep != nullptr && std::string(sweep) == "1") return all;
    // Of every kind, with every refinement, and quick to judge.
    constexpr std::array<std::size_t, 12> chosen{19, 85, 116, 8, 84, 110, 192, 57, 176, 119, 44, 111};
    const std::size_t count = sweep != nullptr && std::string(sweep) == "0" ? 4 : chosen.size();
    std::vector<ModelScene> some;
    for (std::size_t i = 0; i < count; ++i) some.push_back(all[chosen[i]]);
    return some;
}

// ---- The contract ----

struct Tally {
    std::size_t luts = 0, refused = 0, out_of_reach = 0, wrong = 0, claimed_too_little = 0;
    double worst_share = 0.0, worst_of_reached = 0.0;
    std::string worst_name, worst_of_reached_name;
};

// Whether no LUT that the program may write keeps a bound: exact texels, as many as it tries.
bool is_out_of_reach(const ModelCurve& curve, double bound) {
    const auto exact = [&](double x, double) { return curve.at(x); };
    const reference::Pixels lut = reference::make_lut(exact, most_texels, 1, reference::StoredAs::single_float);
    return reference::worst_of(lut, curve).error > bound;
}

// @param messages  of the bake
void judge(const WrittenLut& lut, const ModelCurve& curve, const std::string& name, double bound,
           const std::string& messages, Tally& tally) {
    ASSERT_GE(lut.reached, 0.0) << "the header has no nacre:accuracyReached";
    const Worst worst = reference::worst_of(lut.pixels, curve);
    const bool is_refused = lut.reached > bound;
    std::ostringstream what;
    what << name << " at " << bound << ": " << worst.error << " at x = " << worst.x << ", reached " << lut.reached
         << ", " << lut.pixels.width << " x " << lut.pixels.height << " " << lut.format_name()
         << (is_refused ? ", refused" : "");
    EXPECT_NEAR(worst.by_curve, worst.error, 0.01 * worst.error + 1e-5) << "the judge's curve errs: " << what.str();
    const double slack = 1.0 + judges_share;
    const bool is_wrong = !is_refused && worst.error > slack * bound;
    EXPECT_FALSE(is_wrong) << what.str();
    ++tally.luts;
    tally.wrong += is_wrong ? 1 : 0;
    if (worst.error > slack * lut.reached) {
        ++tally.claimed_too_little;
        std::cout << "[ ACCURACY ] claims too little: " << what.str() << std::endl;
    }
    if (std::getenv("NACRE_ACCURACY_VERBOSE") != nullptr)
        std::cout << what.str() << (is_wrong ? "  WRONG" : "") << std::endl;
    if (is_refused) {
        EXPECT_NE(reason_of_refusal(messages, name), "") << what.str() << "\n" << messages;
        ++tally.refused;
        tally.out_of_reach += is_out_of_reach(curve, bound) ? 1 : 0;
        return;
    }
    const double share = worst.error / bound, of_reached = worst.error / std::max(lut.reached, 0.05 * bound);
    if (share > tally.worst_share) tally.worst_share = share, tally.worst_name = name;
    if (of_reached > tally.worst_of_reached) tally.worst_of_reached = of_reached, tally.worst_of_reached_name = name;
}

void print(const std::string& bound, const Tally& tally) {
    std::cout << "[ ACCURACY ] DE " << bound << ": " << tally.luts << " LUTs, " << tally.wrong << " wrong, "
              << tally.refused << " refused, " << tally.out_of_reach << " of them out of the reach of " << most_texels
              << " exact texels; measured/bound up to " << tally.worst_share << " (" << tally.worst_name
              << "); measured/reached up to " << tally.worst_of_reached << " (" << tally.worst_of_reached_name << ")"
              << std::endl;
}

// What the program wrote to standard error, by bound. LUTs of a bound lie in a folder of its name.
std::map<std::string, std::string> bake_all(const TemporaryFolder& folder, const std::vector<ModelScene>& scenes) {
    std::vector<std::string> files;
    for (const ModelScene& scene : scenes)
        files.push_back(folder.file(scene.name + ".toml", reference::scene_text(scene)));
    std::map<std::string, std::string> messages;
    for (const char* bound : bounds) {
        std::vector<std::string> arguments{"bake", "-o", bound, "--accuracy", bound, "--best-effort", "--no-preview"};
        arguments.insert(arguments.end(), files.begin(), files.end());
        const ProgramResult result = run_nacre(arguments, {folder.path(), {}, {}, {}});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err.find("please report"), std::string::npos) << result.err;
        messages[bound] = result.err;
    }
    return messages;
}

TEST(ResonatorAccuracyContract, NoFetchIsFartherFromTheModelThanWasAskedOrClaimed) {
    const TemporaryFolder folder;
    const std::vector<ModelScene> scenes = scenes_of_this_run();
    const auto start = std::chrono::steady_clock::now();
    std::map<std::string, std::string> messages = bake_all(folder, scenes);
    const std::chrono::duration<double> baked = std::chrono::steady_clock::now() - start;

    std::map<std::string, Tally> tallies;
    for (const ModelScene& scene : scenes) {
        SCOPED_TRACE(reference::scene_text(scene));
        const ModelCurve curve = reference::curve_of_layers(scene);
        for (const char* bound : bounds) {
            const auto lut = read_written_lut(folder.path() / bound / (scene.name + ".exr"));
            ASSERT_TRUE(lut) << scene.name << " was not written";
            judge(*lut, curve, scene.name, std::strtod(bound, nullptr), messages[bound], tallies[bound]);
        }
    }
    const std::chrono::duration<double> all = std::chrono::steady_clock::now() - start;
    std::size_t luts = 0, refused_in_reach = 0, claimed_too_little = 0;
    for (const auto& [bound, tally] : tallies) {
        print(bound, tally);
        luts += tally.luts;
        refused_in_reach += tally.refused - tally.out_of_reach;
        claimed_too_little += tally.claimed_too_little;
    }
    EXPECT_LE(luts_per_low_claim * claimed_too_little, luts) << "headers claim less than is true";
    EXPECT_LT(50 * refused_in_reach, luts) << "refused though a LUT keeps the bound";
    std::cout << "[ ACCURACY ] baked in " << baked.count() << " s, judged in " << (all - baked).count() << " s"
              << std::endl;
}

}  // namespace
}  // namespace nacre::test
