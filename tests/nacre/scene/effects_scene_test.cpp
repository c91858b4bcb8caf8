// Gratings, crystals, scatterers, measurements and what refines a mechanism, as scenes: every key, every mistake.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "io/scene/csv_table.h"
#include "io/scene/scene_file.h"
#include "io/scene/spectra_csv.h"
#include "nacre/base/error.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/smooth_rgb.h"
#include "nacre/scene/mistakes.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/scene/scene_context.h"
#include "support/folders.h"

namespace nacre::test {
namespace {

// What is behind [material.m], as a scene's reader sees it.
class Scene {
public:
    explicit Scene(double first_nm = 360, double last_nm = 830) : first_nm_(first_nm), last_nm_(last_nm) {
        folder_.file("white.csv", "wavelength_nm,reflectance\n300,0.9\n500,0.95\n900,1\n");
        folder_.file("bright.csv", "wavelength_nm,reflectance\n300,0.9\n500,1.2\n900,1\n");
        folder_.file("dark.csv", "wavelength_nm,reflectance\n300,-9\n360,0\n400,-0.01\n900,1\n");
        folder_.file("noisy.csv", "wavelength_nm,reflectance\n300,-9\n350,0.1\n840,0.5\n900,7\n");
        folder_.file("beetle.csv", "wavelength_nm,45,0\n400,0.3,0.1\n700,0.4,0.2\n");
        folder_.file("holes.csv", "wavelength_nm,0,45\n400,0.1,\n700,0.2,0.4\n");
    }

    Mechanism mechanism(const std::string& keys) const {
        const Table scene = parse_scene("[material.m]\n" + keys, "s.toml");
        const Table& material = *scene.table("material")->table("m");
        const MaterialReader find_material = scene_files().find_material;
        const SceneContext context{{find_material, first_nm_, last_nm_},
                                   [&](const std::string& file, const Where&, const CsvKeys& columns) {
                                       return read_curve_csv(path(file), columns);
                                   },
                                   [&](const std::string& file, const Where&, const CsvKeys& columns) {
                                       return read_spectra_csv(path(file), columns);
                                   }};
        Mechanism mechanism = read_mechanism(material, context).mechanism;
        material.expect_all_read();
        throw_mistakes(scene);
        return mechanism;
    }

    // Of a mistake; without the folder's name.
    std::string message(const std::string& keys) const {
        try {
            mechanism(keys);
        } catch (const Error& error) {
            std::string text = error.what();
            const std::string prefix = path("");
            const auto at = text.find(prefix);
            return at == std::string::npos ? text : text.erase(at, prefix.size());
        }
        return "was accepted";
    }

private:
    std::string path(const std::string& file) const { return (folder_.path() / file).string(); }

