// What refines a mechanism: identities that must hold, what an effect of size 0 may change (no bit), and what an absent
// one may cost (nothing).
#include "nacre/material/effects.h"
#include "nacre/accuracy/choose_sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/lut/bake.h"
#include "nacre/pick/smooth_rgb.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/shade/layered_colour.h"
#include "nacre/shade/spectra.h"

namespace nacre {
namespace {

std::shared_ptr<const Light> daylight() {
    static const std::shared_ptr<const Light> light = [] {
        LightSettings settings;
        settings.power = *illuminant_by_name("D65");
        return std::make_shared<const Light>(make_light(settings));
    }();
    return light;
}

Job job_of(const Mechanism& mechanism, int width = 33) {
    Job job;
    job.material = {"m", mechanism, {}};
    job.light = daylight();
    job.x = default_axis(quantity_of(mechanism));
    job.width = width;
    return job;
}

// Few nodes, the same for all: enough to compare bakes with one another.
Job sampled(const Mechanism& mechanism, int nodes = 64) {
    Job job = job_of(mechanism);
    job.sampling.nodes.fill(std::make_shared<const SpectralNodes>(make_spectral_nodes(job.light->weights, nodes)));
    return job;
}

Layer layer_of(const Index& index, double thickness_nm, bool is_incoherent = false) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    layer.is_incoherent = is_incoherent;
    return layer;
}

Index flint() {
    IndexCurve curve;
    curve.name = "flint";
    curve.n = IndexFormula{5, {1.6, 0.01, -2.0}};
    return Index(std::make_shared<const IndexCurve>(curve));
}

Film film_on(const Index& substrate, double thickness_nm = 300.0, const Index& index = 1.8) {
    return {1.0, index, thickness_nm, substrate, 0.0};
}

Stack stack_of(std::vector<Layer> layers) {
    return {1.0, std::move(layers), 1.5, 0.0};
}

Crystal opal() {
    Crystal crystal;
    crystal.incident = 1.0;
    crystal.sphere = 1.45;
    crystal.medium = 1.33;
    crystal.planes = 8;
    crystal.substrate = 1.33;
    return crystal;
}

Scatter mist() {
    Scatter scatter;
    scatter.model = ScatterModel::mie;
    scatter.particle = 1.5;
    scatter.medium = 1.33;
    scatter.radius_nm = 120.0;
    return scatter;
}

Grating disc() {
    Grating grating;
    grating.grooves = 10;
    grating.depth_nm = 100.0;
    return grating;
}

Palette morpho() {
    return {{{0.0, {460.0, 70.0, 1.0}}, {40.0, {395.0, 60.0, 0.7}}}, 0.26};
}

Mechanism with_base(Mechanism mechanism, const Base& base) {
    mechanism.effects.base = base;
    return mechanism;
}

bool same_bits(const Image<Xyz>& one, const Image<Xyz>& other) {
    return one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size() * sizeof(Xyz)) == 0;
}

constexpr std::array angles_deg{0.0, 10.0, 35.0, 60.0, 80.0, 89.0, 89.99, 90.0};
const std::vector<double> wavelengths_nm{380.0, 430.0, 480.0, 530.0, 555.0, 600.0, 650.0, 720.0, 800.0};

// ---- Bases ----

