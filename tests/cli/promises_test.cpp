// What a plan promises is what a bake measures: scenes with which it once was not so.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

namespace nacre::test {
namespace {

struct Outcome {
    int exit_code = -1;
    std::string err;
    double predicted = 0.0;
    double reached = 0.0;
    int width = 0;
};

Outcome bake(const std::string& material, const std::string& accuracy = "") {
    const TemporaryFolder folder;
    folder.file("s.toml", "[material.m]\n" + material + "\n[accuracy]\n" + accuracy + "\n");
    const ProgramResult result =
        run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, {folder.path(), {}, {}, {}});
    Outcome outcome{result.exit_code, result.err, 0.0, 0.0, 0};
    if (result.exit_code != 0) return outcome;
    const auto manifest = nlohmann::json::parse(file_bytes(folder.path() / "out" / "m.json"));
    outcome.predicted = manifest["accuracy"]["predicted"];
    outcome.reached = manifest["accuracy"]["reached"];
    outcome.width = manifest["width"];
    return outcome;
}

const std::string film = "mechanism = \"film\"\nindex = 1.5\nthickness_nm = 400\n";

// Free in air, its fringes are needles next to grazing: for the nodes, and for what measures them.
TEST(Promises, HoldOfAFilmThatStandsFree) {
    for (const char* bound : {"max_de00 = 0.02", "max_de00 = 0.01"}) {
        const Outcome outcome = bake(film, bound);
        EXPECT_EQ(outcome.exit_code, 0) << bound << ": " << outcome.err;
    }
}

// Of facets that lean every way, those that are grazed hardly count, nor does what their nodes err by.
TEST(Promises, OfATiltedFilmAreNotHundredsOfTimesTooHigh) {
    for (const char* tilt : {"tilt_deg = 25", "tilt_deg = 60"}) {
        const Outcome outcome = bake(film + tilt);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.err.find("cannot be reached"), std::string::npos) << outcome.err;
        EXPECT_LE(outcome.predicted, 0.1) << tilt;
        EXPECT_LE(outcome.width, 256) << tilt;
    }
}

// Counts that the user requests are judged like those that nacre finds.
TEST(Promises, CountWhatGivenSumsErrBy) {
    const std::string mie =
        "mechanism = \"scatter\"\nmodel = \"mie\"\nparticle = 1.5\nmedium = 1.33\nradius_nm = 100\nradius_spread = "
        "0.2\n";
    const std::string crystal = "mechanism = \"crystal\"\nsphere = 1.45\nmedium = 1.33\ndiameter_nm = 250\n";
    const std::string base =
        "mechanism = \"film\"\nindex = \"water\"\nthickness_nm = 400\nthickness_spread_nm = 20\nbase = 0.3\nsubstrate "
        "= "
        "1.33\n";
    for (const auto& [material, counts] : {std::pair{mie, "sampling = { radii = 2 }"},
                                           {crystal, "sampling = { slices = 4 }"},
                                           {base, "sampling = { base_directions = 2 }"}}) {
        const Outcome outcome = bake(material, counts);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("cannot be reached"), std::string::npos) << counts << ": " << outcome.err;
        EXPECT_NE(outcome.err.find("sums over base, radii or slices cost"), std::string::npos) << outcome.err;
        // What is reached is an upper estimate: the worst of the texels and the worst of the sums may lie apart.
        EXPECT_GE(1.15 * outcome.predicted, outcome.reached) << counts;
        EXPECT_EQ(bake(material, std::string(counts) + "\nmax_de00 = 0.1").exit_code, 4) << counts;
    }
}

// A layer that is not there but for its spread.
TEST(Promises, SeeWhatOnlyUnevenLayersShow) {
    const Outcome layer = bake(
        "mechanism = \"stack\"\nlayers = [ { index = 1.5, thickness_nm = 200 }, { index = { n = 1.5, k = 0.5 }, "
        "thickness_nm = 0 } ]\nthickness_spread_nm = 20\nsubstrate = 1.5\n");
    EXPECT_EQ(layer.exit_code, 0) << layer.err;
    EXPECT_LE(layer.reached, 1.1 * std::max(layer.predicted, 0.1));
    const Outcome bare = bake("mechanism = \"film\"\nindex = 1.5\nthickness_nm = 0\nthickness_spread_nm = 1000\n");
    EXPECT_EQ(bare.exit_code, 0) << bare.err;
    EXPECT_LE(bare.reached, 1.1 * std::max(bare.predicted, 0.1));
}

// Nothing to see, and nothing that is taken for an error: the remains of lines that are elsewhere.
TEST(Promises, OfAGratingBesideAllItsLightAreBlack) {
    const std::string grating = "mechanism = \"grating\"\nperiod_nm = 1600\ndepth_nm = 120\ngroove_length_um = 1\n";
    for (const char* azimuth : {"azimuth_deg = 90", "azimuth_deg = 89.99"}) {
        const Outcome outcome = bake(grating + azimuth);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("the grating is black at its azimuth_deg"), std::string::npos) << outcome.err;
        EXPECT_LE(outcome.reached, 0.1) << azimuth;
    }
}

// With a bound that is reached once everything is added there is no refusal, and no advice about keys nobody gave.
TEST(Promises, DoNotContradictThemselves) {
    for (const char* bound : {"max_de00 = 0.002", "max_de00 = 0.0005"}) {
        const Outcome outcome = bake(film, bound);
        EXPECT_EQ(outcome.err.find("remove [accuracy.sampling] nodes"), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.err.find("please report"), std::string::npos) << outcome.err;
    }
}

}  // namespace
}  // namespace nacre::test
