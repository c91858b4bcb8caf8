#include "nacre/accuracy/reference.h"
#include "nacre/accuracy/exact_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "nacre/accuracy/confirmed_layers.h"
#include "nacre/optics/irregular.h"
#include "nacre/scene/readers/axis_reader.h"
#include "reference/lobe_quadrature.h"
#include "reference/materials.h"
#include "reference/model.h"
#include "reference/random_scenes.h"
#include "reference/weights.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

Palette same_at_every_angle(const Lobe& lobe) {
    return {{{0.0, lobe}}};
}

void expect_near(const Xyz& one, const Xyz& other, double tolerance, const Lobe& lobe, const std::string& light) {
    const auto where = [&] {
        return light + ", peak " + std::to_string(lobe.peak_nm) + ", width " + std::to_string(lobe.width_nm);
    };
    EXPECT_NEAR(one.x, other.x, tolerance) << where();
    EXPECT_NEAR(one.y, other.y, tolerance) << where();
    EXPECT_NEAR(one.z, other.z, tolerance) << where();
}

/// Every kind of light that a scene can ask for.
std::vector<LightSettings> many_settings() {
    std::vector<LightSettings> all;
    for (const char* illuminant : {"D65", "A", "FL11"}) {
        LightSettings settings;
        settings.illuminant = illuminant;
        all.push_back(settings);
        settings.observer = Observer::cie1964_10deg;
        settings.adaptation = Adaptation::cat16;
        settings.first_nm = 380;
        settings.last_nm = 780;
        all.push_back(settings);
        settings.adaptation = Adaptation::none;
        all.push_back(settings);
    }
    return all;
}

void expect_the_closed_form(const std::vector<double>& widths_nm, double tolerance) {
    reference::Uniform uniform(5);
    for (const LightSettings& settings : many_settings()) {
        const auto light = test::light_of(settings);
        for (const double width_nm : widths_nm) {
            for (int i = 0; i < 6; ++i) {
                // Some on whole nanometres, some cut by an end of the range, some beyond it.
                const double any_nm = uniform.between(350.0 - 0.5 * width_nm, 840.0 + 0.5 * width_nm);
                const Lobe lobe{i == 0 ? std::floor(any_nm) : any_nm, width_nm, 0.8};
                Job job = test::job_of(same_at_every_angle(lobe));
                job.light = light;
                expect_near(Reference(job).at(0.3), exact_xyz(job, 0.3), tolerance, lobe, settings.illuminant);
            }
        }
    }
}

TEST(Reference, OfBandsOf4NanometresAndMoreIsTheClosedFormTo1em9) {
    expect_the_closed_form({4.0, 4.7, 8.0, 30.0, 70.0, 333.3, 940.0, 5000.0}, 1e-9);
}

TEST(Reference, OfNarrowerBandsIsTheClosedFormTo1em7) {
    expect_the_closed_form({1e-3, 0.3, 1.0, 1.7, 2.0, 3.999}, 1e-7);
}

TEST(Reference, AgreesWithQuadratureIn50Digits) {
    LightSettings settings;
    settings.illuminant = "FL11";
    settings.adaptation = Adaptation::none;
    const auto light = test::light_of(settings);
    const reference::Weights weights = reference::weights_from_files("cmf_cie1931_2deg_1nm.csv", "FL11", 360, 830);
    for (const Lobe& lobe : {Lobe{460.25, 41.5, 0.9}, Lobe{611.0, 2.5, 0.7}}) {
        Job job = test::job_of(same_at_every_angle(lobe));
        job.light = light;
        const Xyz colour = Reference(job).at(1.0);
        const reference::XyzNumbers exact =
            reference::reference_lobe_to_xyz(weights, lobe.peak_nm, lobe.width_nm, lobe.height);
        const double tolerance = lobe.width_nm >= 4.0 ? 1e-9 : 1e-7;
        EXPECT_LT(reference::distance(colour.x, exact.x), tolerance);
        EXPECT_LT(reference::distance(colour.y, exact.y), tolerance);
        EXPECT_LT(reference::distance(colour.z, exact.z), tolerance);
        EXPECT_GT(colour.y, 1e-3);
    }
}

