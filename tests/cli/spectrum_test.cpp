// `nacre spectrum`: the exact model as numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "nacre/accuracy/exact_colour.h"
#include "nacre/colour/illuminant.h"
#include "nacre/lut/bake.h"
#include "reference/colour.h"
#include "reference/model.h"
#include "reference/random_scenes.h"
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

// ---- ranges

// The text of one column, without the heading.
std::vector<std::string> column_of(const std::string& csv, std::size_t column) {
    std::vector<std::string> texts;
    for (const std::vector<std::string>& row : rows_of(csv)) texts.push_back(row.at(column));
    if (!texts.empty()) texts.erase(texts.begin());
    return texts;
}

std::string error_of(const std::vector<std::string>& arguments, const TemporaryFolder& folder) {
    const ProgramResult result = run_nacre(arguments, {folder.path(), {}, {}, {}});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    return result.err;
}

TEST(SpectrumRanges, MixWithSingleAngles) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    const ProgramOptions here{folder.path(), {}, {}, {}};
    EXPECT_EQ(column_of(run_nacre({"spectrum", "s.toml", "--xyz", "--angle", "0:90:30", "45"}, here).out, 1),
              (std::vector<std::string>{"0", "30", "60", "90", "45"}));
    EXPECT_EQ(column_of(run_nacre({"spectrum", "s.toml", "--xyz", "--angle", "0.1:0.5:0.1,89.9:90:0.3"}, here).out, 1),
              (std::vector<std::string>{"0.1", "0.2", "0.3", "0.4", "0.5", "89.9"}));
}

TEST(SpectrumRanges, HaveThreeNumbersThatLeadUpwards) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    const auto refusal = [&](const std::string& word) {
        return error_of({"spectrum", "s.toml", "--angle", word}, folder);
    };
    const std::string remedy = "; write a number or FIRST:LAST:STEP, for example 0:90:5\n";
    EXPECT_EQ(refusal("x"), "nacre: --angle \"x\" is not a number" + remedy);
    EXPECT_EQ(refusal("0:90"), "nacre: --angle \"0:90\" is not a range" + remedy);
    EXPECT_EQ(refusal("0:90:5:1"), "nacre: --angle \"0:90:5:1\" is not a range" + remedy);
    EXPECT_EQ(refusal("0:inf:5"), "nacre: --angle \"0:inf:5\" is not a range" + remedy);
    EXPECT_EQ(refusal("0:90:0"), "nacre: --angle \"0:90:0\" has no step above 0" + remedy);
    EXPECT_EQ(refusal("90:0:5"), "nacre: --angle \"90:0:5\" ends before it begins" + remedy);
    EXPECT_EQ(refusal("0:90:1e-9"), "nacre: --angle \"0:90:1e-9\" has more than a million numbers" + remedy);
    EXPECT_EQ(refusal("0:95:5"), "nacre: --angle: angle 95 is out of range; allowed [0, 90] degrees\n");
}

TEST(SpectrumStep, IsThatOfTheWavelengths) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(scene) + "[light]\nrange_nm = [400, 401]\nadapt = \"none\"\n");
    const ProgramOptions here{folder.path(), {}, {}, {}};
    EXPECT_EQ(column_of(run_nacre({"spectrum", "s.toml", "--step", "0.3"}, here).out, 2),
              (std::vector<std::string>{"400", "400.3", "400.6", "400.9"}));
    EXPECT_EQ(column_of(run_nacre({"spectrum", "s.toml", "--step", "5"}, here).out, 2),
              (std::vector<std::string>{"400"}));
    EXPECT_EQ(error_of({"spectrum", "s.toml", "--step", "0"}, folder),
              "nacre: --step \"0\" is out of range; allowed [0.001, 470]; see nacre spectrum --help\n");
}

// ---- RGB

constexpr const char* water_film =
    "[material.water]\nmechanism = \"film\"\nindex = 1.33\nthickness_nm = 900\nsubstrate = 1.0\n";