    TemporaryFolder folder_;
    double first_nm_, last_nm_;
};

const auto name_of_case = [](const auto& info) { return std::string(info.param.name); };

// What a scene may say of a material, and what a header makes of it.
struct Form {
    const char* name;
    std::string keys;
    std::string toml;
};

void PrintTo(const Form& form, std::ostream* out) {
    *out << form.name;
}

class EffectsForm : public testing::TestWithParam<Form> {};

TEST_P(EffectsForm, IsWrittenDownAndReadBackAsTheSame) {
    const Scene scene;
    const std::string toml = mechanism_toml(scene.mechanism(GetParam().keys));
    EXPECT_EQ(toml, GetParam().toml);
    EXPECT_EQ(mechanism_toml(scene.mechanism(toml)), toml);
}

const std::string grating = "mechanism = \"grating\"\n";
const std::string crystal = "mechanism = \"crystal\"\n";
const std::string scatter = "mechanism = \"scatter\"\n";
const std::string measured = "mechanism = \"measured\"\n";
const std::string good_palette =
    "mechanism = \"palette\"\nshape = 0.5\npicks = [\n    { angle_deg = 0, peak_nm = 500, width_nm = 70, height = 1 "
    "},\n    { angle_deg = 40, peak_nm = 450, width_nm = 60, height = 0.7 },\n]\n";
const std::string good_film = "mechanism = \"film\"\nincident = 1\nindex = 1.5\nthickness_nm = 300\nsubstrate = 1.3\n";
const std::string good_stack =
    "mechanism = \"stack\"\nincident = 1\nlayers = [\n    { index = 1.5, thickness_nm = 100 },\n]\nsubstrate = 1\n";
const std::string good_grating =
    "mechanism = \"grating\"\nperiod_nm = 1600\ngrooves = 100\nprofile = \"lamellar\"\ndepth_nm = 120\nland = 0.5\n";
const std::string good_crystal =
    "mechanism = \"crystal\"\nincident = 1\nsphere = 1.45\nmedium = 1\ndiameter_nm = 250\nplanes = 30\nsubstrate = 1\n";
const std::string good_scatter =
    "mechanism = \"scatter\"\nmodel = \"rayleigh\"\nparticle = 1.5\nmedium = 1\nradius_nm = 20\nvolume_fraction = "
    "0.01\nthickness_um = 10\n";
const std::string good_measured =
    "mechanism = \"measured\"\nwavelength_nm = [400, 700]\nangle_deg = [0, 45]\nreflectance = [\n    [0.1, 0.2],\n    "
    "[0.3, 0.4],\n]\n";

const std::vector<Form> mechanism_forms{
    {"Grating", grating + "period_nm = 1600\ndepth_nm = 120\n", good_grating},
    {"GratingOfEverything",
     grating + "period_nm = 741.5\ngrooves = 7\nprofile = \"sinusoidal\"\ndepth_nm = 0.1\ncoat = \"al\"\norders = [3, "
               "0, 1]\ngroove_length_um = 2.5\nazimuth_deg = 12\n",
     grating + "period_nm = 741.5\ngrooves = 7\nprofile = \"sinusoidal\"\ndepth_nm = 0.1\ncoat = \"al\"\norders = [0, "
               "1, 3]\ngroove_length_um = 2.5\nazimuth_deg = 12\n"},
    {"GratingOfGivenEfficiencies",
     grating + "period_nm = 1600\nefficiency = [0.1, 0.2, 0.2]\ncoat = { n = 1.2, k = 7 }\n",
     grating + "period_nm = 1600\ngrooves = 100\nefficiency = [0.1, 0.2, 0.2]\ncoat = { n = 1.2, k = 7 }\n"},
    {"GratingThatIsAllUp", grating + "period_nm = 1600\ndepth_nm = 120\nland = 1\n",
     grating + "period_nm = 1600\ngrooves = 100\nprofile = \"lamellar\"\ndepth_nm = 120\nland = 1\n"},
    {"Crystal", crystal + "sphere = 1.45\ndiameter_nm = 250\n", good_crystal},
    {"CrystalInAMedium", crystal + "sphere = 1\nmedium = \"sio2\"\ndiameter_nm = 250\n",
     crystal + "incident = 1\nsphere = 1\nmedium = \"sio2\"\ndiameter_nm = 250\nplanes = 30\nsubstrate = \"sio2\"\n"},
    {"CrystalOfEverything",
     crystal + "incident = 1.33\nsphere = { n = 1.6, k = 0.01 }\nmedium = 1.4\ndiameter_nm = 250\nspacing_nm = "
               "300\nplanes = 4\nsubstrate = \"si\"\nthickness_spread_nm = 3.5\n",
     crystal + "incident = 1.33\nsphere = { n = 1.6, k = 0.01 }\nmedium = 1.4\ndiameter_nm = 250\nspacing_nm = "
               "300\nplanes = 4\nsubstrate = \"si\"\nthickness_spread_nm = 3.5\n"},
    {"CrystalAsFlatAsAllowed", crystal + "sphere = 1.45\ndiameter_nm = 250\nspacing_nm = 150\n",
     crystal + "incident = 1\nsphere = 1.45\nmedium = 1\ndiameter_nm = 250\nspacing_nm = 150\nplanes = 30\nsubstrate = "
               "1\n"},
    {"Rayleigh", scatter + "particle = 1.5\nradius_nm = 20\n", good_scatter},
    {"Mie", scatter + "model = \"mie\"\nparticle = \"tio2\"\nradius_nm = 200\n",
     scatter +
         "model = \"mie\"\nparticle = \"tio2\"\nmedium = 1\nradius_nm = 200\nvolume_fraction = 0.01\nthickness_um "
         "= 10\n"},
    {"MieOfEverything",
     scatter + "model = \"mie\"\nparticle = { n = 2, k = 1 }\nmedium = \"water\"\nradius_nm = 200\nradius_spread = "
               "0.5\nvolume_fraction = 0.6\nthickness_um = 0.25\n",
     scatter + "model = \"mie\"\nparticle = { n = 2, k = 1 }\nmedium = \"water\"\nradius_nm = 200\nradius_spread = "
               "0.5\nvolume_fraction = 0.6\nthickness_um = 0.25\n"},
    {"QuasiOrdered", scatter + "model = \"quasi_ordered\"\nparticle = 1\nmedium = 1.5\nradius_nm = 100\n",
     scatter + "model = \"quasi_ordered\"\nparticle = 1\nmedium = 1.5\nradius_nm = 100\nvolume_fraction = "
               "0.4\nthickness_um = 10\n"},
    {"QuasiOrderedOfHardSpheres",
     scatter + "model = \"quasi_ordered\"\nparticle = 1\nmedium = 1.5\nradius_nm = 100\nvolume_fraction = "
               "0.2\nhard_radius_nm = 120\n",
     scatter + "model = \"quasi_ordered\"\nparticle = 1\nmedium = 1.5\nradius_nm = 100\nvolume_fraction = "
               "0.2\nhard_radius_nm = 120\nthickness_um = 10\n"},
    {"Measured", measured + "file = \"beetle.csv\"\n",
     measured + "name = \"beetle.csv\"\nwavelength_nm = [400, 700]\nangle_deg = [0, 45]\nreflectance = [\n    [0.1, "
                "0.2],\n    [0.3, 0.4],\n]\n"},
    {"MeasuredAndWrittenOut", good_measured, good_measured},
};

const std::vector<Form> effect_forms{
    {"Black", good_film + "base = \"black\"\n", good_film},
    {"BlackAsANumber", good_film + "base = 0\n", good_film + "base = 0\n"},
    {"Grey", good_stack + "base = 0.18\n", good_stack + "base = 0.18\n"},
    {"White", good_crystal + "base = 1\n", good_crystal + "base = 1\n"},
    {"Rgb", good_film + "base = { rgb = [0.1, 0.25, 1] }\n", good_film + "base = { rgb = [0.1, 0.25, 1] }\n"},
    {"Spectrum", good_film + "base = { spectrum = \"white.csv\" }\n",
     good_film + "base = { wavelength_nm = [300, 500, 900], reflectance = [0.9, 0.95, 1] }\n"},
    {"SpectrumThatIsNoiseWhereNobodySeesIt", good_film + "base = { spectrum = \"noisy.csv\" }\n",
     good_film + "base = { wavelength_nm = [350, 840], reflectance = [0.1, 0.5] }\n"},
    {"SpectrumWrittenOut", good_film + "base = { wavelength_nm = [500, 600], reflectance = [0, 1] }\n",
     good_film + "base = { wavelength_nm = [500, 600], reflectance = [0, 1] }\n"},
    {"Pigment", good_film + "base = { pigment = { n = 1.7, k = 0.1 } }\n",
     good_film + "base = { pigment = { n = 1.7, k = 0.1 }, scattering_per_um = 1, share = 1 }\n"},
    {"PigmentOfEverything", good_film + "base = { pigment = \"melanin\", scattering_per_um = 0.5, share = 0.01 }\n",
     good_film + "base = { pigment = \"melanin\", scattering_per_um = 0.5, share = 0.01 }\n"},
    {"Metal", good_stack + "base = { metal = \"al\" }\n", good_stack + "base = { metal = \"al\" }\n"},
    {"BaseBelowGlass", good_film + "base = 0.5\ntilt_deg = 0\npolarisation = \"mean\"\n", good_film + "base = 0.5\n"},
    {"TiltOfAPalette", good_palette + "tilt_deg = 60\n", good_palette + "tilt_deg = 60\n"},
    {"RoughnessOfAPalette", good_palette + "roughness = 0.35\n", good_palette + "roughness = 0.35\n"},
    {"RoughnessOfAFilm", good_film + "tilt_deg = 0\nroughness = 1\n", good_film + "roughness = 1\n"},
    {"TiltOfAFilm", good_film + "tilt_deg = 7.25\n", good_film + "tilt_deg = 7.25\n"},
    {"TiltOfAStack", good_stack + "tilt_deg = 1\n", good_stack + "tilt_deg = 1\n"},
    {"TiltOfACrystal", good_crystal + "tilt_deg = 1\n", good_crystal + "tilt_deg = 1\n"},
    {"TiltOfSpectra", good_measured + "tilt_deg = 1\n", good_measured + "tilt_deg = 1\n"},
    {"SLight", good_film + "polarisation = \"s\"\n", good_film + "polarisation = \"s\"\n"},
    {"PLight", good_stack + "polarisation = \"p\"\n", good_stack + "polarisation = \"p\"\n"},
    {"BothLights", good_crystal + "polarisation = \"both\"\n", good_crystal + "polarisation = \"both\"\n"},
    {"SLightOfParticles", good_scatter + "polarisation = \"s\"\n", good_scatter + "polarisation = \"s\"\n"},
    {"MeanLightIsSaidByNothing", good_scatter + "polarisation = \"mean\"\n", good_scatter},
    {"AllAtOnce",
     good_crystal + "thickness_spread_nm = 2\npolarisation = \"p\"\ntilt_deg = 5\nbase = { rgb = [0.5, 0.25, 0] }\n",
     good_crystal + "thickness_spread_nm = 2\nbase = { rgb = [0.5, 0.25, 0] }\ntilt_deg = 5\npolarisation = \"p\"\n"},
};

INSTANTIATE_TEST_SUITE_P(Mechanisms, EffectsForm, testing::ValuesIn(mechanism_forms), name_of_case);
INSTANTIATE_TEST_SUITE_P(Effects, EffectsForm, testing::ValuesIn(effect_forms), name_of_case);

// Mechanisms at random, all of whose numbers have all their digits.
class RandomMechanism {
public:
    explicit RandomMechanism(unsigned seed) : random_(seed) {}

