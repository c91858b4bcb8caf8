// `nacre spectrum`: the exact model as numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "nacre/accuracy/exact_colour.h"
#include "nacre/colour/illuminant.h"
#include "nacre/lut/bake.h"
#include "support/program.h"

namespace nacre::test {
namespace {

constexpr const char* scene =
    "[material.morpho]\n"
    "picks = [ { angle_deg = 0,  peak_nm = 460, width_nm = 70, height = 1.0 },\n"
    "          { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n";

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string>& row = rows.emplace_back();
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
    }
    return rows;
}

TEST(Spectrum, PointsGiveTheLobesThatWerePicked) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    folder.file("p.csv",
                "material,angle_deg,wavelength_nm\nmorpho,0,460\nmorpho,0,470.5\nmorpho,40,395\nmorpho,40,424."
                "9\nmorpho,0,425\n");
    const ProgramResult result = run_nacre({"spectrum", "s.toml", "--points", "p.csv"}, {folder.path(), {}, {}, {}});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto rows = rows_of(result.out);
    ASSERT_EQ(rows.size(), 6u);
    EXPECT_EQ(rows[0],
              (std::vector<std::string>{"material", "angle_deg", "wavelength_nm", "R_s", "R_p", "T_s", "T_p"}));
    const double pi = std::numbers::pi;
    const double expected[] = {1.0, std::cos(pi * 10.5 / 70), 0.7, 0.7 * std::cos(pi * 29.9 / 60), 0.0};
    for (std::size_t i = 0; i < 5; ++i) {
        ASSERT_EQ(rows[i + 1].size(), 7u);
        EXPECT_NEAR(std::stod(rows[i + 1][3]), expected[i], 1e-14);
        EXPECT_EQ(rows[i + 1][3], rows[i + 1][4]) << "a palette knows no polarisation";
        EXPECT_EQ(std::stod(rows[i + 1][5]), 0.0) << "and lets nothing through";
    }
}

TEST(Spectrum, XyzComesBeforeAndAfterAdaptationWithAllItsDigits) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(scene) + "[light]\nilluminant = \"A\"\n");
    folder.file("p.csv", "morpho,0\nmorpho,17.25\n");
    const ProgramResult result =
        run_nacre({"spectrum", "s.toml", "--xyz", "--points", "p.csv"}, {folder.path(), {}, {}, {}});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto rows = rows_of(result.out);
    ASSERT_EQ(rows.size(), 3u);
    LightSettings settings;
    settings.power = *illuminant_by_name("A");
    const Light light = make_light(settings);
    const Palette palette{{{0, {460, 70, 1}}, {40, {395, 60, 0.7}}}};
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const Xyz seen = reflectance_xyz(palette, Incidence::from_degrees(std::stod(rows[i][1])), light);
        const Xyz adapted = adapt(light.adaptation, seen);
        // Two builds of one source may round a SIMD sum differently; nothing else may differ.
        EXPECT_NEAR(std::stod(rows[i][2]), seen.x, 1e-15);
        EXPECT_NEAR(std::stod(rows[i][4]), seen.z, 1e-15);
        EXPECT_NEAR(std::stod(rows[i][5]), adapted.x, 1e-15);
        EXPECT_NEAR(std::stod(rows[i][7]), adapted.z, 1e-15);
    }
}

TEST(Spectrum, OneRowPerNanometreOfTheRangeAndAngle) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(scene) + "[light]\nrange_nm = [400, 700]\n");
    const ProgramResult result = run_nacre({"spectrum", "s.toml", "--angle", "0", "40"}, {folder.path(), {}, {}, {}});
    EXPECT_EQ(rows_of(result.out).size(), 1u + 2u * 301u);
    const ProgramResult json = run_nacre({"spectrum", "s.toml", "--json", "--xyz"}, {folder.path(), {}, {}, {}});
    EXPECT_EQ(nlohmann::json::parse(json.out).size(), 1u);
}

}  // namespace
}  // namespace nacre::test