Film water(double thickness_nm) {
    Film film;
    film.index = 1.33;
    film.substrate = 1.0;
    film.thickness_nm = thickness_nm;
    return film;
}

std::vector<double> numbers_of(const std::vector<std::string>& row, std::size_t first) {
    std::vector<double> numbers;
    for (std::size_t i = first; i < row.size(); ++i) numbers.push_back(std::stod(row[i]));
    return numbers;
}

TEST(SpectrumRgb, IsTheModelsColourInTheSpaceOfTheScene) {
    const TemporaryFolder folder;
    folder.file("rec709.toml", water_film);
    folder.file("p3.toml", std::string(water_film) + "[colour]\nspace = \"lin_p3d65\"\n");
    const reference::Model model({"", water(900.0)}, 1e-5);
    const auto rgb_of = [&](const char* file, const char* angle) {
        const ProgramResult result =
            run_nacre({"spectrum", file, "--rgb", "--angle", angle}, {folder.path(), {}, {}, {}});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const auto rows = rows_of(result.out);
        EXPECT_EQ(rows.at(0), (std::vector<std::string>{"material", "angle_deg", "R", "G", "B"}));
        const std::vector<double> numbers = numbers_of(rows.at(1), 2);
        return reference::ModelRgb{numbers.at(0), numbers.at(1), numbers.at(2)};
    };
    for (const char* angle : {"0", "30", "60"}) {
        const reference::ModelXyz meant = model.at(std::sqrt(std::cos(std::stod(angle) * std::numbers::pi / 180.0)));
        const reference::ModelXyz of_rec709 = reference::from_rec709(rgb_of("rec709.toml", angle));
        const reference::ModelXyz of_p3 = reference::from_p3d65(rgb_of("p3.toml", angle));
        for (const reference::ModelXyz& seen : {of_rec709, of_p3}) {
            EXPECT_NEAR(seen.x, meant.x, 2e-6) << angle;
            EXPECT_NEAR(seen.y, meant.y, 2e-6) << angle;
            EXPECT_NEAR(seen.z, meant.z, 2e-6) << angle;
        }
    }
}

TEST(SpectrumRgb, FollowsTheGamutOfTheScene) {
    const TemporaryFolder folder;
    folder.file("keep.toml", scene);
    folder.file("clip.toml", std::string(scene) + "[colour]\ngamut = \"clip\"\n");
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const auto keep = rows_of(run_nacre({"spectrum", "keep.toml", "--rgb"}, here).out);
    const auto clip = rows_of(run_nacre({"spectrum", "clip.toml", "--rgb"}, here).out);
    EXPECT_LT(std::stod(keep.at(1).at(2)), -1e-3);
    EXPECT_EQ(clip.at(1).at(2), "0");
    EXPECT_EQ(clip.at(1).at(4), keep.at(1).at(4));
}

TEST(SpectrumRgb, IsOneThingAndXyzAnother) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    EXPECT_EQ(error_of({"spectrum", "s.toml", "--rgb", "--xyz"}, folder),
              "nacre: --xyz excludes --rgb; see nacre spectrum --help\n");
}

// Digits of the tables of k in scene files make some 1e-5 of a reflectance.
TEST(SpectrumXyz, IsTheModelsColourForRandomLayers) {
    const TemporaryFolder folder;
    const std::vector<reference::ModelScene> scenes = reference::random_layers();
    for (std::size_t i = 1; i < scenes.size(); i += 12) {
        const reference::ModelScene& random = scenes[i];
        folder.file("s.toml", reference::scene_text(random));
        const ProgramResult result =
            run_nacre({"spectrum", "s.toml", "--xyz", "--angle", "10", "65"}, {folder.path(), {}, {}, {}});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        reference::ModelScene by_sqrt_cos = random;
        by_sqrt_cos.x = reference::ModelAxis::sqrt_cos_theta;
        const reference::Model model(by_sqrt_cos, 1e-4);
        for (const std::size_t row : {1u, 2u}) {
            const std::vector<std::string> fields = rows_of(result.out).at(row);
            const std::vector<double> seen = numbers_of(fields, 5);
            const double x = std::sqrt(std::cos(std::stod(fields.at(1)) * std::numbers::pi / 180.0));
            const reference::ModelXyz meant = model.at(x);
            EXPECT_LT(reference::difference({seen.at(0), seen.at(1), seen.at(2)}, meant,
                                            reference::scale_of_brightest(meant.y)),
                      2e-3)
                << fields.at(1) << "\n"
                << reference::scene_text(random);
        }
    }
}

