// What is seen through layers: `quantity` of a LUT, from the scene to the files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "support/folders.h"
#include "support/program.h"
#include "support/written_lut.h"

namespace nacre::test {
namespace {

const std::string film = "[material.m]\nmechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\n";

ProgramResult run_in(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
    return run_nacre(arguments, {folder.path(), {}, {}, {}});
}

// The names of the LUTs that a scene has, one behind the other.
std::string luts_of(const std::string& scene, const std::vector<std::string>& more = {}) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    std::vector<std::string> arguments{"bake", "s.toml", "-o", "out", "--no-preview"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = run_in(folder, arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::string names;
    for (const auto& file : std::filesystem::directory_iterator(folder.path() / "out")) {
        if (file.path().extension() == ".exr") names += " " + file.path().stem().string();
    }
    std::vector<std::string> sorted;
    for (std::size_t at = 0; at < names.size();) {
        const std::size_t end = std::min(names.find(' ', at + 1), names.size());
        sorted.push_back(names.substr(at + 1, end - at - 1));
        at = end;
    }
    std::sort(sorted.begin(), sorted.end());
    names.clear();
    for (const std::string& name : sorted) names += (names.empty() ? "" : " ") + name;
    return names;
}

TEST(Quantity, OfBothMakesTwoLutsAndFourOfBothPolarisations) {
    const std::string both = "[lut.a]\nquantity = \"both\"\n";
    EXPECT_EQ(luts_of(film + both), "a_r a_t");
    EXPECT_EQ(luts_of(film + "polarisation = \"both\"\n" + both), "a_p_r a_p_t a_s_r a_s_t");
    EXPECT_EQ(luts_of(film + both + "[lut.b]\n"), "a_r a_t b");
    EXPECT_EQ(luts_of(film + both + "[lut.b]\n", {"--only", "a"}), "a_r a_t");
    EXPECT_EQ(luts_of(film + both + "[lut.b]\n", {"--only", "a_t,b"}), "a_t b");
    EXPECT_EQ(luts_of(film + "polarisation = \"both\"\n" + both, {"--only", "a_s"}), "a_s_r a_s_t");
    const std::string variants = "[variants]\nthick = { material.m.thickness_nm = 500 }\n";
    EXPECT_EQ(luts_of(film + both + variants), "thick_r thick_t");
}

std::vector<double> numbers_of(const reference::Pixels& pixels) {
    std::vector<double> numbers;
    for (const reference::ModelRgb& rgb : pixels.rgb) numbers.insert(numbers.end(), rgb.begin(), rgb.end());
    return numbers;
}

TEST(Quantity, FilesOfBothAreOfOneSizeAndTheirSumIsWhite) {
    const TemporaryFolder folder;
    folder.file("s.toml", film +
                              "substrate = { n = 0.3, k = 3 }\n[lut.a]\nquantity = \"both\"\n[lut.b]\n"
                              "quantity = \"transmittance\"\n");
    ASSERT_EQ(run_in(folder, {"bake", "s.toml", "-o", "out", "--no-preview"}).exit_code, 0);
    const auto r = read_written_lut(folder.path() / "out/a_r.exr"), t = read_written_lut(folder.path() / "out/a_t.exr");
    ASSERT_TRUE(r && t);
    ASSERT_EQ(r->pixels.width, t->pixels.width);
    ASSERT_EQ(r->format, t->format);
    const std::vector<double> reflected = numbers_of(r->pixels), transmitted = numbers_of(t->pixels);
    const auto rounding = [](double value) { return std::ldexp(1.0, std::max(std::ilogb(value), -14) - 11); };
    for (std::size_t i = 0; i < reflected.size(); ++i)
        EXPECT_NEAR(reflected[i] + transmitted[i], 1.0, rounding(reflected[i]) + rounding(transmitted[i]) + 1e-9) << i;

    // Each of them is the same whether the other is wanted or not.
    ASSERT_EQ(run_in(folder, {"bake", "s.toml", "-o", "one", "--no-preview", "--only", "a_t"}).exit_code, 0);
    EXPECT_EQ(file_bytes(folder.path() / "one/a_t.exr"), file_bytes(folder.path() / "out/a_t.exr"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "one/a_r.exr"));

    const ProgramResult verified = run_in(folder, {"verify", "out/a_r.exr", "out/a_t.exr", "out/b.exr"});
    EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
    EXPECT_NE(file_bytes(folder.path() / "out/a_t.json").find("\"quantity\": \"transmittance\""), std::string::npos);
    EXPECT_EQ(file_bytes(folder.path() / "out/a_r.json").find("quantity"), std::string::npos);
}

TEST(Quantity, OfASpectrumIsTheRestOfTheReflectance) {
    const TemporaryFolder folder;
    folder.file("s.toml",
                film + "[material.p]\npicks = [ { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1 } ]\n");
    const auto column = [&](const std::vector<std::string>& more, const std::string& heading) {
        std::vector<std::string> arguments{"spectrum", "s.toml", "--angle", "50", "--material", "m"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = run_in(folder, arguments);
        EXPECT_EQ(result.out.substr(0, result.out.find('\n')), heading) << result.err;
        std::vector<double> last;
        for (std::size_t at = result.out.find('\n'); at + 1 < result.out.size();) {
            const std::size_t end = result.out.find('\n', at + 1);
            last.push_back(std::stod(result.out.substr(result.out.rfind(',', end) + 1)));
            at = end;
        }
        return last;
    };
    const std::vector<double> r = column({}, "material,angle_deg,wavelength_nm,R_s,R_p,R");
    const std::vector<double> t = column({"--transmittance"}, "material,angle_deg,wavelength_nm,T_s,T_p,T");
    ASSERT_EQ(r.size(), 471u);
    ASSERT_EQ(t.size(), r.size());
    for (std::size_t i = 0; i < r.size(); ++i) EXPECT_NEAR(r[i] + t[i], 1.0, 1e-14);
    const double blue_r = column({"--rgb"}, "material,angle_deg,R,G,B").at(0);
    const double blue_t = column({"--rgb", "--transmittance"}, "material,angle_deg,R,G,B").at(0);
    EXPECT_NEAR(blue_r + blue_t, 1.0, 1e-6);
    EXPECT_EQ(run_in(folder, {"spectrum", "s.toml", "--transmittance", "--material", "p"}).err,
              "nacre: --material: material \"p\" lets no light through; --transmittance takes films, stacks and "
              "crystals without a base\n");
}

struct Mistake {
    const char* name;
    std::string scene;
    std::string message;  // behind "nacre: s.toml"
};
void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

class BadQuantity : public testing::TestWithParam<Mistake> {};

TEST_P(BadQuantity, IsOneLineWithWhatIsAllowed) {
    const TemporaryFolder folder;
    folder.file("s.toml", GetParam().scene);
    const ProgramResult result = run_in(folder, {"plan", "s.toml"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "nacre: s.toml" + GetParam().message + "\n");
}

std::string lut_of(const std::string& material, const std::string& quantity) {
    return "[lut.a]\nquantity = " + quantity + "\n[material.m]\n" + material;
}

const std::string through = "\"transmittance\"";
const std::string no_light = ", which lets no light through; allowed for a LUT of material \"m\": reflectance";
const std::string no_base =
    " has no meaning for layers with a base, through which nothing is seen; allowed for a LUT of material \"m\": "
    "reflectance";

const std::vector<Mistake> mistakes{
    {"OfAGrating", lut_of("mechanism = \"grating\"\nperiod_nm = 1600\ndepth_nm = 120\n", through),
     ":2:12 [lut.a]: quantity = \"transmittance\" has no meaning for mechanism grating" + no_light},
    {"OfAPalette", lut_of("picks = [ { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1 } ]\n", "\"both\""),
     ":2:12 [lut.a]: quantity = \"both\" has no meaning for mechanism palette" + no_light},
    {"OfScattering",
     lut_of("mechanism = \"scatter\"\nparticle = 1.5\nradius_nm = 20\nvolume_fraction = 0.1\nthickness_um = 5\n",
            through),
     ":2:12 [lut.a]: quantity = \"transmittance\" has no meaning for mechanism scatter" + no_light},
    {"OfAMeasurement",
     lut_of("mechanism = \"measured\"\nwavelength_nm = [360, 830]\nangle_deg = [0, 45]\n"
            "reflectance = [[0.1, 0.2], [0.2, 0.3]]\n",
            through),
     ":2:12 [lut.a]: quantity = \"transmittance\" has no meaning for mechanism measured" + no_light},
    {"WithABase", lut_of("mechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\nbase = 0.5\n", through),
     ":2:12 [lut.a]: quantity = \"transmittance\"" + no_base},
    {"WithAMetalBelow",
     lut_of("mechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\nbase = { metal = \"al\" }\n", "\"both\""),
     ":2:12 [lut.a]: quantity = \"both\"" + no_base},
    {"Unknown", lut_of("mechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\n", "\"transmission\""),
     ":2:12 [lut.a]: unknown quantity \"transmission\"; known: reflectance, transmittance, both"},
    {"ThatIsNoWord", lut_of("mechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\n", "1"),
     ":2:12 [lut.a]: quantity = 1 is a whole number; give a string"},
    {"UnderAnotherName", film + "[lut.a]\ntransmission = true\n",
     ":6:1 [lut.a]: unknown key \"transmission\"; did you mean quantity?"},
    {"InAPuddle", film + "[lut.a]\nquantity = \"transmittance\"\n[swatch.s]\ndraw = \"puddle\"\nlut = \"a\"\n",
     ":8:8 [swatch.s]: draw = \"puddle\" shows reflected light, and this lut is of transmittance; draw a sphere or a "
     "bubble"},
};
INSTANTIATE_TEST_SUITE_P(Mistakes, BadQuantity, testing::ValuesIn(mistakes),
                         [](const auto& mistake) { return std::string(mistake.param.name); });

// That it is no mistake to say what is so anyway.
TEST(Quantity, OfReflectanceMayBeSaidOfEveryMechanism) {
    const TemporaryFolder folder;
    folder.file("s.toml",
                lut_of("picks = [ { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1 } ]\n", "\"reflectance\""));
    EXPECT_EQ(run_in(folder, {"plan", "s.toml"}).exit_code, 0);
}

}  // namespace
}  // namespace nacre::test
