// Metals that a scene gives by F0 and edge tint: where they may stand, their axis, and every mistake in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/pick/coloured_metal.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/shade/spectra.h"
#include "reference/colour.h"
#include "reference/light.h"
#include "support/folders.h"

namespace nacre::test {
namespace {

using Rec709 = std::array<double, 3>;

const std::string film = "[material.m]\nmechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\n";
const std::string bare = "[material.m]\nmechanism = \"stack\"\nlayers = []\n";
const std::string crystal = "[material.m]\nmechanism = \"crystal\"\nsphere = 1.45\ndiameter_nm = 250\n";
const std::string tinted = "substrate = { f0 = [0.9, 0.6, 0.2], edge_tint = [1, 0.9, 0.8] }\n";

Plan plan_of(const std::string& scene) {
    const TemporaryFolder folder;
    const CurrentFolder here(folder.path());
    folder.file("s.toml", scene);
    return plan_scene(read_scene_file("s.toml"), scene_files());
}

std::string message_of(const std::string& scene) {
    try {
        plan_of(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return "was accepted";
}

Rec709 normal_colour(const Mechanism& mechanism) {
    const auto& light = reference::ModelLight::of("D65", 2);
    const Spectrum spectrum = observed_spectrum(mechanism, Incidence::from_degrees(0.0), WavelengthGrid{});
    reference::Triple seen{};
    for (std::size_t i = 0; i < spectrum.value.size(); ++i) {
        const bool is_end = i == 0 || i + 1 == spectrum.value.size();
        for (std::size_t c = 0; c < 3; ++c) seen[c] += (is_end ? 0.5 : 1.0) * spectrum.value[i] * light.weights()[i][c];
    }
    return reference::to_rec709(light.adapted(seen));
}

TEST(MetalScene, ComesBackFromTheHeader) {
    for (const std::string& material : {film, bare, crystal}) {
        for (const std::string& substrate : {tinted, std::string("substrate = { f0 = [0, 0.5, 0.999999] }\n")}) {
            const Plan plan = plan_of(material + substrate);
            ASSERT_EQ(plan.luts.size(), 1u);
            const std::string header = scene_toml(plan.luts[0]);
            EXPECT_NE(header.find("\n" + substrate), std::string::npos) << header;
            EXPECT_EQ(scene_toml(plan_of(header).luts[0]), header);
        }
    }
    const std::string base = "base = { metal = { f0 = [0.9, 0.6, 0.2] } }\n";
    EXPECT_NE(scene_toml(plan_of(film + base).luts[0]).find("\n" + base), std::string::npos);
}

TEST(MetalScene, OfABareSurfaceHasItsColourUnderAnyLight) {
    const Plan plan = plan_of(bare + tinted + "[light]\nilluminant = \"A\"\nrange_nm = [400, 700]\n");
    const Rec709 colour = normal_colour(plan.materials[0].mechanism);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(colour[i], (Rec709{0.9, 0.6, 0.2})[i], 1e-9);
}

// The row at F0 = v shows the scene's colour times v over its largest component.
TEST(MetalScene, AxisIsLinearInF0) {
    const Plan plan = plan_of(bare + tinted + "[lut.m]\ny = { parameter = \"substrate.f0\", from = 0, to = 0.99 }\n");
    for (const double y : {0.0, 0.01, 0.25, 0.5, 0.8, 1.0}) {
        const Rec709 colour = normal_colour(mechanism_at(plan.luts[0].job, 0.0, y));
        const Rec709 wanted{0.99 * y, 0.99 * y * 6.0 / 9.0, 0.99 * y * 2.0 / 9.0};
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(colour[i], wanted[i], 1e-9) << y;
    }
}

TEST(MetalScene, RowOfTheAxisIsWhatASceneWithThisF0Is) {
    const Plan plan = plan_of(film + "substrate = { f0 = [0.8, 0.4, 0.2] }\n" +
                              "[lut.m]\ny = { parameter = \"substrate.f0\", from = 0, to = 0.8 }\n");
    const Plan half = plan_of(film + "substrate = { f0 = [0.4, 0.2, 0.1] }\n");
    const Geometry geometry = Incidence::from_degrees(50.0);
    EXPECT_EQ(observed_spectrum(mechanism_at(plan.luts[0].job, 0.0, 0.5), geometry, WavelengthGrid{}).value,
              observed_spectrum(half.materials[0].mechanism, geometry, WavelengthGrid{}).value);
}

TEST(MetalScene, HasF0AmongItsParametersInPlaceOfNAndK) {
    const auto names_of = [](const std::string& scene) {
        std::vector<std::string> names;
        for (const Parameter& one : parameters_of(plan_of(scene).materials[0].mechanism)) names.push_back(one.name);
        return names;
    };
    for (const std::string& material : {film, bare, crystal}) {
        const auto names = names_of(material + tinted);
        EXPECT_EQ(std::count(names.begin(), names.end(), "substrate.f0"), 1) << material;
        EXPECT_EQ(std::count(names.begin(), names.end(), "substrate.n"), 0) << material;
    }
    // Light that is to reach a base has to get through the substrate.
    const auto names = names_of(film + "base = 0.5\nsubstrate = { f0 = [0.04, 0.04, 0.04], edge_tint = [0, 0, 0] }\n");
    EXPECT_EQ(std::count(names.begin(), names.end(), "substrate.f0"), 0);
}

TEST(BadMetalScene, IsOneLineThatSaysWhereAndWhat) {
    const auto message = [](const std::string& line) { return message_of(film + line); };
    EXPECT_EQ(message("substrate = { f0 = [1, 0.5, 0.2] }\n"),
              "s.toml:5:21 [material.m]: f0 = 1 is out of range; allowed [0, 0.999999]");
    EXPECT_EQ(message("substrate = { f0 = [0.5, -0.1, 0.2] }\n"),
              "s.toml:5:26 [material.m]: f0 = -0.1 is out of range; allowed [0, 0.999999]");
    EXPECT_EQ(message("substrate = { f0 = [0.5, 0.2] }\n"),
              "s.toml:5:20 [material.m]: f0 has 2 numbers; give three, of linear Rec.709: [red, green, blue]");
    EXPECT_EQ(message("substrate = { f0 = 0.5 }\n"), "s.toml:5:20 [material.m]: f0 = 0.5 is a number; give an array");
    EXPECT_EQ(message("substrate = { edge_tint = [0.5, 0.2, 0.3] }\n"),
              "s.toml:5:13 [material.m]: f0 is missing; edge_tint needs it: the metal's colour, [red, green, blue]");
    EXPECT_EQ(message("substrate = { f0 = [0.5, 0.2, 0.1], edge_tint = [1, 1.5, 0] }\n"),
              "s.toml:5:53 [material.m]: edge_tint = 1.5 is out of range; allowed [0, 1]");
    EXPECT_EQ(message("substrate = { f0 = [0.5, 0.2, 0.1], specular_color = [1, 1, 1] }\n"),
              "s.toml:5:37 [material.m]: unknown key \"specular_color\"; did you mean edge_tint?");
    EXPECT_EQ(message("substrate = { f0 = [0.5, 0.2, 0.1], range_nm = [400, 700] }\n"),
              "s.toml:5:37 [material.m]: unknown key \"range_nm\"; known: from, to, f0, edge_tint");
    EXPECT_EQ(message("substrate = { f0 = [0.5, 0.2, 0.1], n = 1.5 }\n"),
              "s.toml:5:37 [material.m]: f0 and n are both given; n and k follow from f0, so remove one of them");
    EXPECT_EQ(message("f0 = [0.5, 0.2, 0.1]\n"),
              "s.toml:5:1 [material.m]: unknown key \"f0\"; did you mean substrate?");
    EXPECT_EQ(
        message("incident = { f0 = [0.5, 0.2, 0.1] }\n"),
        "s.toml:5:19 [material.m]: f0 has no meaning for incident: it is the colour of a metal, which a substrate "
        "or the metal of a base may be; give a number, { n, k }, or the name of a material");
    EXPECT_EQ(message(tinted + "[lut.m]\ny = { parameter = \"substrate.f0\", from = 0.1, to = 1 }\n"),
              "s.toml:7:52 [lut.m]: to = 1 is out of range; allowed [0, 0.999999]");
}

}  // namespace
}  // namespace nacre::test