// ---- points with a heading

TEST(SpectrumPoints, TakeParametersAsColumnsInAnyOrder) {
    const TemporaryFolder folder;
    folder.file("s.toml", water_film);
    folder.file("p.csv",
                "angle_deg,thickness_nm,material,wavelength_nm,substrate.n\n"
                "30,250.5,water,500,\n0,,water,600,\n60,100,water,700,1.52\n");
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult result = run_nacre({"spectrum", "s.toml", "--points", "p.csv"}, here);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto rows = rows_of(result.out);
    EXPECT_EQ(rows.at(0), (std::vector<std::string>{"angle_deg", "thickness_nm", "material", "wavelength_nm",
                                                    "substrate.n", "R_s", "R_p", "T_s", "T_p"}));
    Film on_glass = water(100.0);
    on_glass.substrate = 1.52;
    const auto expect_row = [&](std::size_t row, const Mechanism& film, double angle_deg, double nm) {
        const std::vector<double> seen = numbers_of(rows.at(row), 5);
        const double cos_theta = std::cos(angle_deg * std::numbers::pi / 180.0);
        EXPECT_NEAR(0.5 * (seen.at(0) + seen.at(1)), reference::reflectance(film, cos_theta, nm), 1e-13) << row;
    };
    expect_row(1, water(250.5), 30.0, 500.0);
    expect_row(2, water(900.0), 0.0, 600.0);
    expect_row(3, on_glass, 60.0, 700.0);

    const auto json = nlohmann::json::parse(run_nacre({"spectrum", "s.toml", "--points", "p.csv", "--json"}, here).out);
    EXPECT_EQ(json[0]["thickness_nm"], 250.5);
    EXPECT_TRUE(json[1]["thickness_nm"].is_null());
    EXPECT_EQ(json[1]["material"], "water");
}

TEST(SpectrumPoints, GiveTheColoursOfParametersToo) {
    const TemporaryFolder folder;
    folder.file("s.toml", water_film);
    folder.file("p.csv", "material,angle_deg,thickness_nm\nwater,40,250\nwater,40,251\n");
    const ProgramResult result =
        run_nacre({"spectrum", "s.toml", "--xyz", "--points", "p.csv"}, {folder.path(), {}, {}, {}});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto rows = rows_of(result.out);
    for (const std::size_t row : {1u, 2u}) {
        const reference::Model model({"", water(249.0 + static_cast<double>(row))}, 1e-6);
        const reference::ModelXyz meant = model.at(std::sqrt(std::cos(40.0 * std::numbers::pi / 180.0)));
        const std::vector<double> seen = numbers_of(rows.at(row), 6);
        EXPECT_NEAR(seen.at(0), meant.x, 1e-7);
        EXPECT_NEAR(seen.at(1), meant.y, 1e-7);
        EXPECT_NEAR(seen.at(2), meant.z, 1e-7);
    }
}