TEST(Base, ThroughAVanishingFilmIsTheBaseItself) {
    const std::vector<Base> bases{GreyBase{0.0},
                                  GreyBase{0.37},
                                  GreyBase{1.0},
                                  RgbBase{{}, {4.0, -3.0, 0.5}},
                                  SpectrumBase{{{360.0, 500.0, 830.0}, {0.1, 0.9, 0.3}}},
                                  PigmentBase{RefractiveIndex(1.5, 0.01), 0.5, 0.2}};
    // Nothing at all, and as much as one likes of what is all around.
    const std::vector<Mechanism> films{film_on(1.0, 0.0, 1.0), film_on(1.0, 500.0, 1.0),
                                       Film{1.5, 1.5, 300.0, 1.5, 0.0}, stack_of({}), film_on(1.0, 0.0, 2.2)};
    for (std::size_t i = 0; i < films.size(); ++i) {
        if (i == 3) continue;  // a face from air to 1.5 is left of it
        for (const Base& base : bases) {
            for (const double theta_deg : angles_deg) {
                const auto seen =
                    responses_at(with_base(films[i], base), Incidence::from_degrees(theta_deg), wavelengths_nm);
                for (std::size_t k = 0; k < seen.size(); ++k) {
                    // At 90 degrees to the last bits the face between equal media is 0 / 0.
                    EXPECT_NEAR(seen[k].reflectance_s, diffuse_reflectance(base, wavelengths_nm[k]), 1e-12)
                        << i << " " << theta_deg;
                    EXPECT_NEAR(seen[k].reflectance_p, diffuse_reflectance(base, wavelengths_nm[k]), 1e-12)
                        << i << " " << theta_deg;
                    EXPECT_EQ(seen[k].transmittance(), 0.0);
                }
            }
        }
    }
}

TEST(Base, OfMetalThroughAVanishingFilmIsTheMetal) {
    const RefractiveIndex gold(0.4, 2.5);
    const Mechanism on_base = with_base(film_on(1.0, 0.0, 1.0), MetalBase{gold});
    const Mechanism on_substrate = film_on(gold, 0.0, 1.0);
    for (const double theta_deg : angles_deg) {
        const Incidence incidence = Incidence::from_degrees(theta_deg);
        const auto base = responses_at(on_base, incidence, wavelengths_nm);
        const auto substrate = responses_at(on_substrate, incidence, wavelengths_nm);
        for (std::size_t k = 0; k < base.size(); ++k) {
            EXPECT_NEAR(base[k].reflectance_s, substrate[k].reflectance_s, 1e-12) << theta_deg;
            EXPECT_NEAR(base[k].reflectance_p, substrate[k].reflectance_p, 1e-12) << theta_deg;
        }
    }
    const double normal = std::norm((gold - 1.0) / (gold + 1.0));
    EXPECT_NEAR(response_at(on_base, Incidence{}, 555.0).reflectance(), normal, 1e-14);
}

// What is not absorbed comes back.
TEST(Base, WhiteUnderLayersThatTakeNothingReflectsEverything) {
    Film spread = film_on(1.6);
    spread.thickness_spread_nm = 25.0;
    const std::vector<Mechanism> lossless{
        film_on(1.5), film_on(1.0), Film{1.7, 1.3, 700.0, 1.4, 0.0},
        spread,       opal(),       stack_of({layer_of(2.3, 60.0), layer_of(1.5, 1e6, true), layer_of(flint(), 90.0)})};
    for (const Mechanism& mechanism : lossless) {
        for (const double theta_deg : angles_deg) {
            for (const Polarisation polarisation : {Polarisation::s, Polarisation::p, Polarisation::mean}) {
                const auto seen = responses_at(with_base(mechanism, GreyBase{1.0}), Incidence::from_degrees(theta_deg),
                                               wavelengths_nm);
                for (const Response& response : seen)
                    EXPECT_NEAR(reflectance_of(response, polarisation), 1.0, 1e-9)
                        << mechanism_name(mechanism) << " " << theta_deg;
            }
        }
    }
    // And its colour is white at every texel.
    const Job job = sampled(with_base(film_on(1.5), GreyBase{1.0}));
    const Xyz white = adapt(job.light->adaptation, job.light->white());
    for (const Xyz& texel : bake(job)) {
        EXPECT_NEAR(texel.x, white.x, 1e-9);
        EXPECT_NEAR(texel.y, white.y, 1e-9);
        EXPECT_NEAR(texel.z, white.z, 1e-9);
    }
}

