#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "io/ocio/ocio_spaces.h"
#include "io/scene/scene_file.h"
#include "io/scene/shipped_materials.h"
#include "nacre/base/error.h"
#include "nacre/scene/plan.h"
#include "pipeline/picked_colours.h"
#include "reference/model.h"
#include "reference/number.h"

// Layers of a stack that are left to a search, and how far its answers move when they are made inexactly. What was
// found is judged by a model that shares nothing with what found it. NACRE_PICK_SWEEP=1 takes 200 cavities
// and 10000 samples.
namespace nacre {
namespace {

using reference::Uniform;

bool sweeps() {
    const char* request = std::getenv("NACRE_PICK_SWEEP");
    return request != nullptr && std::string(request) == "1";
}

Plan plan_of(const std::string& material) {
    PlanRequest request;
    request.all_materials = true;
    return plan_scene(parse_scene("[material.m]\n" + material, "s.toml"),
                      scene_files_with_colours("s.toml", "", open_ocio_spaces), request);
}

const MaterialSearch& search_of(const Plan& plan) {
    return plan.searches.at(0);
}

const Stack& best_stack(const Plan& plan) {
    return std::get<Stack>(plan.materials.at(0).mechanism);
}

std::vector<std::string> names_of(const MaterialSearch& search) {
    std::vector<std::string> names;
    for (const FreeNumber& number : search.search.free) names.push_back(number.name);
    return names;
}

// ---- The second road

reference::ModelXyz modelled(const Mechanism& mechanism, double angle_deg) {
    constexpr double tolerance = 1e-3;
    return reference::Model({"", mechanism}, tolerance).at(std::sqrt(std::cos(angle_deg * std::numbers::pi / 180.0)));
}

double difference(const reference::ModelXyz& one, const reference::ModelXyz& other) {
    return reference::ciede2000(reference::lab_of(one), reference::lab_of(other));
}

constexpr double angles_deg[] = {0.0, 60.0};

std::string picks_text(const Mechanism& mechanism) {
    std::string text = "picks = [\n";
    for (const double angle_deg : angles_deg) {
        const reference::ModelRgb rgb = reference::to_rec709(modelled(mechanism, angle_deg));
        char line[200];
        std::snprintf(line, sizeof line,
                      "{ angle_deg = %g, colour = [%.17g, %.17g, %.17g], space = \"lin_rec709\" },\n", angle_deg,
                      rgb[0], rgb[1], rgb[2]);
        text += line;
    }
    return text + "]\n";
}

// ---- Cavities

Layer layer_of(const char* material, double thickness_nm) {
    Layer layer;
    layer.index = Index(shipped_material(material));
    layer.thickness_nm = thickness_nm;
    return layer;
}

Stack cavity_of(double silver_nm, double silica_nm, bool is_on_silver) {
    Stack stack;
    stack.layers = {layer_of("ag", silver_nm), layer_of("sio2", silica_nm)};
    if (!is_on_silver) stack.layers.push_back(layer_of("ag", 100.0));
    stack.substrate = is_on_silver ? Index(shipped_material("ag")) : Index(1.52);
    return stack;
}

std::string cavity_text(bool is_on_silver, bool is_bounded) {
    const std::string silver = is_bounded ? ", thickness_nm = { from = 5, to = 40 }" : "";
    const std::string silica = is_bounded ? ", thickness_nm = { from = 60, to = 400 }" : "";
    return "mechanism = \"stack\"\nlayers = [ { index = \"ag\"" + silver + " }, { index = \"sio2\"" + silica + " }" +
           (is_on_silver ? " ]\nsubstrate = \"ag\"\n"
                         : ", { index = \"ag\", thickness_nm = 100 } ]\nsubstrate = 1.52\n");
}

// How well and how fast searches find what has the picked colours.
struct Score {
    double sum = 0.0, worst = 0.0, seconds = 0.0, slowest = 0.0;
    int cases = 0;

    void add(const Mechanism& truth, const std::string& material) {
        const std::string text = material + picks_text(truth);
        const auto start = std::chrono::steady_clock::now();
        const Plan plan = plan_of(text);
        const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        seconds += taken;
        slowest = std::max(slowest, taken);
        ++cases;
        double here = 0.0;
        for (const double angle_deg : angles_deg) {
            const double de00 =
                difference(modelled(plan.materials.at(0).mechanism, angle_deg), modelled(truth, angle_deg));
            here = std::max(here, de00);
            sum += de00;
        }
        worst = std::max(worst, here);
        if (here > 0.05) {
            std::cout << "CIEDE2000 " << here << ": thicknesses";
            for (const Layer& layer : std::get<Stack>(truth).layers) std::cout << " " << layer.thickness_nm;
            std::cout << ", found";
            for (const Layer& layer : best_stack(plan).layers) std::cout << " " << layer.thickness_nm;
            std::cout << "\n";
        }
    }

