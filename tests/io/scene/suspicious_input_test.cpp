// What is allowed and hardly meant is said with its place and a remedy; what instruments write is read as it is meant.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "nacre/base/text.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/colour/xyz_sums.h"
#include "nacre/optics/multilayer/multilayer.h"
#include "nacre/scene/plan.h"
#include "nacre/shade/layered_colour.h"
#include "support/folders.h"
#include "support/mercury_lamp.h"

namespace nacre {
namespace {

class Folder {
public:
    void file(const std::string& name, const std::string& text) const { folder_.file(name, text); }

    Plan plan(const std::string& scene) const {
        const test::CurrentFolder here(folder_.path());
        folder_.file("s.toml", scene);
        return plan_scene(read_scene_file("s.toml"), scene_files());
    }
    std::vector<std::string> warnings(const std::string& scene) const { return plan(scene).warnings; }
    std::string message(const std::string& scene) const {
        try {
            plan(scene);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }

private:
    test::TemporaryFolder folder_;
};

using Lines = std::vector<std::string>;

const std::string measured = "[material.m]\nmechanism = \"measured\"\n";
const std::string film = "[material.f]\nmechanism = \"film\"\nindex = 1.33\n";

const MeasuredSpectra& spectra_of(const Plan& plan) {
    return std::get<MeasuredSpectra>(plan.materials.front().mechanism);
}

TEST(SuspiciousInput, ReflectanceAboveWhiteIsSaidUnlessTheSceneSaysItsUnit) {
    const Folder folder;
    folder.file("dark.csv", "wavelength_nm,0,15\n360,8,7\n830,3,2.5\n");  // percent, and no number tells
    EXPECT_EQ(folder.warnings(measured + "file = \"dark.csv\"\n"),
              Lines{"s.toml:3:8 [material.m]: the reflectance reaches 8, and a white standard has 1; write unit = "
                    "\"percent\" if the values are percent, or unit = \"fraction\" if they are right"});
    const Plan percent = folder.plan(measured + "file = \"dark.csv\"\nunit = \"percent\"\n");
    EXPECT_TRUE(percent.warnings.empty());
    EXPECT_EQ(spectra_of(percent).reflectance, (std::vector<double>{0.08, 0.03, 0.07, 0.025}));
    const Plan fraction = folder.plan(measured + "file = \"dark.csv\"\nunit = \"fraction\"\n");
    EXPECT_TRUE(fraction.warnings.empty());
    EXPECT_EQ(spectra_of(fraction).reflectance, (std::vector<double>{8.0, 3.0, 7.0, 2.5}));
}

TEST(SuspiciousInput, WrittenOutSpectraHaveAUnitToo) {
    const Folder folder;
    const std::string bright = "wavelength_nm = [400, 700]\nangle_deg = [0]\nreflectance = [[50, 105]]\n";
    EXPECT_EQ(spectra_of(folder.plan(measured + bright + "unit = \"percent\"\n")).reflectance,
              (std::vector<double>{0.5, 1.05}));
    EXPECT_EQ(folder.message(measured + bright),
              "s.toml:5:17 [material.m]: reflectance = 50 is out of range; allowed [0, 10]");
    EXPECT_EQ(folder.message(measured + bright + "unit = \"%\"\n"),
              "s.toml:5:17 [material.m]: reflectance = 50 is out of range; allowed [0, 10]\n"
              "s.toml:6:8 [material.m]: unknown unit \"%\"; known: fraction, percent");
    // The scene in a header says it, so that reading it again warns of nothing.
    const Plan plan = folder.plan(measured + bright + "unit = \"percent\"\n");
    const Plan again = plan_scene(parse_scene(scene_toml(plan.luts.front()), "header"), scene_files());
    EXPECT_TRUE(again.warnings.empty());
    EXPECT_EQ(spectra_of(again).reflectance, spectra_of(plan).reflectance);
}

TEST(SuspiciousInput, OneOfSeveralSpecimensIsChosenByItsHeading) {
    const Folder folder;
    folder.file("all.csv", "Specimens of May\nWavelength (nm);Gold %R;Teal %R\n830;90,5;1,0\n360;10;-0,5\n");
    const Plan plan = folder.plan(measured +
                                  "file = \"all.csv\"\ncolumn = \"Teal %R\"\nunit = \"percent\"\nnegative = "
                                  "\"clip\"\n");
    EXPECT_EQ(spectra_of(plan).wavelength_nm, (std::vector<double>{360.0, 830.0}));
    EXPECT_EQ(spectra_of(plan).reflectance, (std::vector<double>{0.0, 0.01}));
    EXPECT_TRUE(
        folder.message(measured + "file = \"all.csv\"\ncolumn = \"Gold %R\"\n")
            .ends_with("all.csv:2:1: the heading says percent; write unit = \"percent\" in the scene, or unit = "
                       "\"fraction\" if the values are fractions"));
}

TEST(SuspiciousInput, BasesAndLampsChooseTheirColumns) {
    const Folder folder;
    folder.file("paint.csv", "wl,Red,White\n400,5,96\n800,80,-1\n");
    folder.file("lamps.csv", "wl,Hall,Desk\n830,1,-0.01\n600,1,1\n360,1,2\n");
    const Plan plan =
        folder.plan("[light]\nilluminant = { file = \"lamps.csv\", column = \"Desk\", negative = \"clip\" }\n" + film +
                    "thickness_nm = 400\nbase = { spectrum = \"paint.csv\", column = \"White\", unit = "
                    "\"percent\", negative = \"clip\" }\n");
    EXPECT_EQ(plan.light->settings.power, (SampledCurve{{360, 600, 830}, {2, 1, 0}}));
    EXPECT_EQ(plan.light->settings.illuminant, "lamps.csv Desk");
    const Base& base = *plan.materials.front().mechanism.effects.base;
    EXPECT_EQ(std::get<SpectrumBase>(base).reflectance, (SampledCurve{{400, 800}, {0.96, 0}}));
    EXPECT_EQ(
        folder.message("[light]\nilluminant = { file = \"lamps.csv\", column = \"Desk\" }\n" + film +
                       "thickness_nm = 400\n"),
        "s.toml:2:14 [light]: illuminant \"lamps.csv Desk\" is -0.01 at 830 nm; power is 0 to 1e+30; write { file = "
        "\"NAME\", negative = \"clip\" } if it is noise");
}

TEST(SuspiciousInput, LayersThinnerThanANanometreAreSaid) {
    const Folder folder;
    EXPECT_EQ(folder.warnings(film + "thickness_nm = 0.4\n"),
              Lines{"s.toml:4:16 [material.f]: thickness_nm = 0.4 is less than 1 nm, a layer of a few atoms; if "
                    "micrometres are meant, write 400"});
    EXPECT_TRUE(folder.warnings(film + "thickness_nm = 0\n").empty());
    EXPECT_TRUE(folder.warnings(film + "thickness_nm = 1\n").empty());
    EXPECT_EQ(
        folder.warnings("[material.f]\nmechanism = \"stack\"\nlayers = [ { repeat = 2, layers = [ { index = 1.5, "
                        "thickness_nm = { from = 0.1, to = 0.2 } } ] } ]\n"),
        (Lines{"s.toml:3:76 [material.f]: from = 0.1 is less than 1 nm, a layer of a few atoms; if micrometres are "
               "meant, write 100",
               "s.toml:3:86 [material.f]: to = 0.2 is less than 1 nm, a layer of a few atoms; if micrometres are "
               "meant, write 200"}));
    EXPECT_EQ(
        folder
            .warnings("[material.f]\nmechanism = \"stack\"\nform = \"lamellae\"\nfilm = 1.5\nfilm_nm = 0.1\ngap_nm "
                      "= 0.07\n")
            .size(),
        2u);
}

TEST(SuspiciousInput, AMaterialOfOneRowIsHeldOrRefused) {
    const Folder folder;
    folder.file("one.csv", "wavelength_nm,n\n550,1.5\n");
    const std::string stack = "[material.f]\nmechanism = \"film\"\nthickness_nm = 100\nindex = ";
    EXPECT_EQ(folder.message(stack + "\"one.csv\"\n"),
              "s.toml:4:9 [material.f]: \"one.csv\" is known at 550 nm only, and the light needs 360 to 830 nm; write "
              "outside = \"hold\" to use its value at all wavelengths");
    EXPECT_EQ(folder.message(stack + "{ wavelength_nm = [550], n = [1.5] }\n"),
              "s.toml:4:9 [material.f]: this index is known at 550 nm only, and the light needs 360 to 830 nm; write "
              "outside = \"hold\" to use its value at all wavelengths");
    for (const std::string held : {"{ material = \"one.csv\", outside = \"hold\" }",
                                   "{ wavelength_nm = [550], n = [1.5], outside = \"hold\" }"}) {
        const Plan plan = folder.plan(stack + held + "\n");
        const auto& index = std::get<Film>(plan.materials.front().mechanism).index;
        for (const double nm : {360.0, 550.0, 830.0}) EXPECT_EQ(index.at(nm), RefractiveIndex(1.5, 0.0));
        const Plan again = plan_scene(parse_scene(scene_toml(plan.luts.front()), "header"), scene_files());
        EXPECT_EQ(scene_toml(again.luts.front()), scene_toml(plan.luts.front()));
    }
}

// Only what the light needs is kept of a table, but messages are about the file.
TEST(SuspiciousInput, RangesInMessagesAreThoseOfTheFile) {
    const Folder folder;
    std::string text = "nm,n\n";
    for (int nm = 200; nm <= 700; nm += 10) text += std::to_string(nm) + ",1.5\n";
    folder.file("early.csv", text);
    folder.file("lamp.csv", text);
    EXPECT_EQ(folder.message("[material.f]\nmechanism = \"film\"\nthickness_nm = 100\nindex = \"early.csv\"\n"),
              "s.toml:4:9 [material.f]: \"early.csv\" is known from 200 to 700 nm, and the light needs 360 to 830 nm; "
              "narrow [light] range_nm, or write outside = \"hold\" to go on with its end values");
    EXPECT_EQ(folder.message("[light]\nilluminant = \"lamp.csv\"\n" + film + "thickness_nm = 400\n"),
              "s.toml:2:14 [light]: illuminant \"lamp.csv\" covers 200 to 700 nm; range_nm needs 360 to 830 nm");
}

// A lamp all of whose light lies between whole nanometres has light.
TEST(SuspiciousInput, ALineBetweenWholeNanometresIsLight) {
    const Folder folder;
    folder.file("laser.csv", "nm,power\n360,0\n532.4,0\n532.5,1\n532.6,0\n830,0\n");
    folder.file("dark.csv", "nm,power\n360,0\n532.4,0\n830,0\n");
    const std::string scene = "adapt = \"none\"\n" + film + "thickness_nm = 400\n";
    EXPECT_EQ(folder.plan("[light]\nilluminant = \"laser.csv\"\n" + scene).light->weights.cells_per_nm, 8);
    EXPECT_EQ(folder.message("[light]\nilluminant = \"dark.csv\"\n" + scene),
              "s.toml:2:14 [light]: illuminant \"dark.csv\" has no visible light in range_nm; give it power there, or "
              "widen range_nm");
}

// The lamp's own nodes, summed by a quadrature of 0.01 nm with nothing of nacre's, give these numbers (to their
// digits).
TEST(SuspiciousInput, ALampOfNarrowLinesIsIntegratedOnItsOwnNodes) {
    const Folder folder;
    const SampledCurve lamp = test::mercury_lamp();
    std::string text = "wavelength_nm,power\n";
    for (std::size_t i = 0; i < lamp.value.size(); ++i)
        text += number_text(lamp.wavelength_nm[i]) + "," + number_text(lamp.value[i]) + "\n";
    folder.file("mercury.csv", text);
    const Plan plan = folder.plan(
        "[light]\nilluminant = \"mercury.csv\"\n[material.f]\nmechanism = \"film\"\nindex = "
        "\"water\"\nthickness_nm = 400\n");
    const SpectralNodes nodes = make_spectral_nodes(plan.light->weights, 96);
    std::vector<Response> responses(nodes.wavelength_nm.size());
    MultilayerSolver(layer_ensemble(plan.materials.front().mechanism, 1).systems.front(), nodes.wavelength_nm)
        .responses(Incidence::from_degrees(0.0), responses);
    Xyz sum;
    for (std::size_t i = 0; i < responses.size(); ++i)
        add(sum, responses[i].reflectance(), {nodes.x[i], nodes.y[i], nodes.z[i]});
    EXPECT_NEAR(sum.x, 0.03729, 5e-6);
    EXPECT_NEAR(sum.y, 0.01732, 5e-6);
    EXPECT_NEAR(sum.z, 0.05715, 5e-6);
}

TEST(BareSurface, IsAStackWithoutLayersThatReflectsAsFresnelSays) {
    const Folder folder;
    const Plan plan = folder.plan("[material.f]\nmechanism = \"stack\"\nlayers = []\nsubstrate = 1.5\n");
    EXPECT_TRUE(plan.warnings.empty());
    const Mechanism& mechanism = plan.materials.front().mechanism;
    const LayerSystem system = layer_ensemble(mechanism, 1).systems.front();
    const double theta = std::asin(1.0) / 3.0, cos_in = std::cos(theta);
    const double cos_out = std::sqrt(1.0 - std::pow(std::sin(theta) / 1.5, 2));
    const double s = (cos_in - 1.5 * cos_out) / (cos_in + 1.5 * cos_out);
    const double p = (1.5 * cos_in - cos_out) / (1.5 * cos_in + cos_out);
    const std::vector<double> wavelengths_nm{550.0};
    std::vector<Response> responses(1);
    MultilayerSolver(system, wavelengths_nm).responses(Incidence::from_degrees(30.0), responses);
    for (const Response& r : {responses.front(), multilayer_response(system, Incidence::from_degrees(30.0), 550.0)}) {
        EXPECT_NEAR(r.reflectance_s, s * s, 1e-14);
        EXPECT_NEAR(r.reflectance_p, p * p, 1e-14);
        EXPECT_NEAR(r.transmittance_s, 1.0 - s * s, 1e-14);
    }
    const Plan again = plan_scene(parse_scene(scene_toml(plan.luts.front()), "header"), scene_files());
    EXPECT_EQ(again.materials.front().mechanism, mechanism);
}

}  // namespace
}  // namespace nacre