    Mechanism grating() {
        Grating grating;
        grating.period_nm = number(10, 1e6);
        grating.grooves = whole(1, 1000000);
        grating.profile = static_cast<GratingProfile>(whole(0, 2));
        if (grating.profile == GratingProfile::given) {
            const int count = whole(1, 9);
            for (int i = 0; i < count; ++i) grating.efficiency.push_back(number(0, 0.5 / count));
        } else {
            grating.depth_nm = number(0, 1e5);
        }
        if (grating.profile == GratingProfile::lamellar) grating.land = number(0, 1);
        if (perhaps()) grating.coat = index();
        if (perhaps()) grating.orders = {whole(0, 3), whole(4, 90), whole(91, 1000)};
        if (perhaps()) grating.groove_length_um = number(0, 1e6);
        if (perhaps()) grating.azimuth_deg = number(0, 90);
        return grating;
    }
    Mechanism crystal() {
        Crystal crystal;
        crystal.incident = number(0.1, 3);
        crystal.sphere = index();
        crystal.medium = index();
        crystal.diameter_nm = number(10, 1e4);
        if (perhaps()) crystal.spacing_nm = crystal.diameter_nm * number(0.61, 3);
        crystal.planes = whole(1, 10000);
        crystal.substrate = number(1, 2);
        if (perhaps()) crystal.thickness_spread_nm = number(0, 1e4);
        Mechanism mechanism = crystal;
        if (perhaps()) mechanism.effects.base = base();
        if (perhaps()) mechanism.effects.relief.tilt_deg = number(0, 60);
        add_polarisation(mechanism);
        return mechanism;
    }
    Mechanism scatter() {
        Scatter scatter;
        scatter.model = static_cast<ScatterModel>(whole(0, 2));
        scatter.particle = index();
        scatter.medium = number(0.1, 1.5);
        scatter.radius_nm = number(0.1, scatter.model == ScatterModel::rayleigh ? 38 : 4000);
        if (perhaps()) scatter.radius_spread = number(0, 0.5);
        scatter.volume_fraction = number(0.001, 0.5);
        if (scatter.model == ScatterModel::quasi_ordered && perhaps())
            scatter.hard_radius_nm = 1.05 * scatter.radius_nm;
        scatter.thickness_um = number(0.001, 1e6);
        Mechanism mechanism = scatter;
        add_polarisation(mechanism);
        return mechanism;
    }
    Mechanism measured() {
        MeasuredSpectra spectra;
        if (perhaps()) spectra.file = "some \"quoted\\name.csv";
        const int wavelengths = whole(2, 40);
        const int angles = whole(1, 9);
        for (int i = 0; i < wavelengths; ++i) spectra.wavelength_nm.push_back(300.0 + 20.0 * i + number(0, 20));
        for (int i = 0; i < angles; ++i) spectra.angle_deg.push_back(10.0 * i + number(0, 9));
        for (int i = 0; i < wavelengths * angles; ++i) spectra.reflectance.push_back(number(0, 10));
        Mechanism mechanism = spectra;
        if (perhaps()) mechanism.effects.relief.tilt_deg = number(0, 60);
        return mechanism;
    }

private:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    bool perhaps() { return whole(0, 1) == 1; }
    Index index() { return perhaps() ? Index(number(0.1, 4)) : Index(RefractiveIndex(number(0.1, 4), number(0, 9))); }
    Base base() {
        switch (whole(0, 4)) {
            case 0:
                return GreyBase{number(0, 1)};
            case 1:
                return upsampled({number(0, 1), number(0, 1), number(0, 1)}).base;
            case 2:
                return SpectrumBase{{{number(300, 400), number(401, 500), 900.0}, {number(0, 1), number(0, 1), 1.0}}};
            case 3:
                return PigmentBase{index(), number(0.001, 1e6), number(0, 1)};
            default:
                return MetalBase{index()};
        }
    }
    void add_polarisation(Mechanism& mechanism) {
        const int choice = whole(0, 3);
        mechanism.effects.both_polarisations = choice == 3;
        if (choice < 3) mechanism.effects.polarisation = static_cast<Polarisation>(choice);
    }

    std::mt19937 random_;
};

TEST(MechanismToml, ReadsBackAsTheSameMechanismToTheBit) {
    const Scene scene;
    for (unsigned seed = 0; seed < 200; ++seed) {
        RandomMechanism random(seed);
        for (const Mechanism& mechanism : {random.grating(), random.crystal(), random.scatter(), random.measured()}) {
            const std::string toml = mechanism_toml(mechanism);
            try {
                EXPECT_TRUE(scene.mechanism(toml) == mechanism) << toml;
            } catch (const Error& error) {
                FAIL() << error.what() << "\n" << toml;
            }
        }
    }
}

// Nobody may have to know which defaults there are: two mechanisms that differ in one key have different headers.
TEST(MechanismToml, TellsMechanismsApart) {
    const Scene scene;
    std::vector<std::string> all;
    for (const auto* forms : {&mechanism_forms, &effect_forms}) {
        for (const Form& form : *forms) all.push_back(mechanism_toml(scene.mechanism(form.keys)));
    }
    std::vector<Mechanism> mechanisms;
    for (const std::string& toml : all) mechanisms.push_back(scene.mechanism(toml));
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (all[i] == all[j]) continue;
            EXPECT_FALSE(mechanisms[i] == mechanisms[j]) << all[i] << all[j];
        }
    }
}

std::vector<std::string> parameter_names(const std::string& keys) {
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters_of(Scene().mechanism(keys))) names.push_back(parameter.name);
    return names;
}

const Parameter& parameter_named(const std::vector<Parameter>& parameters, std::string_view name) {
    return *std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == name; });
}

using Names = std::vector<std::string>;

TEST(Parameters, AreThoseThatTheMechanismHas) {
    EXPECT_EQ(parameter_names(good_grating),
              (Names{"period_nm", "depth_nm", "land", "groove_length_um", "azimuth_deg"}));
    EXPECT_EQ(parameter_names(grating + "period_nm = 1600\ndepth_nm = 120\nprofile = \"sinusoidal\"\n"),
              (Names{"period_nm", "depth_nm", "groove_length_um", "azimuth_deg"}));
    EXPECT_EQ(parameter_names(grating + "period_nm = 1600\nefficiency = [0.1]\n"),
              (Names{"period_nm", "groove_length_um", "azimuth_deg"}));
    const Names numbers{"diameter_nm", "thickness_spread_nm", "sphere.n", "sphere.k", "medium.n",
                        "medium.k",    "substrate.n"};
    const auto and_then = [&](const Names& more) {
        Names names = numbers;
        names.insert(names.end(), more.begin(), more.end());
        return names;
    };
    EXPECT_EQ(parameter_names(good_crystal), and_then({"substrate.k", "tilt_deg", "roughness"}));
    // Light that is to reach a base and come back needs a substrate that lets it pass.
    EXPECT_EQ(parameter_names(good_crystal + "base = 0.5\n"), and_then({"tilt_deg", "roughness", "base.reflectance"}));
    EXPECT_EQ(
        parameter_names(crystal + "sphere = \"sio2\"\ndiameter_nm = 250\nspacing_nm = 220\nsubstrate = \"si\"\n"),
        (Names{"diameter_nm", "spacing_nm", "thickness_spread_nm", "medium.n", "medium.k", "tilt_deg", "roughness"}));
    EXPECT_EQ(parameter_names(good_scatter),
              (Names{"radius_nm", "radius_spread", "volume_fraction", "thickness_um", "particle.n", "particle.k"}));
    EXPECT_EQ(parameter_names(scatter + "model = \"quasi_ordered\"\nparticle = \"sio2\"\nradius_nm = "
                                        "100\nvolume_fraction = 0.2\nhard_radius_nm = 120\n"),
              (Names{"radius_nm", "radius_spread", "volume_fraction", "thickness_um", "hard_radius_nm"}));
    EXPECT_EQ(parameter_names(good_measured), (Names{"tilt_deg", "roughness"}));
}