TEST(Reference, FollowsTheMaterialOverBothAxes) {
    const std::vector<Job> jobs{
        test::job_of(test::morpho),
        test::job_of(test::opal, parameter_axis(test::opal, "shape", 0.0, 1.0), 8, 8),
        test::job_of(test::beetle, parameter_axis(test::beetle, "picks[0].width_nm", 5.0, 200.0), 8, 8),
        test::job_over(test::morpho, parameter_axis(test::morpho, "peak_nm", 400.0, 700.0), 25.0),
    };
    reference::Uniform uniform(6);
    for (const Job& job : jobs) {
        const Reference reference(job);
        for (int i = 0; i < 50; ++i) {
            const double x = uniform.between(0.0, 1.0);
            const double y = uniform.between(0.0, 1.0);
            expect_near(reference.at(x, y), exact_xyz(job, x, y), 1e-9, {}, job.x.parameter.name);
        }
        expect_near(reference.at(1.0, 1.0), exact_xyz(job, 1.0, 1.0), 1e-9, {}, "the last corner");
    }
}

TEST(Reference, KnowsNoNodes) {
    Job sampled = test::job_of(test::morpho);
    sampled.light = test::light_of("D65", 12);
    const Job exact = test::job_of(test::morpho);
    for (const double x : {0.85, 0.95, 1.0}) {
        EXPECT_EQ(Reference(sampled).at(x), Reference(exact).at(x));
        EXPECT_GT(std::abs(exact_xyz(sampled, x).z - exact_xyz(exact, x).z), 1e-3) << "as if 12 nodes were enough";
    }
}

TEST(Reference, OfABandWithoutWidthOrHeightOrLightIsBlack) {
    for (const Lobe& lobe :
         {Lobe{500.0, 0.0, 1.0}, Lobe{500.0, 70.0, 0.0}, Lobe{200.0, 300.0, 1.0}, Lobe{900.0, 140.0, 1.0}}) {
        const Job job = test::job_of(same_at_every_angle(lobe));
        EXPECT_EQ(Reference(job).at(0.5), Xyz{}) << lobe.peak_nm;
    }
}

constexpr double tolerance_de00 = 1e-3;

Job job_of(const reference::ModelScene& scene) {
    LightSettings settings;
    settings.illuminant = scene.illuminant;
    settings.observer = scene.observer_deg == 10 ? Observer::cie1964_10deg : Observer::cie1931_2deg;
    Job job;
    job.material = {scene.name, scene.mechanism, {}};
    job.light = test::light_of(settings);
    job.x = default_axis(quantity_of(scene.mechanism));
    return job;
}

// Colours along x differ from the model's by no more than is promised, at the scale of the brightest.
void expect_the_model(reference::ModelScene scene) {
    scene.x = reference::ModelAxis::of_mechanism;
    scene.y.reset();
    const Job job = job_of(scene);
    const Reference reference(job, tolerance_de00);
    const reference::Model model(scene, 0.05 * tolerance_de00);
    std::vector<Xyz> seen;
    std::vector<Xyz> meant;
    double brightest = 0.0;
    for (const double x : {0.0, 0.11, 0.37, 0.64, 0.92, 1.0}) {
        const reference::ModelXyz colour = model.at(x);
        meant.push_back({colour.x, colour.y, colour.z});
        seen.push_back(reference.at(x));
        brightest = std::max(brightest, colour.y);
    }
    for (std::size_t i = 0; i < seen.size(); ++i)
        EXPECT_LE(difference_at(seen[i], meant[i], display_scale(brightest)), 2.0 * tolerance_de00)
            << scene.name << ", point " << i;
}

