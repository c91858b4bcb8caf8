// What `effects = "auto"` leaves out, and what is left of the bound with it: 300 random scenes, each planned with a
// bound, are compared with and without every effect that was dropped, and finished LUTs are fetched as a shader would
// and held against tests/reference/model.h, which calls nothing of src/. NACRE_EFFECTS_SWEEP=1 lets that model
// judge all scenes, NACRE_EFFECTS_SWEEP=0 a few, so that sanitizers end in seconds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "nacre/accuracy/choose_lut.h"
#include "nacre/accuracy/choose_sampling.h"
#include "nacre/accuracy/survey.h"
#include "nacre/colour/illuminant.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/material/effects.h"
#include "nacre/scene/readers/axis_reader.h"
#include "reference/lut.h"
#include "reference/materials.h"
#include "reference/model.h"
#include "reference/random_scenes.h"
#include "support/test_encoding.h"

namespace nacre::test {
namespace {

using reference::Model;
using reference::ModelScene;
using reference::ModelXyz;

// What the judge's own sums may err by, of a bound: each of the model's is asked for a quarter of it.
constexpr double judges_share = 0.02;

bool is_sweep(const char* value) {
    const char* sweep = std::getenv("NACRE_EFFECTS_SWEEP");
    return sweep != nullptr && std::string(sweep) == value;
}

// How many scenes lie between two that the model judges.
std::size_t stride_of_this_run() {
    return is_sweep("1") ? 1 : is_sweep("0") ? 50 : 10;
}

// ---- Scenes as the program has them ----

std::shared_ptr<const Light> light_of(const std::string& illuminant, int observer_deg) {
    static std::map<std::pair<std::string, int>, std::shared_ptr<const Light>> known;
    auto& light = known[{illuminant, observer_deg}];
    if (light) return light;
    LightSettings settings;
    settings.illuminant = illuminant;
    settings.power = *illuminant_by_name(illuminant);
    settings.observer = observer_deg == 10 ? Observer::cie1964_10deg : Observer::cie1931_2deg;
    light = std::make_shared<const Light>(make_light(std::move(settings)));
    return light;
}

PlannedLut planned(const ModelScene& scene) {
    PlannedLut lut;
    lut.name = scene.name;
    lut.job.material = {scene.name, scene.mechanism, {}};
    lut.job.light = light_of(scene.illuminant, scene.observer_deg);
    lut.job.x = default_axis(quantity_of(scene.mechanism));
    lut.request.max_de00 = scene.max_de00;
    return lut;
}

const std::vector<ModelScene>& scenes() {
    static const std::vector<ModelScene> all = reference::random_effects();
    return all;
}

// Made once.
const ChosenLut& chosen_scene(std::size_t i) {
    static const Encoding encoding = rec709_encoding();
    static std::map<std::size_t, ChosenLut> known;
    const auto found = known.find(i);
    return found != known.end() ? found->second
                                : known.emplace(i, choose_lut(planned(scenes()[i]), encoding)).first->second;
}

std::string names_of(const EffectSet& effects) {
    std::string names;
    for (const EffectRow& row : effect_rows())
        if (effects.has(row.effect)) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

// ---- Differences ----

struct Largest {
    double de00 = 0.0;
    double x = 0.0;
};

// At the scale of the brightest of `with`.
Largest largest_difference(const std::vector<ModelXyz>& with, const std::vector<ModelXyz>& without) {
    double brightest = 0.0;
    for (const ModelXyz& colour : with) brightest = std::max(brightest, colour.y);
    Largest largest;
    if (!(brightest > 0.0)) return largest;
    for (std::size_t i = 0; i < with.size(); ++i) {
        const double de00 = reference::difference(with[i], without[i], 1.0 / brightest);
        if (de00 > largest.de00) largest = {de00, static_cast<double>(i) / static_cast<double>(with.size() - 1)};
    }
    return largest;
}

// Colours all along a LUT, in the program's way, finely: both sides of a comparison have the same sampling.
std::vector<ModelXyz> program_colours(const Job& chosen, const EffectSet& without) {
    constexpr int points = 129;
    constexpr int nodes = 192;
    Job job = chosen;
    job.width = points;
    job.without = without;
    SpectralSampling sampling;
    sampling.nodes.fill(std::make_shared<const SpectralNodes>(make_spectral_nodes(job.light->weights, nodes)));
    // Many, where they are what is compared.
    sampling.thickness_samples = chosen.without.has(Effect::thickness_spread) ? 128 : 16;
    sampling.base_directions = 12;
    sampling.radii = 40;
    job.sampling = sampling;
    std::vector<ModelXyz> colours;
    for (const Xyz& colour : bake(job)) colours.push_back({colour.x, colour.y, colour.z});
    return colours;
}

// The same by the model, at fewer points: one takes milliseconds.
std::vector<ModelXyz> model_colours(const ModelScene& scene, const EffectSet& without, double first_nm) {
    constexpr int points = 33;
    ModelScene bare = scene;
    remove(without, bare.mechanism, first_nm);
    const Model model(bare, 1e-3 * scene.max_de00);
    std::vector<ModelXyz> colours;
    for (int i = 0; i < points; ++i) colours.push_back(model.at(static_cast<double>(i) / (points - 1)));
    return colours;
}

// ---- What is left out ----

struct Dropped {
    std::size_t scenes = 0, effects = 0, violations = 0;
    double worst_share = 0.0;
    std::string worst_name;
};

// @param colours  all along the LUT, without the effects that it is called with
template <class Colours>
void expect_shares_kept(const ModelScene& scene, const ChosenLut& chosen, const Colours& colours, Dropped& tally) {
    const auto named = static_cast<double>(chosen.effects.size());
    const double share = share_of_effects * scene.max_de00 / named;
    if (chosen.lut.job.without.is_empty()) {
        for (const EffectChoice& choice : chosen.effects) EXPECT_TRUE(choice.is_simulated) << scene.name;
        return;
    }
    const std::vector<ModelXyz> with = colours(EffectSet());
    EffectSet all;
    const auto expect_kept = [&](const EffectSet& without, double allowed, double predicted) {
        const Largest measured = largest_difference(with, colours(without));
        std::ostringstream what;
        what << scene.name << " (" << mechanism_name(scene.mechanism) << ", bound " << scene.max_de00 << ") without "
             << names_of(without) << ": " << measured.de00 << " at " << measured.x << ", allowed " << allowed
             << ", predicted " << predicted;
        EXPECT_LE(measured.de00, allowed) << what.str();
        tally.violations += measured.de00 > allowed ? 1 : 0;
        if (std::getenv("NACRE_ACCURACY_VERBOSE") != nullptr) std::cout << what.str() << "\n";
        if (measured.de00 / allowed > tally.worst_share)
            tally.worst_share = measured.de00 / allowed, tally.worst_name = scene.name + " " + names_of(without);
    };
    for (const EffectChoice& choice : chosen.effects) {
        EXPECT_DOUBLE_EQ(choice.share, share) << scene.name;
        EXPECT_EQ(chosen.lut.job.without.has(choice.effect), !choice.is_simulated) << scene.name;
        if (choice.is_simulated) continue;
        EXPECT_TRUE(choice.is_measured) << scene.name;
        EffectSet one;
        one.insert(choice.effect);
        all.insert(choice.effect);
        ++tally.effects;
        expect_kept(one, share, choice.contribution);
    }
    ++tally.scenes;
    if (all.size() > 1) expect_kept(all, share_of_effects * scene.max_de00, chosen.predicted.effects);
}

void print(const char* what, const Dropped& tally) {
    std::cout << "[ EFFECTS  ] " << what << ": " << tally.effects << " effects left out of " << tally.scenes
              << " scenes, " << tally.violations << " wrong; measured/share up to " << tally.worst_share << " ("
              << tally.worst_name << ")" << std::endl;
}

TEST(EffectsLeftOut, NeverCostMoreThanTheirShareIn300Scenes) {
    Dropped tally;
    for (std::size_t i = 0; i < scenes().size(); ++i) {
        const ChosenLut& chosen = chosen_scene(i);
        expect_shares_kept(
            scenes()[i], chosen, [&](const EffectSet& without) { return program_colours(chosen.lut.job, without); },
            tally);
    }
    print("by the program's own colours", tally);
    // The test would say nothing if nothing were dropped, or everything.
    EXPECT_GT(tally.effects, 100u);
    EXPECT_LT(tally.scenes, 250u);
}

TEST(EffectsLeftOut, NeverCostMoreThanTheirShareByAModelOfItsOwn) {
    Dropped tally;
    for (std::size_t i = 0; i < scenes().size(); i += stride_of_this_run()) {
        const ChosenLut& chosen = chosen_scene(i);
        if (chosen.lut.job.without.is_empty()) continue;
        const double first_nm = chosen.lut.job.light->settings.first_nm;
        expect_shares_kept(
            scenes()[i], chosen,
            [&](const EffectSet& without) { return model_colours(scenes()[i], without, first_nm); }, tally);
    }
    print("by the model's", tally);
}

constexpr double rad_per_deg = std::numbers::pi / 180.0;

// ---- The bound ----

reference::Pixels pixels_of(const Image<Rgb>& lut) {
    reference::Pixels pixels{lut.width(), lut.height(), {}};
    for (const Rgb& texel : lut) pixels.rgb.push_back({texel.r, texel.g, texel.b});
    return pixels;
}

struct Judged {
    std::size_t luts = 0, missed = 0, violations = 0, unconverged = 0;
    double worst_share = 0.0;
    std::string worst_name;
};

// @param points  at which the LUT is looked at: ends, and middles and other parts of texels all along
void expect_bound_kept(const ModelScene& scene, const ChosenLut& chosen, int points, Judged& tally) {
    const reference::Pixels lut =
        pixels_of(stored_as(rec709_encoding().to_rgb(bake(chosen.lut.job)), chosen.lut.format));
    const double scale = reference::scale_of(lut);
    const Model model(scene, 0.25 * judges_share * scene.max_de00);
    Largest worst;
    for (int i = 0; i <= points; ++i) {
        // Multiples of the golden ratio's part: within texels they fall everywhere.
        const double part = std::fmod((i + 1) * std::numbers::phi, 1.0);
        const double x = i == 0 ? 0.0 : i == points ? 1.0 : (i - 1 + part) / (points - 1);
        const double de00 = reference::error_at(lut, scale, x, 0.0, model.at(x));
        if (!(de00 <= worst.de00)) worst = {de00, x};
    }
    std::ostringstream what;
    what << scene.name << " (" << mechanism_name(scene.mechanism) << ") " << worst.de00 << " of " << scene.max_de00
         << " at " << worst.x << ", predicted " << chosen.predicted.total << ", " << lut.width << " texels, without "
         << names_of(chosen.lut.job.without) << ", " << model.unconverged() << " points unconverged";
    if (std::getenv("NACRE_ACCURACY_VERBOSE") != nullptr) std::cout << what.str() << "\n";
    ++tally.luts;
    tally.unconverged += model.unconverged();
    // What misses its bound says so; what it says still counts.
    const double allowed = std::max(scene.max_de00, chosen.is_reached ? 0.0 : chosen.predicted.total);
    tally.missed += chosen.is_reached ? 0 : 1;
    const bool is_wrong = !(worst.de00 <= (1.0 + judges_share) * allowed);
    EXPECT_FALSE(is_wrong) << what.str();
    tally.violations += is_wrong ? 1 : 0;
    if (worst.de00 / allowed > tally.worst_share)
        tally.worst_share = worst.de00 / allowed, tally.worst_name = scene.name;
}

void print(const char* what, const Judged& tally) {
    std::cout << "[ EFFECTS  ] " << what << ": " << tally.luts << " LUTs, " << tally.missed
              << " that miss their bound, " << tally.violations << " wrong; measured/bound up to " << tally.worst_share
              << " (" << tally.worst_name << "); " << tally.unconverged << " points unconverged" << std::endl;
}

Mechanism refined(Mechanism mechanism, const std::optional<Base>& base, double tilt_deg = 0.0) {
    mechanism.effects.base = base;
    mechanism.effects.relief.tilt_deg = tilt_deg;
    return mechanism;
}

std::vector<std::pair<std::string, Mechanism>> gratings() {
    Grating disc;
    disc.period_nm = 1600.0;
    disc.grooves = 40;
    disc.depth_nm = 110.0;
    disc.coat = reference::tabulated_index("al");
    Grating waves = disc;
    waves.profile = GratingProfile::sinusoidal;
    waves.period_nm = 740.0;
    waves.coat.reset();
    Grating turned = waves;
    turned.azimuth_deg = 25.0;
    turned.groove_length_um = 1.5;
    return {{"disc", disc}, {"waves", waves}, {"turned", turned}};
}

std::vector<std::pair<std::string, Mechanism>> crystals() {
    Crystal opal;
    opal.sphere = 1.45;
    opal.medium = 1.0;
    opal.planes = 10;
    opal.substrate = 1.45;
    Crystal inverse = opal;
    inverse.sphere = 1.0;
    inverse.medium = RefractiveIndex(1.8, 0.002);
    inverse.planes = 6;
    Mechanism through = inverse;
    through.effects.observed = Observed::transmittance;
    return {{"opal", opal},
            {"inverse opal", inverse},
            {"tilted opal", refined(opal, GreyBase{0.2}, 6.0)},
            {"seen through an inverse opal", through}};
}

std::vector<std::pair<std::string, Mechanism>> scatterers() {
    Scatter sky;
    sky.particle = 1.4;
    sky.medium = 1.0;
    sky.radius_nm = 20.0;
    sky.thickness_um = 5.0;
    Scatter milk = sky;
    milk.model = ScatterModel::mie;
    milk.medium = 1.33;
    milk.particle = RefractiveIndex(1.46, 1e-4);
    milk.radius_nm = 150.0;
    milk.radius_spread = 0.2;
    Scatter jay = milk;
    jay.model = ScatterModel::quasi_ordered;
    jay.particle = 1.0;
    jay.medium = 1.55;
    jay.radius_nm = 95.0;
    jay.radius_spread = 0.08;
    jay.volume_fraction = 0.35;
    return {{"sky", sky}, {"milk", milk}, {"jay", jay}};
}

std::vector<std::pair<std::string, Mechanism>> measurements() {
    MeasuredSpectra spectra;
    for (double nm = 360.0; nm <= 830.0; nm += 10.0) spectra.wavelength_nm.push_back(nm);
    spectra.angle_deg = {5.0, 20.0, 30.0, 55.0, 70.0};
    for (const double angle_deg : spectra.angle_deg) {
        const double peak_nm = 560.0 * std::sqrt(1.0 - std::pow(std::sin(angle_deg * rad_per_deg) / 1.56, 2.0));
        for (const double nm : spectra.wavelength_nm)
            spectra.reflectance.push_back(0.05 + 0.8 * std::exp(-std::pow((nm - peak_nm) / 40.0, 2.0)));
    }
    return {{"measured", spectra}, {"tilted measured", refined(spectra, {}, 4.0)}};
}

std::vector<std::pair<std::string, Mechanism>> bases() {
    const Film clear{1.0, 1.6, 350.0, 1.45, 0.0};
    const Film dark{1.0, RefractiveIndex(2.1, 0.03), 180.0, 1.5, 0.0};
    return {{"white", refined(clear, GreyBase{0.9})},
            {"coloured", refined(dark, RgbBase{{}, {6.0, -9.0, 2.0}})},
            {"pigment", refined(clear, PigmentBase{reference::tabulated_index("melanin"), 0.4, 0.1})},
            {"metal", refined(clear, MetalBase{reference::tabulated_index("au")})}};
}

std::vector<std::pair<std::string, Mechanism>> tilts() {
    const Film film{1.0, 2.0, 420.0, 1.5, 0.0};
    const Palette palette{{{10.0, {560.0, 90.0, 0.9}}, {45.0, {470.0, 70.0, 0.6}}}};
    return {{"hardly tilted", refined(film, {}, 0.2)},
            {"tilted", refined(film, GreyBase{0.3}, 8.0)},
            {"glitter", refined(film, {}, 40.0)},
            {"tilted palette", refined(palette, {}, 12.0)}};
}

Mechanism rough(Mechanism mechanism, double roughness) {
    mechanism.effects.relief.roughness = roughness;
    return mechanism;
}

std::vector<std::pair<std::string, Mechanism>> roughnesses() {
    const Film film{1.0, 2.0, 420.0, 1.5, 0.0};
    const Film soap{1.0, 1.33, 1400.0, 1.0, 0.0};
    const Palette palette{{{10.0, {560.0, 90.0, 0.9}}, {45.0, {470.0, 70.0, 0.6}}}};
    return {{"hardly rough", rough(film, 0.02)},     {"rough", rough(refined(film, GreyBase{0.3}), 0.4)},
            {"very rough", rough(film, 1.0)},        {"rough soap", rough(soap, 0.15)},
            {"rough palette", rough(palette, 0.25)}, {"rough spectra", rough(measurements().front().second, 0.3)}};
}

std::vector<std::pair<std::string, Mechanism>> spreads() {
    const Film film{1.0, 1.8, 500.0, 1.5, 30.0};
    Stack pair;
    pair.substrate = 1.5;
    for (const auto& [n, thickness_nm] : {std::pair{2.3, 70.0}, std::pair{1.38, 110.0}}) {
        Layer layer;
        layer.index = n;
        layer.thickness_nm = thickness_nm;
        pair.layers.push_back(layer);
    }
    pair.thickness_spread_nm = 6.0;
    Film slight = film;
    slight.thickness_spread_nm = 4.0;
    return {{"uneven film", film},
            {"uneven pair", pair},
            {"slightly uneven film on a base", refined(slight, GreyBase{0.4})}};
}

// From one direction facets are still seen at all angles: no effect and no wavelength is decided at that direction
// alone.
TEST(FacetsSeenFromOneSide, KeepTheBoundOverTheirAxis) {
    const Encoding encoding = rec709_encoding();
    for (const auto& [name, to] : {std::pair{"roughness", 1.0}, {"tilt_deg", 30.0}}) {
        for (const double angle_deg : {0.0, 30.0, 90.0}) {
            ModelScene scene{name, Film{1.0, 1.33, 400.0, 1.0, 0.0}};
            scene.max_de00 = 0.1;
            PlannedLut lut = planned(scene);
            lut.job.x = parameter_axis(scene.mechanism, name, 0.0, to);
            lut.job.fixed = Incidence::from_degrees(angle_deg);
            const ChosenLut chosen = choose_lut(lut, encoding);
            EXPECT_TRUE(chosen.is_reached) << name << " at " << angle_deg;
            EXPECT_FALSE(chosen.lut.job.without.has(Effect::polarisation)) << name << " at " << angle_deg;
            const reference::Pixels pixels =
                pixels_of(stored_as(encoding.to_rgb(bake(chosen.lut.job)), chosen.lut.format));
            for (const double x : {0.0, 0.13, 0.37, 0.5, 0.81, 1.0}) {
                ModelScene one = scene;
                lut.job.x.parameter.set(one.mechanism, x * to);
                const Model model(one, 0.25 * judges_share * scene.max_de00);
                const double sqrt_cos = std::sqrt(Incidence::from_degrees(angle_deg).cos_theta);
                const double de00 =
                    reference::error_at(pixels, reference::scale_of(pixels), x, 0.0, model.at(sqrt_cos));
                EXPECT_LE(de00, (1.0 + judges_share) * scene.max_de00) << name << " " << x << " at " << angle_deg;
            }
        }
    }
}

using NamedMechanisms = std::vector<std::pair<std::string, Mechanism>>;

struct Group {
    const char* name;
    NamedMechanisms (*mechanisms)();
};

void PrintTo(const Group& group, std::ostream* out) {
    *out << group.name;
}

class Budgets : public testing::TestWithParam<Group> {};

TEST_P(Budgets, HoldAtOneAndATenthAndAFiftieth) {
    Judged tally;
    const Encoding encoding = rec709_encoding();
    for (const auto& [name, mechanism] : GetParam().mechanisms()) {
        for (const double bound : {1.0, 0.1, 0.02}) {
            ModelScene scene{name, mechanism};
            scene.max_de00 = bound;
            expect_bound_kept(scene, choose_lut(planned(scene), encoding), is_sweep("1") ? 64 : 12, tally);
        }
    }
    print(GetParam().name, tally);
}

INSTANTIATE_TEST_SUITE_P(Effects, Budgets,
                         testing::Values(Group{"gratings", gratings}, Group{"crystals", crystals},
                                         Group{"scatter", scatterers}, Group{"measured", measurements},
                                         Group{"bases", bases}, Group{"tilts", tilts},
                                         Group{"roughnesses", roughnesses}, Group{"spreads", spreads}),
                         [](const auto& group) { return std::string(group.param.name); });

TEST(EffectsAccuracyContract, NoFetchIsFartherFromTheModelThanWasAsked) {
    Judged tally;
    for (std::size_t i = 1; i < scenes().size(); i += stride_of_this_run())
        expect_bound_kept(scenes()[i], chosen_scene(i), is_sweep("1") ? 64 : 24, tally);
    print("random scenes", tally);
}

// A crystal takes the model long, and is one of the groups above.
TEST(EffectsAccuracyContract, HoldsForWhatIsSeenThroughLayers) {
    Judged judged;
    Dropped dropped;
    const Encoding encoding = rec709_encoding();
    for (std::size_t i = 0; i < scenes().size(); i += is_sweep("1") ? 1 : is_sweep("0") ? 50 : 5) {
        const std::optional<ModelScene> scene = reference::seen_through(scenes()[i]);
        if (!scene || std::holds_alternative<Crystal>(scene->mechanism)) continue;
        const ChosenLut chosen = choose_lut(planned(*scene), encoding);
        expect_bound_kept(*scene, chosen, is_sweep("1") ? 64 : 24, judged);
        expect_shares_kept(
            *scene, chosen, [&](const EffectSet& without) { return program_colours(chosen.lut.job, without); },
            dropped);
    }
    print("seen through layers", judged);
    print("seen through layers", dropped);
    EXPECT_GT(judged.luts, is_sweep("0") ? 1u : 15u);
}

}  // namespace
}  // namespace nacre::test
