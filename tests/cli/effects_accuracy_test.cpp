// What `effects = "auto"` leaves out, and what is left of the bound with it: 300 random scenes, each planned with a
// bound, are compared with and without every effect that was dropped, and finished LUTs are fetched as a shader would
// and held against tests/reference/effects_model.h, which calls nothing of src/. NACRE_EFFECTS_SWEEP=1 lets that model
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
#include <sstream>
#include <string>
#include <vector>

#include "nacre/accuracy/settle.h"
#include "nacre/bake/bake.h"
#include "nacre/bake/effects.h"
#include "nacre/colour/illuminant.h"
#include "reference/dense_layers.h"
#include "reference/dense_model.h"
#include "reference/effects_model.h"
#include "reference/exact_mie.h"
#include "reference/random_effect_scenes.h"
#include "support/test_encoding.h"

namespace nacre::test {
namespace {

using reference::EffectScene;
using reference::EffectsModel;
using reference::ModelLab;
using reference::ModelXyz;

// What the judge's own sums may err by, of a bound: each of the model's is asked for a quarter of it.
constexpr double judges_share = 0.02;

bool is_sweep(const char* value) {
    const char* sweep = std::getenv("NACRE_EFFECTS_SWEEP");
    return sweep != nullptr && std::string(sweep) == value;
}

// How many scenes lie between two that the model judges.
std::size_t stride_of_this_run() {
    return is_sweep("1") ? 1 : is_sweep("0") ? 30 : 6;
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

PlannedLut planned(const EffectScene& scene) {
    PlannedLut lut;
    lut.name = scene.name;
    lut.job.material = {scene.name, scene.mechanism, {}};
    lut.job.light = light_of(scene.illuminant, scene.observer_deg);
    lut.job.x = default_axis(quantity_of(scene.mechanism));
    lut.wish.max_de00 = scene.max_de00;
    return lut;
}

const std::vector<EffectScene>& scenes() {
    static const std::vector<EffectScene> all = reference::random_effect_scenes();
    return all;
}

// Plans are what every test here begins with.
const std::vector<SettledLut>& settled_scenes() {
    static const std::vector<SettledLut> all = [] {
        const Encoding encoding = rec709_encoding();
        std::vector<SettledLut> settled;
        for (const EffectScene& scene : scenes()) settled.push_back(settle(planned(scene), encoding));
        return settled;
    }();
    return all;
}

std::string names_of(const EffectSet& effects) {
    std::string names;
    for (const EffectRow& row : effect_rows())
        if (effects.has(row.effect)) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

// ---- Differences ----

ModelLab scaled_lab(const ModelXyz& colour, double scale) {
    return reference::lab_of({scale * colour.x, scale * colour.y, scale * colour.z});
}

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
        const double de00 =
            reference::ciede2000(scaled_lab(with[i], 1.0 / brightest), scaled_lab(without[i], 1.0 / brightest));
        if (de00 > largest.de00) largest = {de00, static_cast<double>(i) / static_cast<double>(with.size() - 1)};
    }
    return largest;
}

// Colours all along a LUT, in the program's way, finely: both sides of a comparison have the same sampling.
std::vector<ModelXyz> program_colours(const Job& settled, const EffectSet& without) {
    constexpr int points = 129;
    constexpr int nodes = 192;
    Job job = settled;
    job.width = points;
    job.without = without;
    job.integral = Integral::exact;
    SpectralSampling sampling;
    sampling.nodes.fill(std::make_shared<const SpectralNodes>(make_spectral_nodes(job.light->weights, nodes)));
    sampling.realisations = 128;
    sampling.hemisphere = 12;
    sampling.sizes = 40;
    job.sampling = sampling;
    std::vector<ModelXyz> colours;
    for (const Xyz& colour : bake(job)) colours.push_back({colour.x, colour.y, colour.z});
    return colours;
}

// The same by the model, at fewer points: one takes milliseconds.
std::vector<ModelXyz> model_colours(const EffectScene& scene, const EffectSet& without, double first_nm) {
    constexpr int points = 33;
    Mechanism mechanism = scene.mechanism;
    remove(without, mechanism, first_nm);
    const EffectsModel model(mechanism, scene.illuminant, scene.observer_deg, 1e-3 * scene.max_de00);
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
void expect_shares_kept(const EffectScene& scene, const SettledLut& settled, const Colours& colours, Dropped& tally) {
    const auto named = static_cast<double>(settled.effects.size());
    const double share = share_of_effects * scene.max_de00 / named;
    if (settled.lut.job.without.is_empty()) {
        for (const EffectChoice& choice : settled.effects) EXPECT_TRUE(choice.is_simulated) << scene.name;
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
    for (const EffectChoice& choice : settled.effects) {
        EXPECT_DOUBLE_EQ(choice.share, share) << scene.name;
        EXPECT_EQ(settled.lut.job.without.has(choice.effect), !choice.is_simulated) << scene.name;
        if (choice.is_simulated) continue;
        EXPECT_TRUE(choice.is_measured) << scene.name;
        EffectSet one;
        one.insert(choice.effect);
        all.insert(choice.effect);
        ++tally.effects;
        expect_kept(one, share, choice.contribution);
    }
    ++tally.scenes;
    if (all.size() > 1) expect_kept(all, share_of_effects * scene.max_de00, settled.predicted.effects);
}

void print(const char* what, const Dropped& tally) {
    std::cout << "[ EFFECTS  ] " << what << ": " << tally.effects << " effects left out of " << tally.scenes
              << " scenes, " << tally.violations << " wrong; measured/share up to " << tally.worst_share << " ("
              << tally.worst_name << ")" << std::endl;
}

TEST(EffectsLeftOut, NeverCostMoreThanTheirShareIn300Scenes) {
    Dropped tally;
    for (std::size_t i = 0; i < scenes().size(); ++i) {
        const SettledLut& settled = settled_scenes()[i];
        expect_shares_kept(
            scenes()[i], settled, [&](const EffectSet& without) { return program_colours(settled.lut.job, without); },
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
        const SettledLut& settled = settled_scenes()[i];
        if (settled.lut.job.without.is_empty()) continue;
        const double first_nm = settled.lut.job.light->settings.first_nm;
        expect_shares_kept(
            scenes()[i], settled,
            [&](const EffectSet& without) { return model_colours(scenes()[i], without, first_nm); }, tally);
    }
    print("by the model's", tally);
}

// ---- The bound ----

// A shader's fetch: texel centres, linear filter, clamped.
ModelXyz fetched(const Image<Rgb>& lut, double x) {
    const double place = x * (lut.width() - 1);
    const int low = std::min(static_cast<int>(place), lut.width() - 2);
    const double share = place - low;
    const Rgb &a = lut.at(low, 0), &b = lut.at(low + 1, 0);
    return reference::from_rec709(
        {(1.0 - share) * a.r + share * b.r, (1.0 - share) * a.g + share * b.g, (1.0 - share) * a.b + share * b.b});
}

struct Judged {
    std::size_t luts = 0, missed = 0, violations = 0, unsettled = 0;
    double worst_share = 0.0;
    std::string worst_name;
};

// @param points  at which the LUT is looked at: ends, and middles and other parts of texels all along
void expect_bound_kept(const EffectScene& scene, const SettledLut& settled, int points, Judged& tally) {
    const Image<Rgb> lut = stored_as(rec709_encoding().to_rgb(bake(settled.lut.job)), settled.lut.format);
    double brightest = 0.0;
    for (const Rgb& texel : lut) brightest = std::max(brightest, reference::from_rec709({texel.r, texel.g, texel.b}).y);
    const double scale = brightest > 0.0 ? 1.0 / brightest : 1.0;
    const EffectsModel model(scene.mechanism, scene.illuminant, scene.observer_deg,
                             0.25 * judges_share * scene.max_de00);
    Largest worst;
    for (int i = 0; i <= points; ++i) {
        // Multiples of the golden ratio's part: within texels they fall everywhere.
        const double part = std::fmod((i + 1) * std::numbers::phi, 1.0);
        const double x = i == 0 ? 0.0 : i == points ? 1.0 : (i - 1 + part) / (points - 1);
        const double de00 = reference::ciede2000(scaled_lab(fetched(lut, x), scale), scaled_lab(model.at(x), scale));
        if (!(de00 <= worst.de00)) worst = {de00, x};
    }
    std::ostringstream what;
    what << scene.name << " (" << mechanism_name(scene.mechanism) << ") " << worst.de00 << " of " << scene.max_de00
         << " at " << worst.x << ", predicted " << settled.predicted.total << ", " << lut.width() << " texels, without "
         << names_of(settled.lut.job.without) << ", " << model.unsettled() << " points unsettled";
    if (std::getenv("NACRE_ACCURACY_VERBOSE") != nullptr) std::cout << what.str() << "\n";
    ++tally.luts;
    tally.unsettled += model.unsettled();
    // What misses its bound says so; what it says still counts.
    const double allowed = std::max(scene.max_de00, settled.is_reached ? 0.0 : settled.predicted.total);
    tally.missed += settled.is_reached ? 0 : 1;
    const bool is_wrong = !(worst.de00 <= (1.0 + judges_share) * allowed);
    EXPECT_FALSE(is_wrong) << what.str();
    tally.violations += is_wrong ? 1 : 0;
    if (worst.de00 / allowed > tally.worst_share)
        tally.worst_share = worst.de00 / allowed, tally.worst_name = scene.name;
}

void print(const char* what, const Judged& tally) {
    std::cout << "[ EFFECTS  ] " << what << ": " << tally.luts << " LUTs, " << tally.missed
              << " that miss their bound, " << tally.violations << " wrong; measured/bound up to " << tally.worst_share
              << " (" << tally.worst_name << "); " << tally.unsettled << " points unsettled" << std::endl;
}

TEST(EffectsAccuracyContract, NoFetchIsFartherFromTheModelThanWasAsked) {
    Judged tally;
    for (std::size_t i = 1; i < scenes().size(); i += stride_of_this_run())
        expect_bound_kept(scenes()[i], settled_scenes()[i], is_sweep("1") ? 64 : 24, tally);
    print("random scenes", tally);
}

}  // namespace
}  // namespace nacre::test