TEST(Reference, OfRandomLayersIsTheModelsToTwiceTheTolerance) {
    const std::vector<reference::ModelScene> scenes = reference::random_layers();
    for (std::size_t i = 0; i < scenes.size(); i += 4) {
        reference::ModelScene scene = scenes[i];
        for_each_index(scene.mechanism, [](Index& index, IndexRole) {
            if (index.curve) index = reference::tabulated_index(index.curve->name);
        });
        expect_the_model(scene);
        if (i % 8 == 0) expect_the_model(*reference::seen_through(scene));
    }
}

// Of crystals, uneven layers and bases that are tables the model itself errs by as much.
TEST(Reference, OfRandomEffectsIsTheModelsToTwiceTheTolerance) {
    int count = 0;
    const std::vector<reference::ModelScene> scenes = reference::random_effects();
    for (std::size_t i = 0; i < scenes.size(); i += 10) {
        const Mechanism& mechanism = scenes[i].mechanism;
        const auto& base = mechanism.effects.base;
        if (std::holds_alternative<Crystal>(mechanism) || thickness_spread_nm(mechanism) > 0.0 ||
            (base && std::holds_alternative<SpectrumBase>(*base)))
            continue;
        expect_the_model(scenes[i]);
        ++count;
    }
    EXPECT_GE(count, 10);
}

TEST(Reference, OfAGratingIsTheClosedFormWhetherItsLinesAreFewOrMany) {
    for (const int grooves : {1, 40, 20000}) {
        Grating grating;
        grating.grooves = grooves;
        grating.depth_nm = 175.0;
        Job job = test::job_of(test::morpho);
        job.material = {"grating", {grating}, {}};
        job.x = default_axis(Quantity::grating_u);
        for (const double x : {0.0, 0.21, 0.5, 0.77, 1.0}) {
            const Xyz meant = exact_xyz(job, x);
            EXPECT_LE(difference_at(Reference(job, tolerance_de00).at(x), meant, display_scale(meant.y)),
                      2.0 * tolerance_de00)
                << grooves << " grooves at " << x;
        }
    }
}

TEST(Reference, ErrsByLessIfItIsAskedTo) {
    Film film;
    film.index = Index(1.5);
    film.thickness_nm = 20000.0;
    Job job = test::job_of(test::morpho);
    job.material = {"film", {film}, {}};
    for (const double x : {0.3, 1.0}) {
        const Xyz meant = Reference(job, 1e-7).at(x);
        double last = 1.0;
        for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
            const double error = difference_at(Reference(job, tolerance).at(x), meant, display_scale(meant.y));
            EXPECT_LE(error, tolerance) << x;
            EXPECT_LE(error, last) << x;
            last = error;
        }
    }
}

TEST(ConfirmedLayers, AreTheMeanOfTheScalarSolver) {
    Stack stack;
    for (const auto& [n, thickness_nm] : {std::pair<RefractiveIndex, double>{2.3, 70.0}, {{1.5, 0.02}, 130.0}}) {
        Layer layer;
        layer.index = n;
        layer.thickness_nm = thickness_nm;
        stack.layers.push_back(layer);
    }
    const LayerEnsemble ensemble = irregular_systems(layer_system(stack), 5.0, 16);
    ConfirmedLayers layers(ensemble);
    for (const std::vector<double>& nm : {std::vector<double>{400.0, 551.0, 700.0}, {622.0}}) {
        const Incidence incidence = Incidence::from_degrees(50.0);
        const std::vector<Response> seen = layers.at(incidence, nm);
        ASSERT_EQ(seen.size(), nm.size());
        for (std::size_t i = 0; i < nm.size(); ++i) {
            Response mean;
            for (std::size_t k = 0; k < ensemble.systems.size(); ++k)
                add(mean, ensemble.shares[k], multilayer_response(ensemble.systems[k], incidence, nm[i]));
            EXPECT_NEAR(seen[i].reflectance_s, mean.reflectance_s, 1e-12);
            EXPECT_NEAR(seen[i].transmittance_p, mean.transmittance_p, 1e-12);
        }
    }
}

}  // namespace
}  // namespace nacre