    void expect_good() const {
        const double mean = sum / (2.0 * cases);
        std::cout << cases << " cavities: CIEDE2000 " << mean << " on average, " << worst << " at most; "
                  << seconds / cases << " s each, the slowest " << slowest << " s\n";
        EXPECT_LE(mean, 0.05);
        EXPECT_LE(worst, 0.5);
    }
};

TEST(Cavities, AreFoundFromTwoColours) {
    Score score;
    for (int number = 0; number < (sweeps() ? 200 : 12); ++number) {
        Uniform random(7000 + static_cast<std::uint64_t>(number));
        const double silver_nm = random.between(5.0, 40.0), silica_nm = random.between(60.0, 400.0);
        const bool is_on_silver = number % 2 == 0, is_bounded = number % 4 < 2;
        score.add(cavity_of(silver_nm, silica_nm, is_on_silver), cavity_text(is_on_silver, is_bounded));
    }
    score.expect_good();
}

TEST(Cavities, OfThreeFreeLayersAreFoundToo) {
    Score score;
    for (int number = 0; number < (sweeps() ? 24 : 3); ++number) {
        Uniform random(9000 + static_cast<std::uint64_t>(number));
        const double silver_nm = random.between(5.0, 40.0), silica_nm = random.between(60.0, 400.0);
        Stack truth = cavity_of(silver_nm, silica_nm, false);
        truth.layers[2].thickness_nm = random.between(10.0, 60.0);
        score.add(truth,
                  "mechanism = \"stack\"\nlayers = [ { index = \"ag\" }, { index = \"sio2\" }, { index = \"ag\" } ]\n"
                  "substrate = 1.52\n");
    }
    score.expect_good();
}

// ---- What the scene says

const std::string two_picks =
    "picks = [ { angle_deg = 0, colour = \"#3a6fd0\" }, { angle_deg = 40, colour = \"#7030b0\" } ]\n";
const std::string stack = "mechanism = \"stack\"\n";

TEST(FreeLayers, KeepWhatIsFixedAndStayWithinBounds) {
    const Plan plan =
        plan_of(stack + two_picks +
                "layers = [ { index = { from = 1.6, to = 2.2 }, thickness_nm = { from = 30, to = 90 } },\n"
                "           { index = \"sio2\" }, { index = \"al\", thickness_nm = 50 } ]\n"
                "substrate = { from = 1.4, to = 1.6 }\n");
    const MaterialSearch& search = search_of(plan);
    EXPECT_EQ(names_of(search), (std::vector<std::string>{"layers[0].index", "layers[0].thickness_nm",
                                                          "layers[1].thickness_nm", "substrate"}));
    for (const FoundMechanism& found : search.found) {
        const Stack& one = std::get<Stack>(found.mechanism);
        ASSERT_EQ(one.layers.size(), 3u);
        EXPECT_EQ(one.layers[0].index.constant.real(), found.values[0]);
        EXPECT_GE(found.values[0], 1.6);
        EXPECT_LE(found.values[0], 2.2);
        EXPECT_EQ(one.layers[0].thickness_nm, found.values[1]);
        EXPECT_GE(found.values[1], 30.0);
        EXPECT_LE(found.values[1], 90.0);
        EXPECT_EQ(one.layers[1].index.curve->name, "sio2");
        EXPECT_EQ(one.layers[1].thickness_nm, found.values[2]);
        EXPECT_EQ(one.layers[2].thickness_nm, 50.0);
        EXPECT_EQ(one.substrate.constant.real(), found.values[3]);
        // Free indices have materials near by.
        EXPECT_EQ(found.near.size(), 2u);
        EXPECT_FALSE(found.tolerance.has_value());
    }
}

TEST(FreeLayers, OfGroupsAreMarkedLeftOutOrEndsOfGrades) {
    const Plan plan = plan_of(
        stack + two_picks +
        "layers = [ { repeat = { from = 2, to = 4 }, layers = [\n"
        "    { index = { from = 1.9, to = 2.3, free = true }, thickness_nm = { from = 40, to = 80, free = true } },\n"
        "    { index = 1.4, thickness_nm = { from = 90, to = { from = 60, to = 100 } } },\n"
        "    { index = { from = 1.5, to = 1.6 } } ] } ]\n"
        "substrate = 1.5\n");
    const MaterialSearch& search = search_of(plan);
    EXPECT_EQ(names_of(search), (std::vector<std::string>{
                                    "layers[0].repeat", "layers[0].layers[0].index", "layers[0].layers[0].thickness_nm",
                                    "layers[0].layers[1].thickness_nm.to", "layers[0].layers[2].thickness_nm"}));
    for (const FoundMechanism& found : search.found) {
        const Layer& group = std::get<Stack>(found.mechanism).layers.at(0);
        EXPECT_EQ(group.repeat, found.values[0]);
        EXPECT_GE(group.repeat, 2);
        EXPECT_LE(group.repeat, 4);
        EXPECT_EQ(group.layers[0].index.constant.real(), found.values[1]);
        EXPECT_FALSE(group.layers[0].last_index.has_value());
        EXPECT_EQ(group.layers[0].thickness_nm, found.values[2]);
        EXPECT_FALSE(group.layers[0].last_thickness_nm.has_value());
        EXPECT_EQ(group.layers[1].thickness_nm, 90.0);
        EXPECT_EQ(group.layers[1].last_thickness_nm, found.values[3]);
        EXPECT_EQ(group.layers[2].last_index->constant.real(), 1.6);
    }
}

TEST(FreeLayers, AreLookedForUpToWhereAMetalIsOpaque) {
    const Plan plan = plan_of(stack + two_picks + "layers = [ { index = \"ag\" }, { index = \"sio2\" } ]\n");
    const std::vector<FreeNumber>& free = search_of(plan).search.free;
    // exp(-4 pi k d / lambda) = exp(-7) at the middle of 360 to 830 nm.
    const double k = shipped_material("ag")->at(595.0).imag();
    EXPECT_NEAR(free.at(0).high, 7.0 * 595.0 / (4.0 * std::numbers::pi * k), 1e-9);
    EXPECT_EQ(free.at(0).low, 0.0);
    EXPECT_EQ(free.at(1).high, 1000.0);
}

TEST(FreeLayers, WithoutAFreeNumberAreJudged) {
    const Plan plan = plan_of(stack + two_picks + "layers = [ { index = 1.5, thickness_nm = 100 } ]\n");
    EXPECT_TRUE(search_of(plan).search.free.empty());
    EXPECT_EQ(best_stack(plan).layers.at(0).thickness_nm, 100.0);
}

// ---- Tolerances

// The mean of a sample, and its standard error.
struct Estimate {
    explicit Estimate(const std::vector<double>& values) {
        for (const double value : values) mean += value / static_cast<double>(values.size());
        for (const double value : values) error += (value - mean) * (value - mean);
        error = std::sqrt(error) / static_cast<double>(values.size());
    }
    double mean = 0.0, error = 0.0;
};

// By the method of Marsaglia, from the tests' own random numbers.
double normal(Uniform& random) {
    for (;;) {
        const double a = random.between(-1.0, 1.0), b = random.between(-1.0, 1.0), square = a * a + b * b;
        if (square > 0.0 && square < 1.0) return a * std::sqrt(-2.0 * std::log(square) / square);
    }
}

struct MadeCavity {
    double silver_nm, silica_nm, off_nm;
};
class Tolerances : public testing::TestWithParam<MadeCavity> {};

TEST_P(Tolerances, AreThoseOfAMonteCarlo) {
    const int samples = sweeps() ? 10000 : 1500;
    constexpr double errors_allowed = 3.0;
    const auto [silver_nm, silica_nm, off_nm] = GetParam();
    const Plan plan = plan_of(cavity_text(true, true) + picks_text(cavity_of(silver_nm, silica_nm, true)) +
                              "tolerance = { thickness_nm = " + std::to_string(off_nm) + " }\n");
    const FoundMechanism& found = search_of(plan).found.front();
    ASSERT_TRUE(found.tolerance.has_value());
    const Tolerance& told = *found.tolerance;
    EXPECT_EQ(told.thickness_nm, off_nm);
    const reference::ModelXyz exact[] = {modelled(found.mechanism, angles_deg[0]),
                                         modelled(found.mechanism, angles_deg[1])};
    Uniform random(99);
    std::vector<double> de00[2], mean, is_below[2], are_below;
    for (int sample = 0; sample < samples; ++sample) {
        Mechanism made = found.mechanism;
        for (Layer& layer : std::get<Stack>(made).layers)
            layer.thickness_nm = std::max(0.0, layer.thickness_nm + off_nm * normal(random));
        double below = 0.0;
        for (std::size_t i = 0; i < 2; ++i) {
            de00[i].push_back(difference(modelled(made, angles_deg[i]), exact[i]));
            is_below[i].push_back(de00[i].back() < told.per_colour[i].percentile_95 ? 1.0 : 0.0);
            below += de00[i].back() < told.shift.percentile_95 ? 0.5 : 0.0;
        }
        mean.push_back(0.5 * (de00[0].back() + de00[1].back()));
        are_below.push_back(below);
    }
    const auto expect = [&](const std::vector<double>& values, double value, const char* what) {
        const Estimate estimate(values);
        EXPECT_NEAR(estimate.mean, value, errors_allowed * estimate.error) << what;
        std::cout << what << ": " << value << ", by Monte Carlo " << estimate.mean << " +- " << estimate.error << "\n";
    };
    expect(mean, told.shift.mean, "mean");
    expect(are_below, 0.95, "share below the percentile");
    for (std::size_t i = 0; i < 2; ++i) {
        expect(de00[i], told.per_colour[i].mean, "mean of a pick");
        expect(is_below[i], 0.95, "share below the percentile of a pick");
    }
}

// The second is so thin that some of its layers vanish.
INSTANTIATE_TEST_SUITE_P(Cavities, Tolerances,
                         testing::Values(MadeCavity{18.0, 170.0, 3.0}, MadeCavity{6.0, 300.0, 4.0}));

// Where CIEDE2000 is proportional to the error: sqrt(2 / pi) and 1.95996 times its standard deviation.
TEST(ToleranceOfASearch, OfATinyErrorIsThatOfAHalfNormalVariable) {
    const Plan plan = plan_of(
        "mechanism = \"film\"\nindex = 1.4\nsubstrate = 1.9\ntolerance = { thickness_nm = 0.01 }\n" + two_picks);
    const Tolerance& told = search_of(plan).found.front().tolerance.value();
    for (const ColourShift& shift : told.per_colour) {
        EXPECT_GT(shift.mean, 0.0);
        EXPECT_NEAR(shift.percentile_95 / shift.mean, 1.95996 * std::sqrt(0.5 * std::numbers::pi), 0.02);
    }
}

TEST(ToleranceOfASearch, IsTheSameEachTimeAndThereForEveryAnswer) {
    const std::string text =
        stack + "form = \"lamellae\"\nfilm = 1.56\ngap = 1\nfilms = 4\ntolerance = { thickness_nm = 2 }\n" + two_picks;
    const Plan one = plan_of(text), two = plan_of(text);
    ASSERT_EQ(search_of(one).found.size(), search_of(two).found.size());
    for (std::size_t i = 0; i < search_of(one).found.size(); ++i) {
        ASSERT_TRUE(search_of(one).found[i].tolerance.has_value());
        EXPECT_EQ(search_of(one).found[i].tolerance, search_of(two).found[i].tolerance);
    }
    const auto& told = *search_of(one).found.front().tolerance;
    EXPECT_EQ(one.materials[0].picked.at(0).tolerance, told.per_colour.at(0));
    EXPECT_EQ(one.materials[0].picked.at(1).tolerance, told.per_colour.at(1));
    EXPECT_NEAR(told.shift.mean, 0.5 * (told.per_colour[0].mean + told.per_colour[1].mean), 1e-12);
}

// ---- Mistakes

struct Mistake {
    const char* name;
    std::string lines;
    std::string message;
};
void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}
class BadFreeLayers : public testing::TestWithParam<Mistake> {};

TEST_P(BadFreeLayers, AreOneLineThatSaysWhereAndWhat) {
    try {
        plan_of(GetParam().lines);
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), GetParam().message);
    }
}