TEST(Base, NeverGivesMoreThanThereIs) {
    const std::vector<Base> bases{GreyBase{0.9}, GreyBase{1.0}, PigmentBase{RefractiveIndex(1.5, 1e-4), 2.0, 0.5},
                                  MetalBase{RefractiveIndex(0.05, 3.6)}, MetalBase{RefractiveIndex(1.2, 7.0)}};
    const std::vector<Mechanism> layers{film_on(1.5, 300.0, RefractiveIndex(1.9, 0.2)), film_on(1.0), film_on(2.4),
                                        Film{1.6, 1.2, 400.0, 1.9, 0.0}, opal()};
    for (const Base& base : bases) {
        for (const Mechanism& mechanism : layers) {
            for (const double theta_deg : angles_deg) {
                const auto seen =
                    responses_at(with_base(mechanism, base), Incidence::from_degrees(theta_deg), wavelengths_nm);
                const auto bare = responses_at(mechanism, Incidence::from_degrees(theta_deg), wavelengths_nm);
                for (std::size_t k = 0; k < seen.size(); ++k) {
                    EXPECT_LE(seen[k].reflectance_s, 1.0 + 1e-12);
                    EXPECT_LE(seen[k].reflectance_p, 1.0 + 1e-12);
                    EXPECT_GE(seen[k].reflectance_s, bare[k].reflectance_s - 1e-12) << "a base only adds";
                    EXPECT_GE(seen[k].reflectance_p, bare[k].reflectance_p - 1e-12) << "a base only adds";
                }
            }
        }
    }
}

// The half space of 1.5 below a face: with Duntley's and Walsh's integral of Fresnel's formula for light that comes
// evenly from all directions, 0.0918 of it is reflected from outside (Judd 1942, J. Res. NBS 29, 329, table 1), so that
// from inside 1 - (1 - 0.0918) / 1.5^2 = 0.5964 is, by reciprocity.
TEST(Base, LosesBelowAFaceOfGlassWhatJuddsTableSays) {
    const double from_outside = 0.0918;
    const double inside = 1.0 - (1.0 - from_outside) / 2.25;
    const Mechanism glass = Film{1.0, 1.5, 0.0, 1.5, 0.0};
    for (const double rho : {0.1, 0.5, 0.9}) {
        const double nm = 555.0;
        const auto factors = base_factors(GreyBase{rho}, layer_ensemble(glass, 1), {&nm, 1}, 64);
        // Four digits of the table.
        EXPECT_NEAR(factors.front(), rho * (1.0 - inside) / (1.0 - rho * inside), 1e-4) << rho;
        // Seen from above at the normal: Fresnel's 4 % of it on top.
        const double seen = response_at(with_base(glass, GreyBase{rho}), Incidence{}, nm).reflectance();
        EXPECT_NEAR(seen, 0.04 + 0.96 * factors.front(), 1e-6) << rho;
    }
}

TEST(Base, OfAnRgbColourLooksLikeThatColour) {
    const auto primaries = *primaries_by_interop_id("lin_rec709_scene");
    for (const std::array<double, 3>& rgb :
         {std::array{0.8, 0.2, 0.1}, std::array{0.05, 0.4, 0.9}, std::array{0.5, 0.5, 0.5}}) {
        const Job job = sampled(with_base(film_on(1.0, 0.0, 1.0), upsampled(rgb).base), 512);
        for (const Xyz& texel : bake(job)) {
            const Xyz seen = adapt(xyz_to_rgb_matrix(primaries), texel);
            // The reflectance was made for a sum over whole nanometres; nodes differ from it by CIEDE2000 0.001.
            EXPECT_NEAR(seen.x, rgb[0], 2e-5);
            EXPECT_NEAR(seen.y, rgb[1], 2e-5);
            EXPECT_NEAR(seen.z, rgb[2], 2e-5);
        }
    }
}

// ---- Effects of size nothing ----

struct Nothing {
    std::string name;
    Mechanism plain;
    std::function<void(Mechanism&)> set_to_zero;
};