TEST(SpectrumPoints, SayWhatIsWrongWithAHeadingOrAParameter) {
    const TemporaryFolder folder;
    folder.file("s.toml", water_film);
    folder.file("palette.toml", scene);
    const auto refusal = [&](const std::string& points, std::vector<std::string> more = {}) {
        folder.file("p.csv", points);
        more.insert(more.begin(), {"spectrum", "s.toml", "--points", "p.csv"});
        return error_of(more, folder);
    };
    const std::string allowed =
        "; a heading names material, angle_deg or grating_u, wavelength_nm unless colours are asked for, and any "
        "parameters of the materials\n";
    EXPECT_EQ(refusal("angle_deg,wavelength_nm\n0,500\n"), "nacre: p.csv:1:1: there is no column material" + allowed);
    EXPECT_EQ(refusal("material,angle_deg\nwater,0\n"), "nacre: p.csv:1:1: there is no column wavelength_nm" + allowed);
    EXPECT_EQ(refusal("material,angle_deg,grating_u,wavelength_nm\n"),
              "nacre: p.csv:1:1: angle_deg and grating_u are one too many" + allowed);
    EXPECT_EQ(refusal("material,angle_deg,angle_deg\n"), "nacre: p.csv:1:20: column \"angle_deg\" is given twice\n");
    EXPECT_EQ(
        refusal("material,angle_deg,wavelength_nm\n", {"--rgb"}),
        "nacre: p.csv:1:20: a colour has no wavelength; leave out the column wavelength_nm, or --xyz and --rgb\n");
    EXPECT_EQ(refusal("material,angle_deg,wavelength_nm,width_nm\nwater,0,500,20\n"),
              "nacre: p.csv:2:13: mechanism film has no parameter \"width_nm\"; known: thickness_nm, "
              "thickness_spread_nm, n, k, substrate.n, substrate.k, tilt_deg, roughness\n");
    EXPECT_EQ(refusal("material,angle_deg,wavelength_nm,thickness_nm\nwater,0,500,-20\n"),
              "nacre: p.csv:2:13: thickness_nm = -20 is out of range; allowed [0, 1e+08] nm\n");
    EXPECT_EQ(refusal("material,grating_u,wavelength_nm\nwater,0,500\n"),
              "nacre: p.csv:2:7: material \"water\" is a film, and only a grating has grating_u; give angle_deg\n");
    folder.file("q.csv", "material,angle_deg,picks[0].angle_deg\nmorpho,0,40\n");
    EXPECT_EQ(
        error_of({"spectrum", "palette.toml", "--xyz", "--points", "q.csv"}, folder),
        "nacre: q.csv:2:10: picks[0].angle_deg from 40 to 40 passes picks[1] at 40 degrees; two picks at one angle "
        "have no colour between them\n");
}

// ---- gratings

// One order of each sign, 0.3 of the light in either, 20 grooves of 500 nm, straight over 1 micrometre.
constexpr const char* ruled =
    "[material.ruled]\nmechanism = \"grating\"\nperiod_nm = 500\ngrooves = 20\n"
    "efficiency = [0.3]\ngroove_length_um = 1\n"
    "[material.flat]\nmechanism = \"film\"\nindex = 1.5\nthickness_nm = 0\n";

double power_of_ruled(double u, double azimuth_deg, double nm) {
    const double pi = std::numbers::pi;
    const double azimuth = azimuth_deg * pi / 180.0;
    double power = 0.0;
    for (const int order : {-1, 1}) {
        const double t = pi * 20.0 * (u * std::cos(azimuth) * 500.0 / nm - order);
        const double sinc = t == 0.0 ? 1.0 : std::sin(t) / t;
        power += 0.3 * 20.0 * 500.0 / nm * sinc * sinc;
    }
    const double beside = u * std::sin(azimuth) * 1000.0 / nm;
    return power * std::exp(-pi * beside * beside);
}

TEST(SpectrumOfGratings, HasAllOfUAndEveryAzimuth) {
    const TemporaryFolder folder;
    folder.file("s.toml", ruled);
    folder.file("p.csv",
                "material,grating_u,azimuth_deg,wavelength_nm\nruled,1.3,0,640\nruled,-1.3,5,650\nruled,2,40,770\n"
                "ruled,1.9,,700\n");
    const ProgramResult result = run_nacre({"spectrum", "s.toml", "--points", "p.csv"}, {folder.path(), {}, {}, {}});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto rows = rows_of(result.out);
    const double expected[] = {power_of_ruled(1.3, 0, 640), power_of_ruled(1.3, 5, 650), power_of_ruled(2, 40, 770),
                               power_of_ruled(1.9, 0, 700)};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(std::stod(rows.at(i + 1).at(4)), expected[i], 1e-12 * (1.0 + expected[i])) << i;
}