const std::string film = "mechanism = \"film\"\n";
std::string layers_of(const std::string& layers) {
    return stack + "layers = [ " + layers + " ]\n";
}
std::string no_search(const char* key) {
    return std::string("from and to are the bounds of a search, and nothing searches for ") + key +
           " here; give one value, or picks that the search is to meet";
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes, BadFreeLayers,
    testing::Values(
        Mistake{"Backwards", layers_of("{ index = 1.5, thickness_nm = { from = 200, to = 100 } }") + two_picks,
                "s.toml:3:42 [material.m]: layers[0].thickness_nm runs from 200 down to 100; give the smaller number "
                "first"},
        Mistake{"OutOfRange", layers_of("{ index = 1.5, thickness_nm = { from = -5, to = 100 } }") + two_picks,
                "s.toml:3:51 [material.m]: from = -5 is out of range; allowed [0, 1e+08] nm"},
        Mistake{"IndexOfWords", layers_of("{ index = { from = \"ag\", to = 2 }, thickness_nm = 9 }") + two_picks,
                "s.toml:3:31 [material.m]: from = \"ag\" is a string; give a number"},
        Mistake{"HalfARepeat", layers_of("{ repeat = { from = 1.5, to = 4 }, layers = [ { index = 2 } ] }") + two_picks,
                "s.toml:3:23 [material.m]: repeat is a whole number; give whole numbers for from and to"},
        Mistake{
            "TooManyLayers",
            layers_of("{ repeat = { from = 1, to = 90000 }, layers = [ { index = 2 }, { index = 1 } ] }") + two_picks,
            "s.toml:3:10 [material.m]: the stack has 180000 layers, repeats counted; allowed 100000"},
        Mistake{"NoWordForFree",
                layers_of("{ repeat = 2, layers = [ { index = 2, thickness_nm = { from = 5, to = 9, free = 1 } } ] }") +
                    two_picks,
                "s.toml:3:92 [material.m]: free = 1; give true or false"},
        Mistake{"NoPicksOfALayer", layers_of("{ index = 1.5, thickness_nm = { from = 100, to = 200 } }"),
                "s.toml:3:42 [material.m]: from and to run over the repeats of a group, and this layer is not in a "
                "group; give one value, or picks that a search for it is to meet"},
        Mistake{
            "NoPicksOfAGroup",
            layers_of("{ repeat = 2, layers = [ { index = 2, thickness_nm = { from = 5, to = 9, free = true } } ] }"),
            "s.toml:3:65 [material.m]: " + no_search("thickness_nm")},
        Mistake{"NoPicksOfARepeat",
                layers_of("{ repeat = { from = 2, to = 4 }, layers = [ { index = 2, thickness_nm = 9 } ] }"),
                "s.toml:3:23 [material.m]: " + no_search("repeat")},
        Mistake{"NoPicksOfAFilm", film + "index = 1.5\nthickness_nm = { from = 5, to = 9 }\n",
                "s.toml:4:16 [material.m]: " + no_search("thickness_nm")},
        Mistake{"NoPicksOfAnIndex", film + "index = { from = 1.5, to = 2 }\nthickness_nm = 100\n",
                "s.toml:3:9 [material.m]: " + no_search("index")},
        Mistake{"NeverFree", film + "incident = { from = 1, to = 1.5 }\n" + two_picks,
                "s.toml:3:12 [material.m]: " + no_search("incident")},
        Mistake{"ToleranceOfNothingFree", film + "thickness_nm = 300\ntolerance = { thickness_nm = 2 }\n" + two_picks,
                "s.toml:4:13 [material.m]: tolerance is of free thicknesses, of a film or of the layers of a stack, "
                "and here is none; leave one out, or bound it with from and to"},
        Mistake{"ToleranceOfACrystal", "mechanism = \"crystal\"\ntolerance = { thickness_nm = 2 }\n" + two_picks,
                "s.toml:3:13 [material.m]: tolerance is of free thicknesses, of a film or of the layers of a stack, "
                "and here is none; leave one out, or bound it with from and to"},
        Mistake{"ToleranceWithoutPicks", film + "index = 1.5\nthickness_nm = 9\ntolerance = { thickness_nm = 2 }\n",
                "s.toml:5:1 [material.m]: tolerance is of thicknesses that a search finds, and nothing is searched for "
                "here; give picks and a mechanism other than palette, or remove tolerance"},
        Mistake{"ToleranceOfAPalette", two_picks + "tolerance = { thickness_nm = 2 }\n",
                "s.toml:3:1 [material.m]: tolerance is of thicknesses that a search finds, and nothing is searched for "
                "here; give picks and a mechanism other than palette, or remove tolerance"},
        Mistake{"NoTolerance", film + "tolerance = { thickness_nm = 0 }\n" + two_picks,
                "s.toml:3:30 [material.m]: thickness_nm = 0 is out of range; allowed [1e-06, 10000] nm"},
        Mistake{"NegativeTolerance", film + "tolerance = { thickness_nm = -2 }\n" + two_picks,
                "s.toml:3:30 [material.m]: thickness_nm = -2 is out of range; allowed [1e-06, 10000] nm"},
        Mistake{"ToleranceOfOthers", film + "tolerance = { thickness_nm = 2, index = 0.1 }\n" + two_picks,
                "s.toml:3:33 [material.m]: unknown key \"index\"; known: thickness_nm"},
        Mistake{"EmptyTolerance", film + "tolerance = {}\n" + two_picks,
                "s.toml:3:13 [material.m]: thickness_nm is missing; it is required"},
        Mistake{"ToleranceThatIsANumber", film + "tolerance = 2\n" + two_picks,
                "s.toml:3:13 [material.m]: tolerance = 2 is a whole number; give a table"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

}  // namespace
}  // namespace nacre
