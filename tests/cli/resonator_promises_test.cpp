// Promises that were once broken, or refused without need or for a wrong reason. What they are about is resonances: the
// judge is the reference model with wavelengths as close as those need, densely along the LUT.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "reference/curve.h"
#include "reference/dice.h"
#include "reference/materials.h"
#include "reference/model.h"
#include "support/program.h"
#include "support/written_lut.h"

namespace nacre::test {
namespace {

using reference::layer_of;
using reference::Model;
using reference::ModelScene;
using reference::periods_of;
using reference::Worst;

// Into a folder of the bound's name.
ProgramResult bake(const TemporaryFolder& folder, const std::string& file, const std::string& bound,
                   const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"bake", file, "-o", bound, "--accuracy", bound, "--no-preview"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_nacre(arguments, {folder.path(), {}, {}, {}});
}

struct Promise {
    const char* name;
    std::string text;  // of the material
    Mechanism mechanism;
    const char* bound;
    int most_texels;  // at most twice what exact texels need
};

void PrintTo(const Promise& promise, std::ostream* out) {
    *out << promise.name;
}

Mechanism gap(double thickness_nm, double incident = 1.33) {
    Film film;
    film.incident = incident;
    film.index = 1.0;
    film.thickness_nm = thickness_nm;
    film.substrate = reference::named_index("ag");
    return film;
}

std::string gap_text(const std::string& thickness_nm, const std::string& incident = "1.33") {
    return "mechanism = \"film\"\nincident = " + incident + "\nindex = 1.0\nthickness_nm = " + thickness_nm +
           "\nsubstrate = \"ag\"\n";
}

Index tio2() {
    static const Index index =
        reference::index_of_file("tio2", std::string(NACRE_SOURCE_DIR) + "/configs/materials/tio2.yml");
    return index;
}

Mechanism mirror_with_defect() {
    const Layer high = layer_of(tio2(), 57.0), low = layer_of(reference::named_index("sio2"), 94.0);
    return Stack{1.0,
                 {periods_of(6, high, low), layer_of(tio2(), 114.0), periods_of(6, low, high)},
                 reference::named_index("bk7"),
                 0.0};
}

constexpr const char* mirror_with_defect_text =
    "mechanism = \"stack\"\nlayers = [\n"
    "  { repeat = 6, layers = [ { index = \"tio2\", thickness_nm = 57 }, { index = \"sio2\", thickness_nm = 94 } ] },\n"
    "  { index = \"tio2\", thickness_nm = 114 },\n"
    "  { repeat = 6, layers = [ { index = \"sio2\", thickness_nm = 94 }, { index = \"tio2\", thickness_nm = 57 } ] },\n"
    "]\nsubstrate = \"bk7\"\n";

// configs/scenes/lacquered_metal.toml
Mechanism rose_gold() {
    const Layer high = layer_of(tio2(), 72.6), low = layer_of(reference::named_index("sio2"), 120.1);
    Mechanism mechanism = Stack{1.0, {periods_of(2, high, low), high}, 1.5, 0.0};
    mechanism.effects.base = MetalBase{reference::named_index("au")};
    mechanism.effects.relief.tilt_deg = 2.0;
    return mechanism;
}

constexpr const char* rose_gold_text =
    "mechanism = \"stack\"\nlayers = [\n"
    "  { repeat = 2, layers = [ { index = \"tio2\", thickness_nm = 72.6 }, { index = \"sio2\", thickness_nm = 120.1 } "
    "] "
    "},\n"
    "  { index = \"tio2\", thickness_nm = 72.6 },\n"
    "]\nsubstrate = 1.5\nbase = { metal = \"au\" }\ntilt_deg = 2\n";

Mechanism plain_film() {
    Film film;
    film.incident = film.substrate = 1.0;
    film.index = 1.33;
    film.thickness_nm = 400.0;
    return film;
}

class ResonatorPromise : public testing::TestWithParam<Promise> {};

TEST_P(ResonatorPromise, IsKeptAndClaimedTruly) {
    const Promise& promise = GetParam();
    const TemporaryFolder folder;
    folder.file("s.toml", "[material.m]\n" + promise.text);
    const ProgramResult result = bake(folder, "s.toml", promise.bound);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto lut = read_written_lut(folder.path() / promise.bound / "m.exr");
    ASSERT_TRUE(lut);
    EXPECT_LE(lut->pixels.width, promise.most_texels);
    ModelScene scene;
    scene.name = "m";
    scene.mechanism = promise.mechanism;
    scene.x = reference::ModelAxis::sqrt_cos_theta;
    const Worst worst = reference::worst_of(lut->pixels, reference::curve_of_layers(scene));
    EXPECT_LE(worst.error, std::strtod(promise.bound, nullptr)) << "at x = " << worst.x;
    // A thousandth: how closely a point may be missed that lies between those that were looked at.
    EXPECT_LE(worst.error, 1.001 * lut->reached) << "at x = " << worst.x;
}

INSTANTIATE_TEST_SUITE_P(
    Once, ResonatorPromise,
    testing::Values(Promise{"Gap400", gap_text("400"), gap(400.0), "0.1", 1024},
                    Promise{"Gap800", gap_text("800"), gap(800.0), "0.1", 2048},
                    Promise{"Gap800Coarsely", gap_text("800"), gap(800.0), "0.2", 2048},
                    // A line so narrow that a curve of the colours with this bound steps over it.
                    Promise{"Gap1158", gap_text("1158", "1.93"), gap(1158.0, 1.93), "1", 4096},
                    Promise{"MirrorWithDefect", mirror_with_defect_text, mirror_with_defect(), "0.1", 128},
                    Promise{"PlainFilm", "mechanism = \"film\"\nindex = 1.33\nthickness_nm = 400\n", plain_film(),
                            "0.1", 128},
                    Promise{"RoseGold", rose_gold_text, rose_gold(), "0.2", 64},
                    Promise{"RoseGoldFinely", rose_gold_text, rose_gold(), "0.1", 64}),
    [](const auto& parameters) { return std::string(parameters.param.name); });

struct Place {
    double error = 0.0, x = 0.0, y = 0.0;
};

// All over, and in the cell of the corner at (0, 0).
Place worst_of_water(const reference::Pixels& lut) {
    ModelScene scene;
    Film film;
    film.incident = film.substrate = 1.0;
    film.index = reference::named_index("water");
    scene.mechanism = film;
    scene.y = {"thickness_nm", 0.0, 1000.0, 0};
    const double scale = reference::scale_of(lut);
    const Model model(scene);
    Place worst;
    const auto look = [&](double x, double y) {
        const double error = reference::error_at(lut, scale, x, y, model.resolved(x, y, 1e-5));
        if (error > worst.error) worst = {error, x, y};
    };
    reference::Dice dice(1000);
    for (int i = 0; i < 400; ++i) {
        const double x = dice.unit();
        look(x, dice.unit());
    }
    constexpr int steps = 16;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j <= steps; ++j)
            look(static_cast<double>(i) / steps / (lut.width - 1), static_cast<double>(j) / steps / (lut.height - 1));
    return worst;
}

// A film of no thickness reflects nothing, and any other all light that grazes it: in that corner a fetch is far off
// whatever the size. What is found best and what it is blamed on have to be of one LUT.
TEST(ResonatorPromises, AFilmFromNothingIsMetOrRefusedForItsReasonAndSoon) {
    const TemporaryFolder folder;
    const std::string film = "mechanism = \"film\"\nindex = \"water\"\nthickness_nm = 400\n";
    folder.file("s.toml", "[material.m]\n" + film +
                              "[lut.m]\nmaterial = \"m\"\ny = { parameter = \"thickness_nm\", from = 0, to = 1000 }\n");
    const ProgramResult result = bake(folder, "s.toml", "0.1", {"--best-effort"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto lut = read_written_lut(folder.path() / "0.1" / "m.exr");
    ASSERT_TRUE(lut);
    const std::string reason = reason_of_refusal(result.err, "m");
    if (reason.empty()) {
        EXPECT_LE(lut->reached, 0.1) << result.err;
    } else {
        const double claimed = std::strtod(result.err.c_str() + result.err.find("the best is ") + 12, nullptr);
        EXPECT_NEAR(lut->reached, claimed, 0.1 * claimed) << result.err;
        EXPECT_NE(reason.find("the colour jumps at 90 degrees, thickness_nm = 0"), std::string::npos) << result.err;
    }
    // Most of the work would be to try what cannot help.
    const ProgramResult plan = run_nacre({"plan", (folder.path() / "s.toml").string(), "--json"});
    const auto work = nlohmann::json::parse(plan.out)["luts"][0]["work"];
    EXPECT_LE(work["deciding"]["samples"].get<double>(), 16.0 * work["baking"]["samples"].get<double>());
    const Place worst = worst_of_water(lut->pixels);
    EXPECT_LE(worst.error, 1.015 * lut->reached) << "at (" << worst.x << ", " << worst.y << ")";
}

}  // namespace
}  // namespace nacre::test