TEST(Effects, OfSizeZeroChangeNoBit) {
    const auto no_tilt = [](Mechanism& m) { m.effects.relief.tilt_deg = 0.0; };
    std::vector<Nothing> cases{
        {"film", film_on(1.5), no_tilt}, {"palette", morpho(), no_tilt}, {"opal", opal(), no_tilt}};
    const auto no_roughness = [](Mechanism& m) { m.effects.relief.roughness = 0.0; };
    cases.push_back({"film", film_on(1.5), no_roughness});
    cases.push_back({"palette", morpho(), no_roughness});
    cases.push_back({"film", film_on(1.5), [](Mechanism& m) { std::get<Film>(m).thickness_spread_nm = 0.0; }});
    cases.push_back({"stack", stack_of({layer_of(2.3, 60.0), layer_of(1.38, 100.0)}),
                     [](Mechanism& m) { std::get<Stack>(m).thickness_spread_nm = 0.0; }});
    cases.push_back({"opal", opal(), [](Mechanism& m) { std::get<Crystal>(m).thickness_spread_nm = 0.0; }});
    cases.push_back({"mist", mist(), [](Mechanism& m) { std::get<Scatter>(m).radius_spread = 0.0; }});
    for (const Nothing& nothing : cases) {
        Job job = sampled(nothing.plain);
        const Image<Xyz> plain = bake(job);
        nothing.set_to_zero(job.material.mechanism);
        // Whatever number of points there would be, had the effect a size.
        job.sampling.thickness_samples = 64;
        job.sampling.base_directions = 32;
        job.sampling.radii = 48;
        EXPECT_TRUE(same_bits(bake(job), plain)) << nothing.name;
        // The other way round: with a size, removed by name.
        Mechanism refined = nothing.plain;
        refined.effects.relief.tilt_deg = 10.0;
        if (auto* film = std::get_if<Film>(&refined)) film->thickness_spread_nm = 20.0;
        if (auto* stack = std::get_if<Stack>(&refined)) stack->thickness_spread_nm = 20.0;
        if (auto* crystal = std::get_if<Crystal>(&refined)) crystal->thickness_spread_nm = 5.0;
        if (auto* scatter = std::get_if<Scatter>(&refined))
            scatter->radius_spread = 0.2, refined.effects.relief.tilt_deg = 0.0;
        job.material.mechanism = refined;
        EXPECT_FALSE(same_bits(bake(job), plain)) << nothing.name;
        for (const Effect effect : {Effect::tilt, Effect::roughness, Effect::thickness_spread, Effect::size_spread})
            job.without.insert(effect);
        EXPECT_TRUE(same_bits(bake(job), plain)) << nothing.name;
        if (refined.effects.relief.is_plane()) continue;
        job.material.mechanism.effects.relief = {0.0, 0.4};
        EXPECT_TRUE(same_bits(bake(job), plain)) << nothing.name;
    }
}

TEST(Effects, OnAnAxisThatBeginsAtZeroBeginWithThePlainColour) {
    for (const char* parameter : {"tilt_deg", "roughness"}) {
        for (const Mechanism& mechanism : {Mechanism(film_on(1.5)), Mechanism(morpho())}) {
            Job job = sampled(mechanism);
            const Image<Xyz> plain = bake(job);
            job.y = parameter_axis(mechanism, parameter, 0.0, 1.0);
            job.height = 3;
            const Image<Xyz> both = bake(job);
            for (int column = 0; column < job.width; ++column) {
                EXPECT_EQ(both.at(column, 0).x, plain.at(column, 0).x);
                EXPECT_EQ(both.at(column, 0).y, plain.at(column, 0).y);
                EXPECT_EQ(both.at(column, 0).z, plain.at(column, 0).z);
            }
        }
    }
}

// ---- Polarisation ----

