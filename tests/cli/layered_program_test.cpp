// Films and stacks through the program: a header bakes its own file again, and mistakes are one line.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

namespace nacre::test {
namespace {

constexpr const char* film = "[material.f]\nmechanism = \"film\"\n";
constexpr const char* stack = "[material.f]\nmechanism = \"stack\"\n";
constexpr const char* good_film = "[material.f]\nmechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\n";
// Measured from 450 nm only, and with absorption.
constexpr const char* late_csv = "wavelength_nm,n\n450,1.5\n900,1.4\n";
constexpr const char* wide_csv =
    "wavelength_nm,n,k\n300,1.60,0\n400,1.55,0.01\n500,1.53,0\n600,1.52,0\n700,1.51,0.02\n800,1.50,0\n900,1.49,0\n";

std::string film_with(const std::string& index, const std::string& thickness = "300") {
    return std::string(film) + "index = " + index + "\nthickness_nm = " + thickness + "\n";
}

nlohmann::json json_of(const std::filesystem::path& path) {
    return nlohmann::json::parse(file_bytes(path));
}

TEST(LayeredHeader, OfABakedFileBakesTheSameFileAgain) {
    for (const std::string& body :
         {std::string(film) + "index = \"wide.csv\"\nthickness_nm = 300\nsubstrate = 1.33\n",
          std::string(film) + "index = { cauchy = [1.5, 0.004] }\nthickness_nm = 300\nsubstrate = \"ag\"\n",
          std::string(stack) + "form = \"lamellae\"\nfilm = \"chitin\"\nfilm_nm = 94\ngap_nm = 83\nfilms = "
                               "4\nthickness_spread_nm = 5\n[accuracy.sampling]\nnodes = 32\nthickness_samples = 8\n",
          std::string(stack) +
              "layers = [ { index = 1.38, thickness_nm = 200 }, { index = \"bk7\", thickness_nm = 1e5 } "
              "]\n"}) {
        const TemporaryFolder folder;
        folder.file("wide.csv", wide_csv);
        folder.file("s.toml", body + "[lut.f]\nsize = 8\nformat = \"float\"\n");
        const ProgramResult first =
            run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, {folder.path(), {}, {}, {}});
        ASSERT_EQ(first.exit_code, 0) << first.err << body;
        const TemporaryFolder elsewhere;
        elsewhere.file("s.toml", json_of(folder.path() / "out/f.json").at("scene").get<std::string>());
        const ProgramResult second =
            run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, {elsewhere.path(), {}, {}, {}});
        EXPECT_EQ(second.exit_code, 0) << second.err << body;
        if (second.exit_code != 0) continue;
        nlohmann::json one = json_of(folder.path() / "out/f.json");
        nlohmann::json other = json_of(elsewhere.path() / "out/f.json");
        // What is known of its accuracy depends on what was left to be decided.
        one.erase("accuracy");
        other.erase("accuracy");
        EXPECT_EQ(other, one) << body;
        EXPECT_TRUE(file_bytes(elsewhere.path() / "out/f.exr") == file_bytes(folder.path() / "out/f.exr")) << body;
    }
}

// Word by word and many more: tests/nacre/scene/layered_scene_test.cpp.
TEST(BadLayersOfTheProgram, AreToldWithExitCodeTwoAndNothingIsWritten) {
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {film_with("1.5", "-1"), "s.toml:4:16 [material.f]: thickness_nm = -1 is out of range; allowed [0, 1e+08] nm"},
        {film_with("\"late.csv\""),
         "s.toml:3:9 [material.f]: \"late.csv\" is known from 450 to 900 nm, and the light needs 360 to 830 nm; narrow "
         "[light] range_nm, or write outside = \"hold\" to go on with its end values"},
        {film_with("\"no.yml\""), "no.yml:1: a key is not a word; a key must be a word"},
        {std::string(good_film) + "[accuracy]\nnodes = [16, 32]\n",
         "s.toml:6:9 [accuracy]: nodes has 2 numbers; give one, or 4: for angles up to 72.5, 87.1, 89.8 and 90 "
         "degrees"}};
    for (const auto& [scene, message] : mistakes) {
        const TemporaryFolder folder;
        folder.file("late.csv", late_csv);
        folder.file("no.yml", "[ this: is {no yaml\n");
        folder.file("s.toml", scene);
        const auto before = folder.names();
        const ProgramResult result = run_nacre({"bake", "s.toml", "-o", "out"}, {folder.path(), {}, {}, {}});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.err, "nacre: " + message + "\n");
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(folder.names(), before);
    }
}

TEST(BadAngle, IsOneLine) {
    const TemporaryFolder folder;
    folder.file("s.toml", good_film);
    for (const std::string angle : {"91", "-1", "nan"}) {
        const ProgramResult result = run_nacre({"spectrum", "s.toml", "--angle", angle}, {folder.path(), {}, {}, {}});
        EXPECT_EQ(result.exit_code, 2) << angle;
        EXPECT_EQ(result.out, "") << angle;
        EXPECT_EQ(result.err, "nacre: --angle: angle " + angle + " is out of range; allowed [0, 90] degrees\n");
    }
    for (const std::string angle : {"90"}) {
        const ProgramResult result = run_nacre({"spectrum", "s.toml", "--angle", angle}, {folder.path(), {}, {}, {}});
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
}

TEST(BadPointsOfALayer, WavelengthAtWhichAMaterialIsNotKnownIsOneLineAndNothingIsPrinted) {
    const TemporaryFolder folder;
    folder.file("late.csv", late_csv);
    folder.file("s.toml", film_with("\"late.csv\"") + "[light]\nrange_nm = [500, 700]\n");
    folder.file("p.csv", "f,0,600\nf,0,400\n");
    const ProgramResult result = run_nacre({"spectrum", "s.toml", "--points", "p.csv"}, {folder.path(), {}, {}, {}});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(
        result.err,
        "nacre: p.csv:2:5: wavelength 400 nm lies outside what is known of \"late.csv\" in material \"f\"; allowed "
        "[450, 900] nm\n");
}

TEST(BadPointsOfALayer, WavelengthsBeyondTheLightAreAnsweredTrulyOrRefused) {
    // The file says n at 400 and 800 nm, whatever range the light has.
    const TemporaryFolder folder;
    folder.file("wide.csv", wide_csv);
    folder.file("p.csv", "f,0,400\nf,0,550\nf,0,800\n");
    folder.file("s.toml", film_with("\"wide.csv\""));
    folder.file("narrow.toml", film_with("\"wide.csv\"") + "[light]\nrange_nm = [500, 600]\n");
    const ProgramResult wide = run_nacre({"spectrum", "s.toml", "--points", "p.csv"}, {folder.path(), {}, {}, {}});
    const ProgramResult narrow =
        run_nacre({"spectrum", "narrow.toml", "--points", "p.csv"}, {folder.path(), {}, {}, {}});
    EXPECT_EQ(wide.exit_code, 0) << wide.err;
    if (narrow.exit_code != 2) {
        EXPECT_EQ(narrow.out, wide.out);
    }
}

}  // namespace
}  // namespace nacre::test
