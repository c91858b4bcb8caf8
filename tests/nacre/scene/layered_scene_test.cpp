// Films and stacks as scenes: every form of every key comes back from a file's header, and every mistake is one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "io/scene/scene_file.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/error.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/lut/sampler.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/shade/spectra.h"
#include "support/folders.h"

namespace nacre::test {
namespace {

constexpr const char* film = "[material.f]\nmechanism = \"film\"\n";
constexpr const char* stack = "[material.f]\nmechanism = \"stack\"\n";
constexpr const char* good_film = "[material.f]\nmechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\n";
// Measured from 450 nm only, and with absorption.
constexpr const char* late_csv = "wavelength_nm,n\n450,1.5\n900,1.4\n";
constexpr const char* wide_csv =
    "wavelength_nm,n,k\n300,1.60,0\n400,1.55,0.01\n500,1.53,0\n600,1.52,0\n700,1.51,0.02\n800,1.50,0\n900,1.49,0\n";

// A form of what a scene may say of a material.
struct Form {
    const char* name;
    std::string scene;
    std::string toml = {};  // a line that the header has; empty: any
};

void PrintTo(const Form& form, std::ostream* out) {
    *out << form.name;
}

Plan plan_of(const TemporaryFolder& folder, const std::string& scene) {
    return plan_scene(read_scene_file(folder.file("s.toml", scene)), scene_files());
}

// That one material reflects as another does, to the bit.
void expect_same(const Mechanism& one, const Mechanism& other, const LightSettings& light) {
    std::vector<double> wavelengths_nm;
    for (int nm = light.first_nm; nm <= light.last_nm; nm += 23) wavelengths_nm.push_back(nm);
    wavelengths_nm.push_back(light.last_nm);
    for (const double theta_deg : {0.0, 37.0, 84.0}) {
        const Incidence incidence = Incidence::from_degrees(theta_deg);
        const auto a = responses_at(one, incidence, wavelengths_nm);
        const auto b = responses_at(other, incidence, wavelengths_nm);
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_EQ(a[i].reflectance_s, b[i].reflectance_s) << wavelengths_nm[i] << " nm, " << theta_deg;
            EXPECT_EQ(a[i].reflectance_p, b[i].reflectance_p) << wavelengths_nm[i] << " nm, " << theta_deg;
            EXPECT_EQ(a[i].transmittance_s, b[i].transmittance_s) << wavelengths_nm[i] << " nm, " << theta_deg;
        }
    }
}

class LayeredForm : public testing::TestWithParam<Form> {};

TEST_P(LayeredForm, ComesBackFromTheHeaderAsTheSameJob) {
    const TemporaryFolder folder;
    folder.file("late.csv", late_csv);
    folder.file("wide.csv", wide_csv);
    const Plan plan = plan_of(folder, GetParam().scene);
    ASSERT_EQ(plan.luts.size(), 1u);
    const std::string header = scene_toml(plan.luts[0]);
    EXPECT_NE(header.find(GetParam().toml), std::string::npos) << header;

    const TemporaryFolder elsewhere;  // where no file of the user's lies
    Plan read;
    try {
        read = plan_of(elsewhere, header);
    } catch (const Error& error) {
        FAIL() << error.what() << "\n" << header;
    }
    ASSERT_EQ(read.luts.size(), 1u);
    const Job& job = plan.luts[0].job;
    const Job& again = read.luts[0].job;
    EXPECT_EQ(scene_toml(read.luts[0]), header);
    EXPECT_EQ(again.material.name, job.material.name);
    EXPECT_EQ(again.width, job.width);
    EXPECT_EQ(again.height, job.height);
    EXPECT_EQ(again.fixed.incidence.theta_deg, job.fixed.incidence.theta_deg);
    EXPECT_EQ(again.x.parameter.name, job.x.parameter.name);
    EXPECT_EQ(again.x.from, job.x.from);
    EXPECT_EQ(again.x.to, job.x.to);
    ASSERT_EQ(again.y.has_value(), job.y.has_value());
    for (const double x : {0.0, 0.3, 1.0})
        expect_same(mechanism_at(job, x, 0.7), mechanism_at(again, x, 0.7), job.light->settings);
}

const std::vector<Form> forms{
    {"Film", good_film, "\nincident = 1\nindex = 1.5\nthickness_nm = 300\nsubstrate = 1\n\n"},
    {"FilmOfEverything",
     std::string(film) + "index = { n = 1.56, k = 0.06 }\nthickness_nm = 123.456\nincident = 1.33\nsubstrate = { n = "
                         "0.2, k = 3.4 }\nthickness_spread_nm = 4.5\n",
     "\nincident = 1.33\nindex = { n = 1.56, k = 0.06 }\nthickness_nm = 123.456\nsubstrate = { n = 0.2, k = 3.4 "
     "}\nthickness_spread_nm = 4.5\n"},
    {"NumberInATable", std::string(film) + "index = { n = 1.56 }\nthickness_nm = 100\n", "\nindex = 1.56\n"},
    {"NumbersThatHaveManyDigits",
     std::string(film) + "index = 1.3333333333333333\nthickness_nm = 0.1\nsubstrate = 1000\n"},
    {"NoThickness", std::string(film) + "index = 2\nthickness_nm = 0\nsubstrate = 1.5\n"},
    {"ShippedMaterials",
     std::string(film) + "incident = \"air\"\nindex = \"tio2\"\nthickness_nm = 80\nsubstrate = \"ag\"\n",
     "\nincident = \"air\"\nindex = \"tio2\"\nthickness_nm = 80\nsubstrate = \"ag\"\n"},
    {"ShippedMaterialThatHolds",
     std::string(film) + "index = { material = \"bk7\", outside = \"hold\" }\nthickness_nm = 80\n",
     "\nindex = { material = \"bk7\", outside = \"hold\" }\n"},
    {"ShippedMaterialThatMakesAnError",
     std::string(film) + "index = { material = \"bk7\", outside = \"error\" }\nthickness_nm = 80\n",
     "\nindex = \"bk7\"\n"},
    {"Csv", std::string(film) + "index = \"wide.csv\"\nthickness_nm = 300\n",
     "\nindex = { name = \"wide.csv\", wavelength_nm = [300, 400, 500, 600, 700, 800, 900], n = [1.6, 1.55, 1.53, "
     "1.52, 1.51, 1.5, 1.49], k = [0, 0.01, 0, 0, 0.02, 0, 0], range_nm = [300, 900] }\n"},
    {"CsvOfANarrowLight",
     std::string(film) + "index = \"wide.csv\"\nthickness_nm = 300\n[light]\nrange_nm = [450, 650]\n"},
    {"CsvThatHolds",
     std::string(film) + "index = { material = \"late.csv\", outside = \"hold\" }\nthickness_nm = 300\n",
     "\nindex = { name = \"late.csv\", wavelength_nm = [450, 900], n = [1.5, 1.4], range_nm = [450, 900], outside = "
     "\"hold\" }\n"},
    {"CsvThatHoldsInANarrowLight",
     std::string(film) +
         "index = { material = \"wide.csv\", outside = \"hold\" }\nthickness_nm = 300\n[light]\nrange_nm "
         "= [450, 650]\n"},
    {"Cauchy", std::string(film) + "index = { cauchy = [1.5, 0.004, 0.0001] }\nthickness_nm = 300\n"},
    {"CauchyOfItsRange",
     std::string(film) + "index = { cauchy = [1.5, 0.004, 0.0001], k = 0.02, range_nm = [300, 900], name = \"lacquer\" "
                         "}\nthickness_nm = 300\n",
     "\nindex = { name = \"lacquer\", formula = 5, coefficients = [1.5, 0.004, -2, 1e-04, -4], k = 0.02, range_nm = "
     "[300, 900] }\n"},
    {"CauchyOfOneTerm", std::string(film) + "index = { cauchy = [1.5], range_nm = [300, 900] }\nthickness_nm = 300\n"},
    {"Sellmeier",
     std::string(film) + "index = { sellmeier = [1.03961212, 0.00600069867, 0.231792344, 0.0200179144], range_nm = "
                         "[310, 2500] }\nthickness_nm = 300\n",
     "\nindex = { formula = 2, coefficients = [0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144], range_nm = "
     "[310, 2500] }\n"},
    {"Formula", std::string(film) +
                    "index = { formula = 3, coefficients = [2.2, 0.01, -2], range_nm = [300, 900] }\nthickness_nm "
                    "= 300\n"},
    {"Table",
     std::string(film) + "index = { wavelength_nm = [300, 500, 900], n = [1.6, 1.5, 1.4] }\nthickness_nm = 300\n",
     "\nindex = { wavelength_nm = [300, 500, 900], n = [1.6, 1.5, 1.4], range_nm = [300, 900] }\n"},
    {"TableOfBoth",
     std::string(film) + "index = { wavelength_nm = [300, 500, 900], n = [1.6, 1.5, 1.4], k = [0.1, 0, 0.3] "
                         "}\nthickness_nm = 300\n",
     "\nindex = { wavelength_nm = [300, 500, 900], n = [1.6, 1.5, 1.4], k = [0.1, 0, 0.3], range_nm = [300, 900] }\n"},
    {"TableWithOneK", std::string(film) +
                          "index = { wavelength_nm = [300, 500, 900], n = [1.6, 1.5, 1.4], k = 0.1 }\nthickness_nm = "
                          "300\n"},
    {"TableWithKOfItsOwn",
     std::string(film) +
         "index = { wavelength_nm = [300, 500, 900], n = [1.6, 1.5, 1.4], k_wavelength_nm = [350, 850], "
         "k = [0.1, 0.2] }\nthickness_nm = 300\n",
     "\nindex = { wavelength_nm = [300, 500, 900], n = [1.6, 1.5, 1.4], k_wavelength_nm = [350, 850], k = [0.1, 0.2], "
     "range_nm = [350, 850] }\n"},
    {"NumberWithKOfItsOwn",
     std::string(film) + "index = { n = 1.5, k_wavelength_nm = [350, 850], k = [0.1, 0.2] }\nthickness_nm = 300\n",
     "\nindex = { n = 1.5, k_wavelength_nm = [350, 850], k = [0.1, 0.2], range_nm = [350, 850] }\n"},
    {"CauchyWithKOfItsOwn",
     std::string(film) +
         "index = { cauchy = [1.5, 0.004], k_wavelength_nm = [350, 850], k = [0.1, 0.2] }\nthickness_nm "
         "= 300\n"},
    {"TableThatHolds",
     std::string(film) + "index = { wavelength_nm = [400, 700], n = [1.6, 1.4], outside = \"hold\" }\nthickness_nm = "
                         "300\n",
     "\nindex = { wavelength_nm = [400, 700], n = [1.6, 1.4], range_nm = [400, 700], outside = \"hold\" }\n"},
    {"TableOfPartOfItsRange",
     std::string(film) + "index = { wavelength_nm = [300, 500, 900], n = [1.6, 1.5, 1.4], range_nm = [400, 600], "
                         "outside = \"hold\" }\nthickness_nm = 300\n"},
    {"Stack", std::string(stack) + "layers = [ { index = 1.5, thickness_nm = 100 } ]\n",
     "\nlayers = [\n    { index = 1.5, thickness_nm = 100 },\n]\nsubstrate = 1\n"},
    {"StackThatSaysItsForm",
     std::string(stack) + "form = \"layers\"\nlayers = [ { index = 1.5, thickness_nm = 100, incoherent = false } ]\n"},
    {"StackOfEverything",
     std::string(stack) +
         "incident = 1.2\nsubstrate = \"si\"\nthickness_spread_nm = 2\nlayers = [ { index = { n = 1.56, k = 0.06 }, "
         "thickness_nm = 94 }, { index = \"sio2\", thickness_nm = 83 },\n  { index = { cauchy = [1.4, 0.003], range_nm "
         "= [300, 900] }, thickness_nm = 20 } ]\n",
     "\nthickness_spread_nm = 2\n"},
    {"Group",
     std::string(stack) + "layers = [ { repeat = 10, layers = [ { index = 1.5, thickness_nm = 100 }, { index = 1, "
                          "thickness_nm = 80 } ] } ]\n",
     "\nlayers = [\n    { repeat = 10, layers = [\n        { index = 1.5, thickness_nm = 100 },\n        { index = 1, "
     "thickness_nm = 80 },\n    ] },\n]\n"},
    {"GroupOfOne", std::string(stack) + "layers = [ { layers = [ { index = 1.5, thickness_nm = 100 } ] } ]\n",
     "repeat = 1, layers"},
    {"NestedGroups",
     std::string(stack) +
         "layers = [ { repeat = 3, layers = [ { index = 2, thickness_nm = 30 }, { repeat = 4, layers = [ { index = "
         "1.5, "
         "thickness_nm = 10 }, { repeat = 2, layers = [ { index = 1.4, thickness_nm = 5 } ] } ] } ] }, { index = 1.7, "
         "thickness_nm = 9 } ]\n"},
    {"GradedThickness",
     std::string(stack) + "layers = [ { repeat = 10, layers = [ { index = 1.5, thickness_nm = { from = 100, to = 200 } "
                          "}, { index = 1, thickness_nm = 80 } ] } ]\n",
     "{ index = 1.5, thickness_nm = { from = 100, to = 200 } }"},
    {"GradedIndex",
     std::string(stack) + "layers = [ { repeat = 5, layers = [ { index = { from = 1.5, to = { n = 2, k = 0.5 } }, "
                          "thickness_nm = { from = 100, to = 50.5 } } ] } ]\n",
     "{ index = { from = 1.5, to = { n = 2, k = 0.5 } }, thickness_nm = { from = 100, to = 50.5 } }"},
    {"GradedMaterials",
     std::string(stack) + "layers = [ { repeat = 5, layers = [ { index = { from = \"sio2\", to = { cauchy = [2, 0.01], "
                          "range_nm = [300, 900] } }, thickness_nm = 60 } ] } ]\n"},
    {"Incoherent",
     std::string(stack) +
         "layers = [ { index = 1.38, thickness_nm = 90 }, { index = 1.52, thickness_nm = 1e6, incoherent "
         "= true }, { index = 2.3, thickness_nm = 60 } ]\n",
     "{ index = 1.52, thickness_nm = 1e+06, incoherent = true }"},
    {"Lamellae", std::string(stack) + "form = \"lamellae\"\nfilm = { n = 1.56, k = 0.06 }\nfilm_nm = 94\ngap_nm = 83\n",
     "\nlayers = [\n    { repeat = 10, layers = [\n        { index = { n = 1.56, k = 0.06 }, thickness_nm = 94 },\n    "
     "  "
     "  { index = 1, thickness_nm = 83 },\n    ] },\n]\n"},
    {"LamellaeOfEverything",
     std::string(stack) + "form = \"lamellae\"\nfilm = \"chitin\"\nfilm_nm = 94\ngap = \"water\"\ngap_nm = 83\nfilms = "
                          "7\nthickness_spread_nm = 5\nsubstrate = 1.5\n"},
    {"ThicknessAsAnAxis",
     std::string(good_film) + "[lut.f]\nx = { parameter = \"thickness_nm\", from = 100, to = 900 }\nangle_deg = 20\n",
     "\nx = { parameter = \"thickness_nm\", from = 100, to = 900 }\nangle_deg = 20\n"},
    {"TwoParametersAsAxes",
     std::string(good_film) +
         "substrate = 1.7\n[lut.f]\nx = { parameter = \"n\", from = 1.2, to = 3 }\ny = { parameter "
         "= \"substrate.k\", from = 0, to = 4 }\nangle_deg = 20\n"},
    {"LayerOfAGroupAsAnAxis",
     std::string(stack) + "layers = [ { index = 2, thickness_nm = 9 }, { repeat = 4, layers = [ { index = 1.5, "
                          "thickness_nm = 100 }, { index = 1, thickness_nm = 80 } ] } ]\n[lut.f]\ny = { parameter = "
                          "\"layers[1].layers[1].thickness_nm\", from = 10, to = 90 }\n",
     "\nx = \"sqrt_cos_theta\"\ny = { parameter = \"layers[1].layers[1].thickness_nm\", from = 10, to = 90 }\n"},
    {"AbsorptionOfALayerAsAnAxis",
     std::string(stack) +
         "layers = [ { index = 2, thickness_nm = 9 } ]\n[lut.f]\nx = { parameter = \"layers[0].k\", from "
         "= 0, to = 2 }\n"},
    {"SpreadAsAnAxis", std::string(good_film) +
                           "[lut.f]\ny = { parameter = \"thickness_spread_nm\", from = 0, to = 20 }\nsize = [8, 4]\n"},
};

const auto name_of_case = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(Forms, LayeredForm, testing::ValuesIn(forms), name_of_case);

// What a parameter's axis makes of a material half way between its ends.
std::string half_way(const std::string& scene, const std::string& parameter, double from, double to) {
    const TemporaryFolder folder;
    const Plan plan = plan_of(folder, scene);
    Job job = plan.luts[0].job;
    job.x = parameter_axis(job.material.mechanism, parameter, from, to);
    return mechanism_toml(mechanism_at(job, 0.5, 0.0));
}

TEST(LayeredAxis, SetsTheNumberThatItNamesAndNoOther) {
    const auto film_toml = [](const std::string& index, const std::string& thickness, const std::string& substrate) {
        return "mechanism = \"film\"\nincident = 1\nindex = " + index + "\nthickness_nm = " + thickness +
               "\nsubstrate = " + substrate + "\n";
    };
    EXPECT_EQ(half_way(good_film, "thickness_nm", 100, 200), film_toml("1.5", "150", "1"));
    EXPECT_EQ(half_way(good_film, "n", 1, 4), film_toml("2.5", "300", "1"));
    EXPECT_EQ(half_way(good_film, "k", 0, 3), film_toml("{ n = 1.5, k = 1.5 }", "300", "1"));
    EXPECT_EQ(half_way(good_film, "substrate.n", 1, 2), film_toml("1.5", "300", "1.5"));
    EXPECT_EQ(half_way(good_film, "substrate.k", 0, 4), film_toml("1.5", "300", "{ n = 1, k = 2 }"));
    EXPECT_EQ(half_way(good_film, "thickness_spread_nm", 0, 4),
              film_toml("1.5", "300", "1") + "thickness_spread_nm = 2\n");
    const auto stack_toml = [](const std::string& first, const std::string& second) {
        return "mechanism = \"stack\"\nincident = 1\nlayers = [\n    " + first +
               ",\n    { repeat = 4, layers = [\n        " + second + ",\n    ] },\n]\nsubstrate = 1\n";
    };
    const std::string two = std::string(stack) +
                            "layers = [ { index = 2, thickness_nm = 9 }, { repeat = 4, layers = [ { index = 1.5, "
                            "thickness_nm = 100 } ] } ]\n";
    const std::string first = "{ index = 2, thickness_nm = 9 }";
    EXPECT_EQ(half_way(two, "layers[1].layers[0].thickness_nm", 10, 20),
              stack_toml(first, "{ index = 1.5, thickness_nm = 15 }"));
    EXPECT_EQ(half_way(two, "layers[1].layers[0].n", 1, 5), stack_toml(first, "{ index = 3, thickness_nm = 100 }"));
    EXPECT_EQ(half_way(two, "layers[0].k", 0, 3),
              stack_toml("{ index = { n = 2, k = 1.5 }, thickness_nm = 9 }", "{ index = 1.5, thickness_nm = 100 }"));
    EXPECT_EQ(half_way(two, "thickness_spread_nm", 0, 4),
              stack_toml(first, "{ index = 1.5, thickness_nm = 100 }") + "thickness_spread_nm = 2\n");
}

TEST(LayeredScene, OldPlacesOfSamplingCountsStillWorkWithAWarning) {
    const TemporaryFolder folder;
    const std::string film_scene(good_film);
    const Plan old = plan_of(folder, film_scene +
                                         "[accuracy]\nnodes = 64\nrealisations = 16\nbase_directions = 6\nradii = "
                                         "12\nslices = 8\n");
    const Plan now = plan_of(folder, film_scene +
                                         "[accuracy.sampling]\nnodes = 64\nthickness_samples = 16\nbase_directions = "
                                         "6\nradii = 12\nslices = 8\n");
    EXPECT_EQ(old.luts[0].request.sampling, now.luts[0].request.sampling);
    EXPECT_TRUE(now.warnings.empty());
    ASSERT_EQ(old.warnings.size(), 5u);
    const auto expect_warning = [&](std::size_t i, const std::string& text) {
        EXPECT_TRUE(
            old.warnings[i].ends_with(text + "in the table [accuracy.sampling]; a later version will not read it here"))
            << old.warnings[i];
    };
    expect_warning(0, "s.toml:6:1 [accuracy]: the key nodes is now ");
    expect_warning(1, "s.toml:7:1 [accuracy]: the key realisations is now thickness_samples, ");
    expect_warning(4, "s.toml:10:1 [accuracy]: the key slices is now ");
}

TEST(LayeredScene, IntegralHasNoEffectAnyMore) {
    const TemporaryFolder folder;
    for (const char* word : {"exact", "fast"}) {
        const Plan plan = plan_of(folder, std::string(good_film) + "[accuracy]\nintegral = \"" + word + "\"\n");
        ASSERT_EQ(plan.warnings.size(), 1u);
        EXPECT_TRUE(plan.warnings.front().ends_with(
            "s.toml:6:1 [accuracy]: the key integral has no effect any more, because the band of a palette is always "
            "integrated exactly; leave it out"))
            << plan.warnings.front();
    }
}

TEST(LayeredHeader, SaysWhereSpectraWereSampled) {
    const TemporaryFolder folder;
    const std::string rough =
        std::string(stack) + "thickness_spread_nm = 5\nlayers = [ { index = 1.5, thickness_nm = 300 } ]\n";
    for (const std::string nodes : {"nodes = 64", "nodes = [64, 64, 64, 64]", "nodes = [32, 64, 128, 128]"}) {
        Plan plan = plan_of(folder, rough + "[accuracy.sampling]\n" + nodes + "\nthickness_samples = 16\n");
        PlannedLut& lut = plan.luts[0];
        ASSERT_GT(lut.request.sampling.nodes.front(), 0);
        EXPECT_EQ(lut.request.sampling.thickness_samples, 16);
        lut.job.sampling = choose_sampling(lut.job, {1e-3, 0.1}, {.counts = lut.request.sampling}).sampling;
        const std::string header = scene_toml(lut);
        const Plan again = plan_of(folder, header);
        EXPECT_EQ(again.luts[0].request.sampling.nodes, lut.request.sampling.nodes) << header;
        EXPECT_EQ(again.luts[0].request.sampling.thickness_samples, 16) << header;
        EXPECT_TRUE(again.warnings.empty()) << again.warnings.front();
    }
    const Plan sampled = plan_of(folder, rough + "[accuracy]\nwavelengths = 81\n");
    EXPECT_NE(scene_toml(sampled.luts[0]).find("\nwavelengths = 81\n"), std::string::npos);
}

// Mistakes: one line each, word for word.
struct Mistake {
    const char* name;
    std::string scene;
    std::string message;  // behind "nacre: "
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

void write_files(const TemporaryFolder& folder, const std::string& scene) {
    folder.file("late.csv", late_csv);
    folder.file("no.yml", "[ this: is {no yaml\n");
    folder.file("other.yml", "title: a letter\n");
    folder.file("s.toml", scene);
}

class BadLayers : public testing::TestWithParam<Mistake> {};

TEST_P(BadLayers, IsOneLineThatSaysWhereAndWhat) {
    const TemporaryFolder folder;
    write_files(folder, GetParam().scene);
    const CurrentFolder here(folder.path());
    try {
        plan_scene(read_scene_file("s.toml"), scene_files());
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), GetParam().message);
    }
}