TEST(Polarisation, LutsOfSAndPAverageToTheMean) {
    Film spread = film_on(1.5);
    spread.thickness_spread_nm = 15.0;
    Mechanism tilted = film_on(1.5);
    tilted.effects.relief.tilt_deg = 8.0;
    const std::vector<Mechanism> all{film_on(RefractiveIndex(0.4, 2.5)),
                                     spread,
                                     tilted,
                                     opal(),
                                     mist(),
                                     with_base(film_on(1.5), GreyBase{0.6}),
                                     with_base(film_on(1.5), MetalBase{RefractiveIndex(0.4, 2.5)}),
                                     stack_of({layer_of(2.3, 60.0), layer_of(1.52, 1e6, true)})};
    for (const Mechanism& mechanism : all) {
        Job job = sampled(mechanism);
        job.sampling.thickness_samples = 16;
        const Image<Xyz> mean = bake(job);
        job.material.mechanism.effects.polarisation = Polarisation::s;
        const Image<Xyz> s = bake(job);
        job.material.mechanism.effects.polarisation = Polarisation::p;
        const Image<Xyz> p = bake(job);
        // A mean over facets is one over a curve, which is as good as CIEDE2000 0.001.
        const double tolerance = mechanism.effects.relief.tilt_deg > 0.0 ? 2e-5 : 1e-12;
        double apart = 0.0;
        for (int i = 0; i < job.width; ++i) {
            EXPECT_NEAR(0.5 * (s.at(i, 0).x + p.at(i, 0).x) / mean.at(i, 0).x, 1.0, tolerance);
            EXPECT_NEAR(0.5 * (s.at(i, 0).y + p.at(i, 0).y) / mean.at(i, 0).y, 1.0, tolerance);
            EXPECT_NEAR(0.5 * (s.at(i, 0).z + p.at(i, 0).z) / mean.at(i, 0).z, 1.0, tolerance);
            apart = std::max(apart, std::abs(s.at(i, 0).y - p.at(i, 0).y));
        }
        EXPECT_GT(apart, 1e-3) << mechanism_name(mechanism);
    }
}

// ---- What is absent ----

std::string names_of(const EffectSet& effects) {
    std::string names;
    for (const EffectRow& row : effect_rows())
        if (effects.has(row.effect)) names += std::string(row.name) + " ";
    return names;
}

EffectWorks works_of(const Mechanism& mechanism) {
    Job job = sampled(mechanism, 32);
    job.width = 9;
    job.sampling.thickness_samples = 4;
    job.sampling.radii = 6;
    Work work;
    bake(job, {}, &work);
    return work.effects;
}

bool is_counted(const EffectWork& work) {
    return !(work == EffectWork());
}

EffectSet set_of(std::initializer_list<Effect> effects) {
    EffectSet set;
    for (const Effect effect : effects) set.insert(effect);
    return set;
}

struct Counted {
    Mechanism mechanism;
    EffectSet effects;
};

// Each with what it has, and nothing besides.
std::vector<Counted> counted() {
    constexpr auto pol = Effect::polarisation;
    std::vector<Counted> all{
        {morpho(), {}},          {film_on(1.5), set_of({pol})}, {stack_of({layer_of(2.3, 60.0)}), set_of({pol})},
        {opal(), set_of({pol})}, {mist(), set_of({pol})},       {disc(), set_of({Effect::higher_orders})}};
    Mechanism s_only = film_on(1.5);
    s_only.effects.polarisation = Polarisation::s;
    all.push_back({s_only, {}});
    Mechanism tilted = morpho();
    tilted.effects.relief.tilt_deg = 5.0;
    all.push_back({tilted, set_of({Effect::tilt})});
    Mechanism rough = morpho();
    rough.effects.relief.roughness = 0.3;
    all.push_back({rough, set_of({Effect::roughness})});
    Grating first = disc();
    first.orders = {1};
    all.push_back({first, {}});
    all.push_back({film_on(1.5, 300.0, flint()), set_of({pol, Effect::dispersion})});
    all.push_back({film_on(flint()), set_of({pol, Effect::dispersion})});
    all.push_back({film_on(1.5, 300.0, RefractiveIndex(1.8, 0.1)), set_of({pol, Effect::absorption})});
    all.push_back({film_on(RefractiveIndex(0.4, 2.5)), set_of({pol})});  // no layer, but a mirror
    all.push_back({film_on(1.5, 50000.0), set_of({pol})});               // whose fringes are blurred
    Film spread = film_on(1.5);
    spread.thickness_spread_nm = 10.0;
    all.push_back({spread, set_of({pol, Effect::thickness_spread})});
    all.push_back(
        {stack_of({layer_of(1.5, 1e6, true), layer_of(2.3, 60.0)}), set_of({pol, Effect::incoherent_layers})});
    all.push_back({with_base(film_on(1.5), GreyBase{0.5}), set_of({pol, Effect::base})});
    all.push_back({with_base(film_on(1.5), MetalBase{RefractiveIndex(0.4, 2.5)}), set_of({pol, Effect::base})});
    all.push_back({with_base(film_on(1.5), MetalBase{flint()}), set_of({pol, Effect::base, Effect::dispersion})});
    Crystal dark = opal();
    dark.sphere = RefractiveIndex(1.45, 0.01);
    all.push_back({dark, set_of({pol, Effect::absorption})});
    Crystal coloured = opal();
    coloured.sphere = flint();
    all.push_back({coloured, set_of({pol, Effect::dispersion})});
    Scatter sizes = mist();
    sizes.radius_spread = 0.1;
    sizes.particle = RefractiveIndex(1.5, 0.01);
    all.push_back({sizes, set_of({pol, Effect::size_spread, Effect::absorption})});
    return all;
}