TEST(Parameters, SetWhatTheyNameAndNothingElse) {
    const Scene scene;
    const std::vector<std::string> mechanisms{
        good_grating + "groove_length_um = 3\nazimuth_deg = 4\n",
        good_crystal + "spacing_nm = 240\nthickness_spread_nm = 3\nbase = 0.5\ntilt_deg = 5\n",
        scatter +
            "model = \"quasi_ordered\"\nparticle = 1.2\nradius_nm = 100\nradius_spread = 0.1\nvolume_fraction = "
            "0.2\nhard_radius_nm = 120\n"};
    for (const std::string& keys : mechanisms) {
        const Mechanism mechanism = scene.mechanism(keys);
        std::vector<Mechanism> changed;
        for (const Parameter& parameter : parameters_of(mechanism)) {
            Mechanism one = mechanism;
            parameter.set(one, parameter.allowed.low);
            Mechanism other = mechanism;
            parameter.set(other, parameter.allowed.high);
            EXPECT_FALSE(one == other) << parameter.name;
            // Set back, nothing is left of it: every other number is as it was.
            parameter.set(one, parameter.allowed.high);
            EXPECT_TRUE(one == other) << parameter.name;
            for (const Mechanism& before : changed) EXPECT_FALSE(other == before) << parameter.name;
            changed.push_back(other);
        }
    }
    const auto at = [&](const std::string& keys, std::string_view name, double value) {
        Mechanism mechanism = scene.mechanism(keys);
        parameter_named(parameters_of(mechanism), name).set(mechanism, value);
        return mechanism;
    };
    EXPECT_EQ(std::get<Grating>(at(good_grating, "land", 0.25)).land, 0.25);
    EXPECT_EQ(std::get<Crystal>(at(good_crystal, "medium.k", 0.25)).medium.constant, RefractiveIndex(1.0, 0.25));
    EXPECT_EQ(std::get<Crystal>(at(good_crystal, "sphere.n", 2.5)).sphere.constant, RefractiveIndex(2.5, 0.0));
    EXPECT_EQ(std::get<Scatter>(at(good_scatter, "radius_nm", 25)).radius_nm, 25);
    EXPECT_EQ(at(good_film, "tilt_deg", 25).effects.relief.tilt_deg, 25);
    EXPECT_EQ(at(good_film + "base = 0.5\n", "base.reflectance", 0.25).effects.base, Base(GreyBase{0.25}));
}

// Whatever two axes do together, what comes out could have been written down.
TEST(Parameters, LeadNowhereThatASceneCouldNotGoItself) {
    const Scene scene;
    const std::vector<std::string> mechanisms{
        crystal + "sphere = 1.45\ndiameter_nm = 250\nspacing_nm = 220\n",
        crystal + "sphere = 1.45\ndiameter_nm = 250\nspacing_nm = 151\n",
        scatter + "particle = 1.5\nradius_nm = 20\nradius_spread = 0.1\n",
        scatter + "model = \"mie\"\nparticle = 1.5\nradius_nm = 20000\nradius_spread = 0.2\nmedium = 1.3\n",
        scatter + "model = \"mie\"\nparticle = 1.5\nradius_nm = 500000\nradius_spread = 0\n",
        scatter +
            "model = \"quasi_ordered\"\nparticle = 1.5\nradius_nm = 100\nvolume_fraction = 0.2\nhard_radius_nm = "
            "110\n",
        scatter +
            "model = \"quasi_ordered\"\nparticle = 1.5\nradius_nm = 100\nvolume_fraction = 0.45\nhard_radius_nm "
            "= 110\n"};
    for (const std::string& keys : mechanisms) {
        const Mechanism mechanism = scene.mechanism(keys);
        const std::vector<Parameter> parameters = parameters_of(mechanism);
        for (const Parameter& x : parameters) {
            for (const Parameter& y : parameters) {
                for (const int corner : {0, 1, 2, 3}) {
                    const auto end = [](const Allowed& allowed, bool high) {
                        // A hair inside: ends are rounded.
                        const double hair = 1e-9 * (allowed.high - allowed.low);
                        return high ? allowed.high - hair : allowed.low + (allowed.low > 0.0 ? hair : 0.0);
                    };
                    Mechanism there = mechanism;
                    x.set(there, end(x.allowed, (corner & 1) != 0));
                    if (y.name != x.name) y.set(there, end(y.allowed, (corner & 2) != 0));
                    // No LUT has both as its axes.
                    const Relief& relief = there.effects.relief;
                    if (relief.tilt_deg > 0.0 && relief.roughness > 0.0) continue;
                    const std::string toml = mechanism_toml(there);
                    EXPECT_EQ(scene.message(toml), "was accepted") << x.name << ", " << y.name << "\n" << toml;
                }
            }
        }
    }
}

TEST(Particles, MayBeLargerInLightOfLongerWaves) {
    const std::string keys = scatter + "particle = 1.5\nradius_nm = 60\n";
    const Scene red(500, 700);
    const std::vector<Parameter> parameters = parameters_of(red.mechanism(keys));
    EXPECT_EQ(parameter_named(parameters, "radius_nm").allowed.high, 60.0);
    // 500 nm / (2 pi)
    EXPECT_EQ(
        red.message(scatter + "particle = 1.5\nradius_nm = 80\n"),
        "s.toml:4:13 [material.m]: radius_nm = 80 is not small compared with the wavelength; use model = \"mie\", "
        "or a radius up to 79.57 nm");
    EXPECT_EQ(red.message(scatter + "particle = 1.5\nradius_nm = 79.5\n"), "was accepted");
}

// Only the light that there is has to come back from below.
TEST(Bases, LieBelowWhatIsClearInTheLightsRange) {
    const std::string keys =
        "mechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\nbase = 0.5\nsubstrate = { n = 1.5, "
        "k_wavelength_nm = [300, 450, 460, 900], k = [0.1, 0.1, 0, 0] }\n";
    EXPECT_EQ(Scene(460, 830).message(keys), "was accepted");
    EXPECT_EQ(Scene(459, 830).message(keys),
              "s.toml:5:8 [material.m]: base lies below a substrate that absorbs, k = 0.01, so nothing comes back from "
              "it; give a substrate with k up to 1e-06");
}

TEST(Bases, OfRgbAreMadeReadyWhereTheyAreRead) {
    const Mechanism mechanism = Scene().mechanism(good_film + "base = { rgb = [0.2, 0.5, 0.1] }\n");
    EXPECT_EQ(mechanism.effects.base, Base(upsampled({0.2, 0.5, 0.1}).base));
}

// The limits leave the mechanism itself in, else its own number could not be an end of its axis.
TEST(Parameters, RangesHoldTheMechanismsOwnNumber) {
    const Scene scene;
    for (const std::string& keys :
         {crystal + "sphere = 1.45\ndiameter_nm = 250\nspacing_nm = 150\n",
          scatter + "model = \"quasi_ordered\"\nparticle = 1.5\nradius_nm = 100\nvolume_fraction = "
                    "0.6\nhard_radius_nm = 100\n"}) {
        const Mechanism mechanism = scene.mechanism(keys);
        for (const Parameter& parameter : parameters_of(mechanism)) {
            if (parameter.name.find('.') != std::string::npos || parameter.name == "tilt_deg" ||
                parameter.name == "roughness")
                continue;
            const double own = parameter.name == "diameter_nm"       ? 250.0
                               : parameter.name == "spacing_nm"      ? 150.0
                               : parameter.name == "radius_nm"       ? 100.0
                               : parameter.name == "hard_radius_nm"  ? 100.0
                               : parameter.name == "volume_fraction" ? 0.6
                                                                     : parameter.allowed.low;
            EXPECT_GE(own, parameter.allowed.low * (1.0 - 1e-12)) << parameter.name;
            EXPECT_LE(own, parameter.allowed.high * (1.0 + 1e-12)) << parameter.name;
        }
    }
}