TEST(SpectrumOfGratings, TakesRangesOfU) {
    const TemporaryFolder folder;
    folder.file("s.toml", ruled);
    folder.file("film.toml", water_film);
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const ProgramResult result = run_nacre(
        {"spectrum", "s.toml", "--grating-u", "1:2:0.5", "--step", "470", "--set", "material.ruled.azimuth_deg=10"},
        here);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto rows = rows_of(result.out);
    EXPECT_EQ(rows.at(0), (std::vector<std::string>{"material", "grating_u", "wavelength_nm", "R_s", "R_p", "R"}));
    ASSERT_EQ(rows.size(), 7u) << "the grating alone: three times two wavelengths";
    for (std::size_t row = 1; row < rows.size(); ++row) {
        const double expected = power_of_ruled(std::stod(rows[row][1]), 10.0, std::stod(rows[row][2]));
        EXPECT_NEAR(std::stod(rows[row][5]), expected, 1e-12 * (1.0 + expected)) << row;
    }
    EXPECT_EQ(error_of({"spectrum", "s.toml", "--grating-u", "2.1"}, folder),
              "nacre: --grating-u: grating_u 2.1 is out of range; allowed [-2, 2]\n");
    EXPECT_EQ(error_of({"spectrum", "s.toml", "--grating-u", "1", "--material", "flat"}, folder),
              "nacre: --grating-u: material \"flat\" is a film, and only a grating has grating_u; give angle_deg\n");
    EXPECT_EQ(error_of({"spectrum", "film.toml", "--grating-u", "1"}, folder),
              "nacre: --grating-u: the scene has no grating; give --angle\n");
}

// ---- thick layers

constexpr const char* thick_glass =
    "[material.glass]\nmechanism = \"stack\"\nsubstrate = 1.0\nlayers = [ { index = 1.5, thickness_nm = 1e7 } ]\n";

// A point needs no sampling, so it may have any number of fringes: Airy's formula at normal incidence.
TEST(SpectrumOfThickLayers, IsThatOfEveryWavelengthByItself) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string(thick_glass) +
                              "[lut.glass]\ny = { parameter = \"layers[0].thickness_nm\", "
                              "from = 1e6, to = 1e7 }\n");
    folder.file("p.csv", "glass,0,500.001\nglass,0,550.0003\nglass,0,612.3456\n");
    const ProgramResult result = run_nacre({"spectrum", "s.toml", "--points", "p.csv"}, {folder.path(), {}, {}, {}});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const auto& row : {rows_of(result.out).at(1), rows_of(result.out).at(2), rows_of(result.out).at(3)}) {
        const double phase = 2.0 * std::numbers::pi * 1.5 * 1e7 / std::stod(row.at(2));
        const double face = 0.04;  // (0.5 / 2.5)^2
        const double bounces = 4.0 * face * std::pow(std::sin(phase), 2);
        EXPECT_NEAR(std::stod(row.at(3)), bounces / (std::pow(1.0 - face, 2) + bounces), 1e-10);
    }
}

TEST(SpectrumOfThickLayers, IsNoColour) {
    const TemporaryFolder folder;
    folder.file("s.toml", thick_glass);
    folder.file("p.csv", "material,angle_deg,layers[0].thickness_nm\nglass,0,1000\nglass,0,\n");
    const std::string why =
        ": the layers of material \"glass\" are so thick that 47200 fringes lie in range_nm, and a colour can have at "
        "most 32768; in a stack, mark thick layers with incoherent = true\n";
    EXPECT_EQ(error_of({"spectrum", "s.toml", "--xyz"}, folder), "nacre: s.toml:1:11" + why);
    EXPECT_EQ(error_of({"spectrum", "s.toml", "--rgb", "--points", "p.csv"}, folder), "nacre: p.csv:3:1" + why);
}

}  // namespace
}  // namespace nacre::test