std::string film_with(const std::string& index, const std::string& thickness = "300") {
    return std::string(film) + "index = " + index + "\nthickness_nm = " + thickness + "\n";
}

std::string stack_of(const std::string& layers) {
    return std::string(stack) + "layers = [ " + layers + " ]\n";
}

std::string nested(int depth) {
    std::string text = "{ index = 1.5, thickness_nm = 1 }";
    for (int i = 0; i < depth; ++i) text = "{ repeat = 1, layers = [ " + text + " ] }";
    return text;
}

constexpr const char* one_layer = "{ index = 1.5, thickness_nm = 100 }";

const std::vector<Mistake> mistakes{
    {"NegativeThickness", film_with("1.5", "-1"),
     "s.toml:4:16 [material.f]: thickness_nm = -1 is out of range; allowed [0, 1e+08] nm"},
    {"ThicknessThatIsNoNumber", film_with("1.5", "nan"),
     "s.toml:4:16 [material.f]: thickness_nm = nan is not a finite number; allowed [0, 1e+08] nm"},
    {"AbsurdThickness", film_with("1.5", "1e300"),
     "s.toml:4:16 [material.f]: thickness_nm = 1e+300 is out of range; allowed [0, 1e+08] nm"},
    {"NegativeThicknessOfALayer", stack_of("{ index = 1.5, thickness_nm = -1 }"),
     "s.toml:3:42 [material.f]: thickness_nm = -1 is out of range; allowed [0, 1e+08] nm"},
    {"ThicknessInWords", film_with("1.5", "\"thin\""),
     "s.toml:4:16 [material.f]: thickness_nm = \"thin\" is a string; give a number"},
    {"NegativeSpread", std::string(good_film) + "thickness_spread_nm = -1\n",
     "s.toml:5:23 [material.f]: thickness_spread_nm = -1 is out of range; allowed [0, 10000] nm"},
    {"IndexOfZero", film_with("0"), "s.toml:3:9 [material.f]: index = 0 is out of range; allowed [1e-06, 1000]"},
    {"NegativeIndex", film_with("-1.5"),
     "s.toml:3:9 [material.f]: index = -1.5 is out of range; allowed [1e-06, 1000]"},
    {"NegativeN", film_with("{ n = -1.5, k = 1 }"),
     "s.toml:3:15 [material.f]: n = -1.5 is out of range; allowed [1e-06, 1000]"},
    {"Gain", film_with("{ n = 1.5, k = -0.1 }"),
     "s.toml:3:24 [material.f]: k = -0.1 is out of range; allowed [0, 1000]"},
    {"GainInATable", film_with("{ wavelength_nm = [360, 830], n = [1.5, 1.5], k = [0, -1] }"),
     "s.toml:3:63 [material.f]: k = -1 is out of range; allowed [0, 1000]"},
    {"AbsorbingIncidentMedium", std::string(good_film) + "incident = { n = 1.5, k = 0.1 }\n",
     "s.toml:5:12 [material.f]: incident absorbs, so no light reaches the layers through it; give a medium with k = 0"},
    {"MetalAsIncidentMedium", std::string(good_film) + "incident = \"ag\"\n",
     "s.toml:5:12 [material.f]: incident absorbs, so no light reaches the layers through it; give a medium with k = 0"},
    {"MaterialThatIsNotKnownThere", film_with("\"late.csv\""),
     "s.toml:3:9 [material.f]: \"late.csv\" is known from 450 to 900 nm, and the light needs 360 to 830 nm; narrow "
     "[light] range_nm, or write outside = \"hold\" to go on with its end values"},
    {"MaterialOfALayerThatIsNotKnownThere", stack_of("{ index = \"late.csv\", thickness_nm = 9 }"),
     "s.toml:3:22 [material.f]: \"late.csv\" is known from 450 to 900 nm, and the light needs 360 to 830 nm; narrow "
     "[light] range_nm, or write outside = \"hold\" to go on with its end values"},
    {"TableThatIsTooShort", film_with("{ wavelength_nm = [400, 700], n = [1.5, 1.5] }"),
     "s.toml:3:9 [material.f]: this index is known from 400 to 700 nm, and the light needs 360 to 830 nm; narrow "
     "[light] range_nm, or write outside = \"hold\" to go on with its end values"},
    {"UnknownMaterial", film_with("\"tio\""),
     "s.toml:3:9: unknown material \"tio\"; nearest: tio2, air, oil, si, sio2; `nacre list materials` prints all; a "
     ".yml or .csv file is also allowed"},
    {"UnknownMaterialLikeNoOther", film_with("\"zzzzz\""),
     "s.toml:3:9: unknown material \"zzzzz\"; known: ag, air, al, al2o3, aragonite, ...; `nacre list materials` prints "
     "all; a .yml or .csv file is also allowed"},
    {"MaterialWithoutAName", film_with("\"\""),
     "s.toml:3:9 [material.f]: index is empty; give a number or the name of a material"},
    {"FileThatIsMissing", film_with("\"none.yml\""),
     "s.toml:3:9: none.yml: cannot be opened: No such file or directory"},
    {"FileThatIsNoYaml", film_with("\"no.yml\""), "no.yml:1: a key is not a word; a key must be a word"},
    {"FileThatIsNoMaterial", film_with("\"other.yml\""),
     "other.yml: has no DATA; a material is YAML with DATA, as refractiveindex.info has it"},
    {"RepeatOfABillion", stack_of("{ repeat = 1000000000, layers = [ " + std::string(one_layer) + " ] }"),
     "s.toml:3:23 [material.f]: repeat = 1000000000 is out of range; allowed [1, 100000]"},
    {"RepeatOfNothing", stack_of("{ repeat = 0, layers = [ " + std::string(one_layer) + " ] }"),
     "s.toml:3:23 [material.f]: repeat = 0 is out of range; allowed [1, 100000]"},
    {"RepeatThatIsNotWhole", stack_of("{ repeat = 2.5, layers = [ " + std::string(one_layer) + " ] }"),
     "s.toml:3:23 [material.f]: repeat = 2.5 is a number; give a whole number"},
    {"TooManyLayers",
     stack_of("{ repeat = 1000, layers = [ { repeat = 1000, layers = [ { index = 1.5, thickness_nm = "
              "0.001 } ] } ] }"),
     "s.toml:3:10 [material.f]: the stack has 1000000 layers, repeats counted; allowed 100000"},
    {"TooManyLayersOfAnIrregularStack",
     stack_of("{ repeat = 1001, layers = [ " + std::string(one_layer) + " ] }") + "thickness_spread_nm = 1\n",
     "s.toml:3:10 [material.f]: the stack has 1001 layers, repeats counted; allowed 1000 with thickness_spread_nm"},
    {"TooManyFilms",
     std::string(stack) + "form = \"lamellae\"\nfilm = 1.5\nfilm_nm = 100\ngap_nm = 100\nfilms = 600\n"
                          "thickness_spread_nm = 3\n",
     "s.toml:7:9 [material.f]: the stack has 1200 layers, repeats counted; allowed 1000 with thickness_spread_nm"},
    {"GroupsTooDeep", stack_of(nested(17)),
     "s.toml:3:435 [material.f]: groups are nested too deeply; at most 16 levels are allowed"},
    {"GroupOfNothing", stack_of("{ repeat = 2, layers = [] }"),
     "s.toml:3:35 [material.f]: layers is empty; give one layer or more"},
    {"StackWithoutLayers", stack,
     "s.toml:1:1 [material.f]: layers is missing; give [ { index, thickness_nm }, ... ] in the order in which light "
     "meets them, or [] for a bare surface"},
    {"LayersThatAreNone", std::string(stack) + "layers = 3\n",
     "s.toml:3:10 [material.f]: layers = 3 is a whole number; give an array"},
    {"GradedThicknessOutsideAGroup", stack_of("{ index = 1.5, thickness_nm = { from = 100, to = 200 } }"),
     "s.toml:3:42 [material.f]: from and to run over the repeats of a group, and this layer is not in a group; give "
     "one value, or picks that a search for it is to meet"},
    {"GradedIndexOutsideAGroup", stack_of("{ index = { from = 1.5, to = 2 }, thickness_nm = 100 }"),
     "s.toml:3:22 [material.f]: from and to run over the repeats of a group, and this layer is not in a group; give "
     "one value, or picks that a search for it is to meet"},
    {"GradedWithoutAnEnd", stack_of("{ repeat = 2, layers = [ { index = 1.5, thickness_nm = { from = 100 } } ] }"),
     "s.toml:3:67 [material.f]: to is missing; it is required"},
    {"IncoherentInsideAGroup",
     stack_of("{ repeat = 2, layers = [ { index = 1.5, thickness_nm = 100, incoherent = true } ] }"),
     "s.toml:3:85 [material.f]: a layer of a group cannot be incoherent; write the layers out, or mark one outside"},
    {"IncoherentThatIsNoWord", stack_of("{ index = 1.5, thickness_nm = 100, incoherent = 1 }"),
     "s.toml:3:60 [material.f]: incoherent = 1; give true or false"},
    {"GroupWithoutLayers", stack_of("{ repeat = 2 }"),
     "s.toml:3:12 [material.f]: layers is missing; a group with repeat needs layers to repeat"},
    {"UnknownKeyOfALayer", stack_of("{ index = 1.5, thickness_nm = 100, width = 3 }"),
     "s.toml:3:47 [material.f]: unknown key \"width\"; known: layers, repeat, index, thickness_nm, incoherent"},
    {"MisspeltKeyOfALayer", stack_of("{ index = 1.5, thicknes_nm = 100 }"),
     "s.toml:3:27 [material.f]: unknown key \"thicknes_nm\"; did you mean thickness_nm?"},
    {"UnknownKeyOfAGroup", stack_of("{ repeat = 2, gap = 3, layers = [ " + std::string(one_layer) + " ] }"),
     "s.toml:3:26 [material.f]: unknown key \"gap\"; known: layers, repeat"},
    {"UnknownKeyOfAFilm", std::string(good_film) + "layers = 3\n",
     "s.toml:5:1 [material.f]: unknown key \"layers\"; known: mechanism, incident, index, thickness_nm, substrate, "
     "thickness_spread_nm, base, tilt_deg, roughness, polarisation"},
    {"UnknownKeyOfAnIndex", film_with("{ n = 1.5, m = 2 }"),
     "s.toml:3:20 [material.f]: unknown key \"m\"; did you mean n?"},
    {"UnknownForm", std::string(stack) + "form = \"sheets\"\n",
     "s.toml:3:8 [material.f]: unknown form \"sheets\"; known: layers, lamellae"},
    {"LayersOfLamellae",
     std::string(stack) + "form = \"lamellae\"\nfilm = 1.5\nfilm_nm = 100\ngap_nm = 100\nlayers = []\n",
     "s.toml:7:1 [material.f]: unknown key \"layers\"; known: mechanism, incident, form, film, film_nm, gap, gap_nm, "
     "films, substrate, thickness_spread_nm, base, tilt_deg, roughness, polarisation"},
    {"LamellaeWithoutFilm", std::string(stack) + "form = \"lamellae\"\nfilm_nm = 100\ngap_nm = 100\n",
     "s.toml:1:1 [material.f]: film is missing; give a number, { n, k }, or the name of a material"},
    {"PlaneOfAFilm", std::string(good_film) + "[swatch.s]\ndraw = \"plane\"\n",
     "s.toml:6:8 [swatch.s]: draw = \"plane\" shows the picks of a palette, and material \"f\" is a film; draw a strip "
     "or a sphere"},
    {"FilmWithoutIndex", std::string(film) + "thickness_nm = 100\n",
     "s.toml:1:1 [material.f]: index is missing; give a number, { n, k }, or the name of a material"},
    {"FilmWithoutThickness", std::string(film) + "index = 1.5\n",
     "s.toml:1:1 [material.f]: thickness_nm is missing; it is required"},
    {"SlabOfTenCentimetres", film_with("1.5", "1e8"),
     "s.toml:1:1 [material.f]: the layers are so thick that 472000 fringes lie in range_nm; at most 32768 are allowed; "
     "in a stack, mark thick layers with incoherent = true"},
    {"TwoNodes", std::string(good_film) + "[accuracy]\nnodes = [16, 32]\n",
     "s.toml:6:9 [accuracy]: nodes has 2 numbers; give one, or 4: for angles up to 72.5, 87.1, 89.8 and 90 "
     "degrees"},
    {"FewNodes", std::string(good_film) + "[accuracy.sampling]\nnodes = 4\n",
     "s.toml:6:9 [accuracy.sampling]: nodes = 4 is out of range; allowed [8, 131072]"},
    {"NodesThatAreNotWhole", std::string(good_film) + "[accuracy.sampling]\nnodes = [16, 16, 2.5, 16]\n",
     "s.toml:6:18 [accuracy.sampling]: nodes = 2.5 is a number; give a whole number"},
    {"NodesAndWavelengths", std::string(good_film) + "[accuracy]\nwavelengths = 50\n[accuracy.sampling]\nnodes = 16\n",
     "s.toml:8:9 [accuracy.sampling]: nodes and wavelengths both say where spectra are sampled; leave one of them out"},
    {"OddThicknessSamples", std::string(good_film) + "[accuracy.sampling]\nthickness_samples = 31\n",
     "s.toml:6:21 [accuracy.sampling]: thickness_samples = 31 is not a multiple of 2; give 2, 4, 6 ..."},
    {"OneThicknessSample", std::string(good_film) + "[accuracy.sampling]\nthickness_samples = 1\n",
     "s.toml:6:21 [accuracy.sampling]: thickness_samples = 1 is out of range; allowed [2, 16384]"},
    {"SlicesThatAreNoFours", std::string(good_film) + "[accuracy.sampling]\nslices = 6\n",
     "s.toml:6:10 [accuracy.sampling]: slices = 6 is not a multiple of 4; give 4, 8, 12 ..."},
    {"CountsInBothTables",
     std::string(good_film) + "[accuracy]\nrealisations = 8\n[accuracy.sampling]\n"
                              "thickness_samples = 8\n",
     "s.toml:6:16 [accuracy]: realisations is also given as thickness_samples in [accuracy.sampling]; leave out one of "
     "them"},
    {"LongCauchy", film_with("{ cauchy = [1.5, 1, 1, 1, 1, 1, 1] }"),
     "s.toml:3:20 [material.f]: cauchy has 7 terms; give at most 6"},
    {"OddSellmeier", film_with("{ sellmeier = [1.5, 1, 3] }"),
     "s.toml:3:23 [material.f]: sellmeier has 3 numbers; give pairs B1, C1, B2, C2 ..., 8 at most (C in square "
     "micrometres)"},
    {"UnknownFormula", film_with("{ formula = 10, coefficients = [1] }"),
     "s.toml:3:21 [material.f]: formula = 10 is out of range; allowed [1, 9]"},
    {"FormulaWithoutCoefficients", film_with("{ formula = 2 }"),
     "s.toml:3:9 [material.f]: coefficients is missing; a formula needs them"},
    {"PoleInTheVisible", film_with("{ sellmeier = [0.01, 0.25] }"),
     "s.toml:3:9 [material.f]: the formula has a resonance at 500 nm, where it gives no index; give a formula whose "
     "resonances lie outside range_nm"},
    {"NegativeStrength", film_with("{ sellmeier = [-3, 0.01] }"),
     "s.toml:3:9 [material.f]: the formula gives no real n at 360 nm; n must be from 1e-06 to 1000"},
    {"TableOfTwoLengths", film_with("{ wavelength_nm = [360, 500, 830], n = [1.5, 1.5] }"),
     "s.toml:3:48 [material.f]: wavelength_nm has 3 numbers and n 2; give as many of each"},
    {"TableThatDoesNotAscend", film_with("{ wavelength_nm = [360, 360, 830], n = [1.5, 1.5, 2] }"),
     "s.toml:3:27 [material.f]: wavelength_nm does not ascend; give every wavelength once, smallest first"},
    {"TableOfNothing", film_with("{ k = 1 }"),
     "s.toml:3:9 [material.f]: n is missing; index needs a number, a material, { n, k }, { cauchy = [...] }, { "
     "sellmeier = [...] } or { wavelength_nm = [...], n = [...] }"},
    {"RangeThatIsNone", film_with("{ cauchy = [1.5], range_nm = [700, 400] }"),
     "s.toml:3:38 [material.f]: range_nm is not an interval; give [first, last], the first smaller"},
    {"UnknownOutside", film_with("{ material = \"late.csv\", outside = \"keep\" }"),
     "s.toml:3:44 [material.f]: unknown outside \"keep\"; known: error, hold"},
    {"AxisOverNothing", std::string(good_film) + "[lut.a]\nx = { parameter = \"thickness\", from = 1, to = 2 }\n",
     "s.toml:6:19 [lut.a]: mechanism film has no parameter \"thickness\"; known: thickness_nm, thickness_spread_nm, n, "
     "k, substrate.n, substrate.k, tilt_deg, roughness"},
    {"AxisOverTheIndexOfAMaterial", film_with("\"bk7\"") + "[lut.a]\nx = { parameter = \"n\", from = 1, to = 2 }\n",
     "s.toml:6:19 [lut.a]: mechanism film has no parameter \"n\"; known: thickness_nm, thickness_spread_nm, "
     "substrate.n, substrate.k, tilt_deg, roughness"},
    {"AxisIntoGain", std::string(good_film) + "[lut.a]\nx = { parameter = \"k\", from = -1, to = 2 }\n",
     "s.toml:6:31 [lut.a]: from = -1 is out of range; allowed [0, 1000]"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, BadLayers, testing::ValuesIn(mistakes), name_of_case);

TEST(DeepGroups, MayBeSixteen) {
    const TemporaryFolder folder;
    EXPECT_NO_THROW(plan_of(folder, stack_of(nested(16))));
}

// What `bake` would compute on for minutes, with numbers that mean nothing.
TEST(BadLayersWithoutWords, AnAxisIntoSlabsThatNothingResolvesIsRefused) {
    const TemporaryFolder folder;
    try {
        plan_of(folder, std::string(good_film) + "[lut.a]\nx = { parameter = \"thickness_nm\", from = 0, to = 1e8 }\n");
        FAIL() << "472000 fringes at its end were accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("fringes"), std::string::npos) << error.what();
    }
}

TEST(BadLayersWithoutWords, APoleThatIsNarrowerThanTheStepsItIsLookedForInIsFound) {
    // At 500.0003 nm exactly; n is below its root for a millionth of a nanometre.
    const TemporaryFolder folder;
    EXPECT_THROW(plan_of(folder, film_with("{ sellmeier = [1e-9, 0.2500003] }", "1")), Error);
}

}  // namespace
}  // namespace nacre::test