struct Mistake {
    const char* name;
    std::string keys;
    std::string message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

class BadEffects : public testing::TestWithParam<Mistake> {};

TEST_P(BadEffects, AreOneLineThatSaysWhereAndWhat) {
    EXPECT_EQ(Scene().message(GetParam().keys), GetParam().message);
}

const std::vector<Mistake> grating_mistakes{
    {"NoPeriod", grating + "depth_nm = 1\n", "s.toml:1:1 [material.m]: period_nm is missing; it is required"},
    {"PeriodOutOfRange", grating + "period_nm = 9.9\ndepth_nm = 1\n",
     "s.toml:3:13 [material.m]: period_nm = 9.9 is out of range; allowed [10, 1000000] nm"},
    {"MisspeltPeriod", grating + "periode_nm = 900\ndepth_nm = 1\n",
     "s.toml:3:1 [material.m]: unknown key \"periode_nm\"; did you mean period_nm?"},
    {"NoDepth", grating + "period_nm = 900\n",
     "s.toml:1:1 [material.m]: depth_nm is missing; give it, or the orders' efficiency"},
    {"NoGrooves", grating + "period_nm = 900\ndepth_nm = 1\ngrooves = 0\n",
     "s.toml:5:11 [material.m]: grooves = 0 is out of range; allowed [1, 1000000]"},
    {"HalfAGroove", grating + "period_nm = 900\ndepth_nm = 1\ngrooves = 1.5\n",
     "s.toml:5:11 [material.m]: grooves = 1.5 is a number; give a whole number"},
    {"TooManyGrooves", grating + "period_nm = 900\ndepth_nm = 1\ngrooves = 1000001\n",
     "s.toml:5:11 [material.m]: grooves = 1000001 is out of range; allowed [1, 1000000]"},
    {"UnknownProfile", grating + "period_nm = 900\ndepth_nm = 1\nprofile = \"blazed\"\n",
     "s.toml:5:11 [material.m]: unknown profile \"blazed\"; known: lamellar, sinusoidal"},
    {"NegativeDepth", grating + "period_nm = 900\ndepth_nm = -1\n",
     "s.toml:4:12 [material.m]: depth_nm = -1 is out of range; allowed [0, 100000] nm"},
    {"LandBeyondAll", grating + "period_nm = 900\ndepth_nm = 1\nland = 1.1\n",
     "s.toml:5:8 [material.m]: land = 1.1 is out of range; allowed [0, 1]"},
    {"LandOfASine", grating + "period_nm = 900\ndepth_nm = 1\nprofile = \"sinusoidal\"\nland = 0.5\n",
     "s.toml:6:8 [material.m]: land has no meaning for a sinusoidal profile; allowed for lamellar"},
    {"EfficiencyAndProfile", grating + "period_nm = 900\nefficiency = [0.1]\nprofile = \"lamellar\"\n",
     "s.toml:5:11 [material.m]: profile and efficiency are both given; give the orders' efficiency, or the profile "
     "that it follows from"},
    {"EfficiencyAndDepth", grating + "period_nm = 900\ndepth_nm = 1\nefficiency = [0.1]\n",
     "s.toml:4:12 [material.m]: depth_nm and efficiency are both given; give the orders' efficiency, or the profile "
     "that it follows from"},
    {"EfficiencyAndLand", grating + "period_nm = 900\nland = 0.5\nefficiency = [0.1]\n",
     "s.toml:4:8 [material.m]: land and efficiency are both given; give the orders' efficiency, or the profile that it "
     "follows from"},
    {"NoEfficiency", grating + "period_nm = 900\nefficiency = []\n",
     "s.toml:4:14 [material.m]: efficiency has 0 numbers; allowed 1 to 1000, of orders 1, 2, ..."},
    {"EfficiencyOfMoreThanAll", grating + "period_nm = 900\nefficiency = [1.1]\n",
     "s.toml:4:15 [material.m]: efficiency = 1.1 is out of range; allowed [0, 1]"},
    {"EfficienciesOfMoreThanAll", grating + "period_nm = 900\nefficiency = [0.3, 0.21]\n",
     "s.toml:4:14 [material.m]: the orders of both signs get 1.02 of the light, which is more than all of it; give "
     "efficiencies whose sum is at most 0.5"},
    {"EfficiencyThatIsNoList", grating + "period_nm = 900\nefficiency = 0.5\n",
     "s.toml:4:14 [material.m]: efficiency = 0.5 is a number; give an array"},
    {"NegativeEfficiency", grating + "period_nm = 900\nefficiency = [0.5, -0.1]\n",
     "s.toml:4:20 [material.m]: efficiency = -0.1 is out of range; allowed [0, 1]"},
    {"NoOrders", grating + "period_nm = 900\ndepth_nm = 1\norders = []\n",
     "s.toml:5:10 [material.m]: orders is empty; give those that count, such as [1, 2], or remove the key for all"},
    {"OrderTwice", grating + "period_nm = 900\ndepth_nm = 1\norders = [2, 1, 2]\n",
     "s.toml:5:10 [material.m]: orders has 2 twice; give every order once (its mirror image comes with it)"},
    {"NegativeOrder", grating + "period_nm = 900\ndepth_nm = 1\norders = [-1, 1]\n",
     "s.toml:5:11 [material.m]: orders = -1 is out of range; allowed [0, 1000]"},
    {"OrderBeyondAll", grating + "period_nm = 900\ndepth_nm = 1\norders = [1001]\n",
     "s.toml:5:11 [material.m]: orders = 1001 is out of range; allowed [0, 1000]"},
    {"HalfAnOrder", grating + "period_nm = 900\ndepth_nm = 1\norders = [0.5]\n",
     "s.toml:5:11 [material.m]: orders = 0.5 is a number; give a whole number"},
    {"OrdersThatAreNoList", grating + "period_nm = 900\ndepth_nm = 1\norders = 1\n",
     "s.toml:5:10 [material.m]: orders = 1 is a whole number; give an array"},
    {"UnknownCoat", grating + "period_nm = 900\ndepth_nm = 1\ncoat = \"aluminium\"\n",
     "s.toml:5:8: unknown material \"aluminium\"; did you mean al?"},
    {"NegativeGrooveLength", grating + "period_nm = 900\ndepth_nm = 1\ngroove_length_um = -1\n",
     "s.toml:5:20 [material.m]: groove_length_um = -1 is out of range; allowed [0, 1000000] um"},
    {"AzimuthBeyondAll", grating + "period_nm = 900\ndepth_nm = 1\nazimuth_deg = 91\n",
     "s.toml:5:15 [material.m]: azimuth_deg = 91 is out of range; allowed [0, 90] degrees"},
    {"UnknownKeyOfAGrating", grating + "period_nm = 900\ndepth_nm = 1\nblaze_deg = 5\n",
     "s.toml:5:1 [material.m]: unknown key \"blaze_deg\"; known: mechanism, period_nm, grooves, profile, depth_nm, "
     "land, efficiency, coat, orders, groove_length_um, azimuth_deg"},
};

const std::vector<Mistake> crystal_mistakes{
    {"NoSphere", crystal + "diameter_nm = 250\n",
     "s.toml:1:1 [material.m]: sphere is missing; give a number, { n, k }, or the name of a material"},
    {"NoDiameter", crystal + "sphere = 1.45\n", "s.toml:1:1 [material.m]: diameter_nm is missing; it is required"},
    {"DiameterOutOfRange", crystal + "sphere = 1.45\ndiameter_nm = 9\n",
     "s.toml:4:15 [material.m]: diameter_nm = 9 is out of range; allowed [10, 100000] nm"},
    {"SpacingOfNothing", crystal + "sphere = 1.45\ndiameter_nm = 250\nspacing_nm = 0\n",
     "s.toml:5:14 [material.m]: spacing_nm = 0 is out of range; allowed [1, 100000] nm"},
    {"SpheresPressedFlat", crystal + "sphere = 1.45\ndiameter_nm = 250\nspacing_nm = 149.9\n",
     "s.toml:5:14 [material.m]: spacing_nm = 149.9 is too small for spheres of 250 nm; give at least 0.6 of "
     "diameter_nm, 150 nm"},
    {"NoPlanes", crystal + "sphere = 1.45\ndiameter_nm = 250\nplanes = 0\n",
     "s.toml:5:10 [material.m]: planes = 0 is out of range; allowed [1, 10000]"},
    {"AbsorbingIncidentMediumOfACrystal", crystal + "sphere = 1.45\ndiameter_nm = 250\nincident = { n = 1.5, k = 1 }\n",
     "s.toml:5:12 [material.m]: incident absorbs, so no light reaches the layers through it; give a medium with k = 0"},
    {"NegativeSpread", crystal + "sphere = 1.45\ndiameter_nm = 250\nthickness_spread_nm = -1\n",
     "s.toml:5:23 [material.m]: thickness_spread_nm = -1 is out of range; allowed [0, 10000] nm"},
    {"UnknownKeyOfACrystal", crystal + "sphere = 1.45\ndiameter_nm = 250\nlattice = \"bcc\"\n",
     "s.toml:5:1 [material.m]: unknown key \"lattice\"; known: mechanism, incident, sphere, medium, diameter_nm, "
     "spacing_nm, planes, substrate, thickness_spread_nm, base, tilt_deg, roughness, polarisation"},
};

const std::vector<Mistake> scatter_mistakes{
    {"UnknownModel", scatter + "model = \"raleigh\"\nparticle = 1.5\nradius_nm = 20\n",
     "s.toml:3:9 [material.m]: unknown model \"raleigh\"; known: rayleigh, mie, quasi_ordered"},
    {"NoParticle", scatter + "radius_nm = 20\n",
     "s.toml:1:1 [material.m]: particle is missing; give a number, { n, k }, or the name of a material"},
    {"NoRadius", scatter + "particle = 1.5\n", "s.toml:1:1 [material.m]: radius_nm is missing; it is required"},
    {"RadiusOfNothing", scatter + "particle = 1.5\nradius_nm = 0\n",
     "s.toml:4:13 [material.m]: radius_nm = 0 is out of range; allowed [0.1, 10000000] nm"},
    {"AbsorbingMedium", scatter + "particle = 1.5\nradius_nm = 20\nmedium = { n = 1.5, k = 1e-9 }\n",
     "s.toml:5:10 [material.m]: medium absorbs, so no light reaches the particles; give a medium with k = 0"},
    {"MetalAsMedium", scatter + "particle = 1.5\nradius_nm = 20\nmedium = \"ag\"\n",
     "s.toml:5:10 [material.m]: medium absorbs, so no light reaches the particles; give a medium with k = 0"},
    {"LargeForRayleigh", scatter + "particle = 1.5\nradius_nm = 58\n",
     "s.toml:4:13 [material.m]: radius_nm = 58 is not small compared with the wavelength; use model = \"mie\", or a "
     "radius up to 57.29 nm"},
    {"LargeForRayleighInWater", scatter + "particle = 1.5\nradius_nm = 50\nmedium = 1.33\n",
     "s.toml:4:13 [material.m]: radius_nm = 50 is not small compared with the wavelength; use model = \"mie\", or a "
     "radius up to 43.07 nm"},
    {"LargeForMie", scatter + "model = \"mie\"\nparticle = 1.5\nradius_nm = 1e6\n",
     "s.toml:5:13 [material.m]: radius_nm = 1e+06 makes spheres of size parameters above 10000; give a radius up to "
     "572957.79 nm"},
    {"LargeForMieWithItsSpread", scatter + "model = \"mie\"\nparticle = 1.5\nradius_nm = 2e4\nradius_spread = 0.5\n",
     "s.toml:5:13 [material.m]: radius_nm = 20000 makes spheres of size parameters above 10000; give a radius up to "
     "9947.64 nm with this radius_spread"},
    {"SpreadOutOfRange", scatter + "particle = 1.5\nradius_nm = 20\nradius_spread = 0.6\n",
     "s.toml:5:17 [material.m]: radius_spread = 0.6 is out of range; allowed [0, 0.5]"},
    {"FractionOfNothing", scatter + "particle = 1.5\nradius_nm = 20\nvolume_fraction = 0\n",
     "s.toml:5:19 [material.m]: volume_fraction = 0 is out of range; allowed [1e-09, 0.6]"},
    {"FractionBeyondAll", scatter + "particle = 1.5\nradius_nm = 20\nvolume_fraction = 0.61\n",
     "s.toml:5:19 [material.m]: volume_fraction = 0.61 is out of range; allowed [1e-09, 0.6]"},
    {"LayerOfNothing", scatter + "particle = 1.5\nradius_nm = 20\nthickness_um = 0\n",
     "s.toml:5:16 [material.m]: thickness_um = 0 is out of range; allowed [1e-06, 1000000] um"},
    {"HardRadiusOfMie", scatter + "model = \"mie\"\nparticle = 1.5\nradius_nm = 20\nhard_radius_nm = 30\n",
     "s.toml:6:18 [material.m]: hard_radius_nm has no meaning for model mie; allowed for quasi_ordered"},
    {"HardRadiusInsideTheParticle",
     scatter + "model = \"quasi_ordered\"\nparticle = 1.5\nradius_nm = 100\nhard_radius_nm = 99\n",
     "s.toml:6:18 [material.m]: hard_radius_nm = 99 is inside the particle; give at least radius_nm, 100 nm"},
    {"HardSpheresTooDense",
     scatter + "model = \"quasi_ordered\"\nparticle = 1.5\nradius_nm = 100\nhard_radius_nm = 120\n",
     "s.toml:6:18 [material.m]: hard spheres of 120 nm fill 0.6912 of the volume, volume_fraction * (hard_radius_nm / "
     "radius_nm)^3; at most 0.6 is allowed, which is a hard_radius_nm up to 114.47 nm"},
    {"UnknownKeyOfAScatterer", scatter + "particle = 1.5\nradius_nm = 20\ndiameter_nm = 40\n",
     "s.toml:5:1 [material.m]: unknown key \"diameter_nm\"; known: mechanism, model, particle, medium, radius_nm, "
     "radius_spread, volume_fraction, hard_radius_nm, thickness_um, polarisation"},
};

const std::vector<Mistake> measured_mistakes{
    {"NothingMeasured", measured,
     "s.toml:1:1 [material.m]: file is missing; name a .csv, or give wavelength_nm, angle_deg and reflectance"},
    {"MissingReflectance", measured + "wavelength_nm = [400, 500]\nangle_deg = [0]\n",
     "s.toml:1:1 [material.m]: reflectance is missing; give an array of one row per angle"},
    {"FileAndNumbers", measured + "file = \"beetle.csv\"\nangle_deg = [0]\n",
     "s.toml:4:13 [material.m]: file and angle_deg are both given; give one of them"},
    {"FileWithHoles", measured + "file = \"holes.csv\"\n",
     "holes.csv:2:9: the value is missing; fill it in, or delete the row: nacre interpolates between the rows that are "
     "left"},
    {"FileThatIsNoName", measured + "file = 3\n", "s.toml:3:8 [material.m]: file = 3 is a whole number; give a string"},
    {"OneWavelength", measured + "wavelength_nm = [400]\nangle_deg = [0]\nreflectance = [[0.1]]\n",
     "s.toml:3:17 [material.m]: wavelength_nm has 1 numbers; allowed 2 to 1000000"},
    {"WavelengthsThatDescend", measured + "wavelength_nm = [500, 400]\nangle_deg = [0]\nreflectance = [[0.1, 0.1]]\n",
     "s.toml:3:17 [material.m]: wavelength_nm does not ascend; give every one once, smallest first"},
    {"AngleTwice",
     measured + "wavelength_nm = [400, 500]\nangle_deg = [0, 0]\nreflectance = [[0.1, 0.1], [0.1, 0.1]]\n",
     "s.toml:4:13 [material.m]: angle_deg does not ascend; give every one once, smallest first"},
    {"AngleBeyondGrazing", measured + "wavelength_nm = [400, 500]\nangle_deg = [91]\nreflectance = [[0.1, 0.1]]\n",
     "s.toml:4:14 [material.m]: angle_deg = 91 is out of range; allowed [0, 90] degrees"},
    {"NoAngles", measured + "wavelength_nm = [400, 500]\nangle_deg = []\nreflectance = []\n",
     "s.toml:4:13 [material.m]: angle_deg has 0 numbers; allowed 1 to 1000000"},
    {"RowMissing", measured + "wavelength_nm = [400, 500]\nangle_deg = [0, 10]\nreflectance = [[0.1, 0.1]]\n",
     "s.toml:5:15 [material.m]: reflectance has 1 rows; give 2, one per angle_deg"},
    {"RowTooShort", measured + "wavelength_nm = [400, 500]\nangle_deg = [0]\nreflectance = [[0.1]]\n",
     "s.toml:5:16 [material.m]: reflectance has 1 numbers in this row; give 2, one per wavelength_nm"},
    {"RowThatIsNone", measured + "wavelength_nm = [400, 500]\nangle_deg = [0]\nreflectance = [0.1, 0.1]\n",
     "s.toml:5:15 [material.m]: reflectance has 2 rows; give 1, one per angle_deg"},
    {"Percent", measured + "wavelength_nm = [400, 500]\nangle_deg = [0]\nreflectance = [[0.1, 11]]\n",
     "s.toml:5:22 [material.m]: reflectance = 11 is out of range; allowed [0, 10]"},
    {"NegativeReflectance", measured + "wavelength_nm = [400, 500]\nangle_deg = [0]\nreflectance = [[0.1, -0.1]]\n",
     "s.toml:5:22 [material.m]: reflectance = -0.1 is out of range; allowed [0, 10]"},
    {"UnknownKeyOfAMeasurement", measured + "file = \"beetle.csv\"\nfiles = 3\n",
     "s.toml:4:1 [material.m]: unknown key \"files\"; did you mean file?"},
};

const std::vector<Mistake> effect_mistakes{
    {"BaseOfAPalette", good_palette + "base = 0.5\n",
     "s.toml:8:1 [material.m]: base has no meaning for mechanism palette, which has no transmittance; allowed for "
     "film, stack, crystal"},
    {"BlackBaseOfAPalette", good_palette + "base = \"black\"\n",
     "s.toml:8:1 [material.m]: base has no meaning for mechanism palette, which has no transmittance; allowed for "
     "film, stack, crystal"},
    {"BaseOfAGrating", good_grating + "base = 0.5\n",
     "s.toml:8:1 [material.m]: base has no meaning for mechanism grating, which transmits nothing; allowed for film, "
     "stack, crystal"},
    {"BaseOfParticles", good_scatter + "base = 0.5\n",
     "s.toml:9:1 [material.m]: base has no meaning for mechanism scatter, which models only the light that its "
     "particles scatter; allowed for film, stack, crystal"},
    {"BaseOfAMeasurement", good_measured + "base = 0.5\n",
     "s.toml:9:1 [material.m]: base has no meaning for mechanism measured, which has no transmittance; allowed for "
     "film, stack, crystal"},
    {"TiltOfAGrating", good_grating + "tilt_deg = 5\n",
     "s.toml:8:1 [material.m]: tilt_deg has no meaning for mechanism grating, whose colour does not depend on the "
     "angle to the normal; allowed for palette, film, stack, crystal, measured"},
    {"TiltOfParticles", good_scatter + "tilt_deg = 5\n",
     "s.toml:9:1 [material.m]: tilt_deg has no meaning for mechanism scatter, whose particles have no facets; allowed "
     "for "
     "palette, film, stack, crystal, measured"},
    {"PolarisationOfAPalette", good_palette + "polarisation = \"mean\"\n",
     "s.toml:8:1 [material.m]: polarisation has no meaning for mechanism palette, which describes unpolarised light; "
     "allowed for film, stack, crystal, scatter"},
    {"PolarisationOfAGrating", good_grating + "polarisation = \"s\"\n",
     "s.toml:8:1 [material.m]: polarisation has no meaning for mechanism grating, whose theory is scalar; allowed for "
     "film, stack, crystal, scatter"},
    {"PolarisationOfAMeasurement", good_measured + "polarisation = \"s\"\n",
     "s.toml:9:1 [material.m]: polarisation has no meaning for mechanism measured, whose light is that of the "
     "measurement; allowed for film, stack, crystal, scatter"},
    {"SpreadOfAPalette", good_palette + "thickness_spread_nm = 5\n",
     "s.toml:8:1 [material.m]: thickness_spread_nm has no meaning for mechanism palette, which has no layers; allowed "
     "for "
     "film, stack, crystal"},
    {"SpreadOfAGrating", good_grating + "thickness_spread_nm = 5\n",
     "s.toml:8:1 [material.m]: thickness_spread_nm has no meaning for mechanism grating, which has no layers; allowed "
     "for "
     "film, stack, crystal"},
    {"SpreadOfParticles", good_scatter + "thickness_spread_nm = 5\n",
     "s.toml:9:1 [material.m]: thickness_spread_nm has no meaning for mechanism scatter, which has no layers "
     "(radius_spread is for its particles); allowed for film, stack, crystal"},
    {"SpreadOfAMeasurement", good_measured + "thickness_spread_nm = 5\n",
     "s.toml:9:1 [material.m]: thickness_spread_nm has no meaning for mechanism measured, whose measurement contains "
     "the spread; allowed for film, stack, crystal"},
    {"OrdersOfAPalette", good_palette + "orders = [1]\n",
     "s.toml:8:1 [material.m]: orders has no meaning for mechanism palette, which has no diffraction orders; allowed "
     "for "
     "grating"},
    {"OrdersOfAFilm", good_film + "orders = [1]\n",
     "s.toml:7:1 [material.m]: orders has no meaning for mechanism film, which has no diffraction orders; allowed for "
     "grating"},
    {"OrdersOfACrystal", good_crystal + "orders = [1]\n",
     "s.toml:9:1 [material.m]: orders has no meaning for mechanism crystal, which has no diffraction orders; allowed "
     "for "
     "grating"},
    {"TiltOutOfRange", good_film + "tilt_deg = 61\n",
     "s.toml:7:12 [material.m]: tilt_deg = 61 is out of range; allowed [0, 60] degrees"},
    {"RoughnessOutOfRange", good_film + "roughness = 1.01\n",
     "s.toml:7:13 [material.m]: roughness = 1.01 is out of range; allowed [0, 1]"},
    {"RoughnessAndTilt", good_film + "tilt_deg = 3\nroughness = 0.4\n",
     "s.toml:8:13 [material.m]: tilt_deg and roughness both say how the facets lean; remove one of them"},
    {"RoughnessOfAGrating", good_grating + "roughness = 0.4\n",
     "s.toml:8:1 [material.m]: roughness has no meaning for mechanism grating, whose colour does not depend on the "
     "angle to the normal; allowed for palette, film, stack, crystal, measured"},
    {"TiltInWords", good_film + "tilt_deg = \"some\"\n",
     "s.toml:7:12 [material.m]: tilt_deg = \"some\" is a string; give a number"},
    {"UnknownPolarisation", good_film + "polarisation = \"circular\"\n",
     "s.toml:7:16 [material.m]: unknown polarisation \"circular\"; known: mean, s, p, both"},
    {"PolarisationThatIsNoWord", good_film + "polarisation = 1\n",
     "s.toml:7:16 [material.m]: polarisation = 1 is a whole number; give a string"},
    {"MisspeltEffect", good_film + "tild_deg = 5\n",
     "s.toml:7:1 [material.m]: unknown key \"tild_deg\"; did you mean tilt_deg?"},
    {"UnknownBase", good_film + "base = \"white\"\n",
     "s.toml:7:8 [material.m]: unknown base \"white\"; known: black, a number, { rgb }, { spectrum }, { wavelength_nm, "
     "reflectance }, { pigment, scattering_per_um, share } or { metal }"},
    {"BrightBase", good_film + "base = 1.5\n", "s.toml:7:8 [material.m]: base = 1.5 is out of range; allowed [0, 1]"},
    {"NegativeBase", good_film + "base = -0.5\n",
     "s.toml:7:8 [material.m]: base = -0.5 is out of range; allowed [0, 1]"},
    {"BaseThatIsAList", good_film + "base = [1, 1, 1]\n",
     "s.toml:7:8 [material.m]: base = [...] is an array; give black, a number, { rgb }, { spectrum }, { wavelength_nm, "
     "reflectance }, { pigment, scattering_per_um, share } or { metal }"},
    {"BaseOfNothing", good_film + "base = {}\n",
     "s.toml:7:8 [material.m]: base does not say what it is; give a number, { rgb }, { spectrum }, { wavelength_nm, "
     "reflectance "
     "}, { pigment, scattering_per_um, share } or { metal }"},
    {"BaseOfSomethingUnknown", good_film + "base = { colour = [1, 0, 0] }\n",
     "s.toml:7:10 [material.m]: unknown key \"colour\"; known: rgb, spectrum, reflectance, pigment, metal, "
     "wavelength_nm, scattering_per_um, share"},
    {"BaseOfTwoThings", good_film + "base = { rgb = [1, 0, 0], metal = \"al\" }\n",
     "s.toml:7:35 [material.m]: base has both rgb and metal; give one of a number, { rgb }, { spectrum }, { "
     "wavelength_nm, reflectance }, { pigment, scattering_per_um, share } or { metal }"},
    {"BaseOfAShareOnly", good_film + "base = { share = 0.5 }\n",
     "s.toml:7:8 [material.m]: base does not say what it is; give a number, { rgb }, { spectrum }, { wavelength_nm, "
     "reflectance "
     "}, { pigment, scattering_per_um, share } or { metal }"},
    {"BaseOfTwoColours", good_film + "base = { rgb = [1, 0] }\n",
     "s.toml:7:16 [material.m]: rgb has 2 numbers; give three, of linear Rec.709: [red, green, blue]"},
    {"BaseBeyondTheCube", good_film + "base = { rgb = [1, 0, 1.01] }\n",
     "s.toml:7:23 [material.m]: rgb = 1.01 is out of range; allowed [0, 1]"},
    {"BaseOfAColourName", good_film + "base = { rgb = \"red\" }\n",
     "s.toml:7:16 [material.m]: rgb = \"red\" is a string; give an array"},
    {"RgbWithWavelengths", good_film + "base = { rgb = [1, 0, 0], wavelength_nm = [400, 500] }\n",
     "s.toml:7:27 [material.m]: unknown key \"wavelength_nm\"; known: rgb, spectrum, reflectance, pigment, metal"},
    {"BaseBrighterThanOne", good_film + "base = { spectrum = \"bright.csv\" }\n",
     "s.toml:7:21 [material.m]: \"bright.csv\" has a reflectance above 1, 1.2 at 500 nm; allowed [0, 1]; write unit = "
     "\"percent\" if it is percent"},
    {"BaseBelowZero", good_film + "base = { spectrum = \"dark.csv\" }\n",
     "s.toml:7:21 [material.m]: \"dark.csv\" has a reflectance below 0, -0.01 at 400 nm; allowed [0, 1]; write "
     "negative = \"clip\" if it is noise"},
    {"SpectrumWithoutReflectance", good_film + "base = { wavelength_nm = [400, 500] }\n",
     "s.toml:7:8 [material.m]: reflectance is missing; give an array of numbers"},
    {"SpectrumWithoutWavelengths", good_film + "base = { reflectance = [0.4, 0.5] }\n",
     "s.toml:7:8 [material.m]: wavelength_nm is missing; give an array of numbers"},
    {"SpectrumOfUnequalLists", good_film + "base = { wavelength_nm = [400, 500], reflectance = [0.4] }\n",
     "s.toml:7:52 [material.m]: wavelength_nm has 2 numbers and reflectance 1; allowed: as many of each, 2 to 100000"},
    {"SpectrumThatDescends", good_film + "base = { wavelength_nm = [500, 400], reflectance = [0.4, 0.4] }\n",
     "s.toml:7:26 [material.m]: wavelength_nm does not ascend; give every wavelength once, smallest first"},
    {"SpectrumInPercent", good_film + "base = { wavelength_nm = [400, 500], reflectance = [0.4, 40] }\n",
     "s.toml:7:58 [material.m]: reflectance = 40 is out of range; allowed [0, 1]"},
    {"PigmentThatDoesNotScatter", good_film + "base = { pigment = \"melanin\", scattering_per_um = 0 }\n",
     "s.toml:7:51 [material.m]: scattering_per_um = 0 is out of range; allowed [1e-09, 1000000] per um"},
    {"PigmentOfMoreThanAll", good_film + "base = { pigment = \"melanin\", share = 1.5 }\n",
     "s.toml:7:39 [material.m]: share = 1.5 is out of range; allowed [0, 1]"},
    {"PigmentWithAnUnknownKey", good_film + "base = { pigment = \"melanin\", depth = 1.5 }\n",
     "s.toml:7:31 [material.m]: unknown key \"depth\"; known: rgb, spectrum, reflectance, pigment, metal, "
     "scattering_per_um, share"},
    {"UnknownMetal", good_film + "base = { metal = \"aluminium\" }\n",
     "s.toml:7:18: unknown material \"aluminium\"; did you mean al?"},
    {"BaseBelowAMetal",
     std::string("mechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\nsubstrate = \"ag\"\n") + "base = 0.5\n",
     "s.toml:6:8 [material.m]: base lies below a substrate that absorbs, k = 5.8, so nothing comes back from it; give "
     "a substrate with k up to 1e-06"},
    {"BaseBelowSmokedGlass",
     std::string("mechanism = \"film\"\nindex = 1.5\nthickness_nm = 300\nsubstrate = { n = 1.5, k = 2e-6 }\n") +
         "base = { metal = \"al\" }\n",
     "s.toml:6:8 [material.m]: base lies below a substrate that absorbs, k = 2e-06, so nothing comes back from it; "
     "give a substrate with k up to 1e-06"},
};

INSTANTIATE_TEST_SUITE_P(Grating, BadEffects, testing::ValuesIn(grating_mistakes), name_of_case);
INSTANTIATE_TEST_SUITE_P(Crystal, BadEffects, testing::ValuesIn(crystal_mistakes), name_of_case);
INSTANTIATE_TEST_SUITE_P(Scatter, BadEffects, testing::ValuesIn(scatter_mistakes), name_of_case);
INSTANTIATE_TEST_SUITE_P(Measured, BadEffects, testing::ValuesIn(measured_mistakes), name_of_case);
INSTANTIATE_TEST_SUITE_P(Effects, BadEffects, testing::ValuesIn(effect_mistakes), name_of_case);

// The same through a whole scene and a file's header.
class EffectsScene : public testing::TestWithParam<Form> {};

TEST_P(EffectsScene, ComesBackFromTheHeaderAsTheSameJob) {
    const auto plan_of = [](const std::string& text) { return plan_scene(parse_scene(text, "s.toml"), scene_files()); };
    const Plan plan = plan_of("[material.m]\n" + GetParam().keys);
    ASSERT_GE(plan.luts.size(), 1u);
    for (const PlannedLut& lut : plan.luts) {
        const std::string header = scene_toml(lut);
        try {
            const Plan read = plan_of(header);
            ASSERT_EQ(read.luts.size(), 1u) << header;
            EXPECT_EQ(scene_toml(read.luts[0]), header);
        } catch (const Error& error) {
            FAIL() << error.what() << "\n" << header;
        }
    }
}

const std::vector<Form> scenes{
    {"Grating", good_grating, ""},
    {"Crystal", good_crystal + "base = 0.18\ntilt_deg = 5\nthickness_spread_nm = 3\n", ""},
    {"Scatter", good_scatter + "polarisation = \"s\"\n", ""},
    {"Measured", good_measured + "tilt_deg = 5\n", ""},
    {"Palette", good_palette + "tilt_deg = 5\n", ""},
    {"Film", good_film + "base = { rgb = [0.1, 0.25, 1] }\npolarisation = \"p\"\n", ""},
    {"Stack", good_stack + "base = { metal = \"al\" }\npolarisation = \"both\"\n", ""},
};
INSTANTIATE_TEST_SUITE_P(Scenes, EffectsScene, testing::ValuesIn(scenes), name_of_case);

}  // namespace
}  // namespace nacre::test