TEST(EffectWork, IsNothingOfWhatIsAbsentAndSomethingOfWhatIsThere) {
    for (const Counted& one : counted()) {
        EXPECT_EQ(names_of(effects_in(one.mechanism, 360.0)), names_of(one.effects)) << mechanism_name(one.mechanism);
        EffectWorks works = works_of(one.mechanism);
        for (const EffectRow& row : effect_rows()) {
            EXPECT_EQ(is_counted(work_of(works, row.effect)), one.effects.has(row.effect))
                << mechanism_name(one.mechanism) << " with " << names_of(one.effects) << ": " << row.name;
        }
    }
}

TEST(EffectWork, IsNothingOfWhatIsLeftOut) {
    for (const Counted& one : counted()) {
        for (const EffectRow& row : effect_rows()) {
            if (!one.effects.has(row.effect)) continue;
            Mechanism less = one.mechanism;
            EffectSet removed;
            removed.insert(row.effect);
            remove(removed, less, 360.0);
            EXPECT_FALSE(row.is_in(less, 360.0)) << row.name;
            EffectWorks works = works_of(less);
            EXPECT_FALSE(is_counted(work_of(works, row.effect))) << mechanism_name(less) << " without " << row.name;
        }
    }
}

// A film whose fringes nobody sees is computed as an incoherent layer, which is no effect of the scene's.
TEST(EffectWork, OfABlurredFilmIsNoneOfIncoherentLayers) {
    Job job = job_of(film_on(1.5, 50000.0), 9);
    job.sampling = default_sampling(job);
    ASSERT_FALSE(job.sampling.incoherent_layers.empty());
    Work work;
    bake(job, {}, &work);
    EXPECT_FALSE(is_counted(work_of(work.effects, Effect::incoherent_layers)));
}

// A window so dark that nothing comes back from below it, and a film below whose fringes nobody sees: when the window's
// underside is left out, so is that film.
TEST(Effects, LeftOutMayTakeABlurredLayerAlong) {
    Job job = job_of(stack_of({layer_of(RefractiveIndex(1.5, 1e-3), 1e6, true), layer_of(1.6, 60000.0)}), 9);
    SamplingTolerance tolerance;
    tolerance.effects = 0.1;
    const ChosenSampling chosen = choose_sampling(job, tolerance);
    ASSERT_TRUE(chosen.without.has(Effect::incoherent_layers));
    ASSERT_EQ(chosen.sampling.incoherent_layers, std::vector<std::size_t>{1});
    job.sampling = chosen.sampling;
    job.without = chosen.without;
    Work work;
    // A face of glass of a little k, for all that is seen: 4 % at the normal.
    EXPECT_NEAR(bake(job, {}, &work).at(job.width - 1, 0).y, 0.04, 1e-4);
    EXPECT_FALSE(is_counted(work_of(work.effects, Effect::incoherent_layers)));
}

}  // namespace
}  // namespace nacre
