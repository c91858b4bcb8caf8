// The colour of one material at one angle, against the reference model and against dense sums over wavelengths; and
// what it costs.
#include "nacre/accuracy/exact_colour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <ctime>
#include <numbers>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/lut/axis.h"
#include "nacre/shade/spectral_sampling.h"
#include "reference/colour.h"
#include "reference/light.h"
#include "reference/materials.h"
#include "reference/model.h"
#include "reference/random_scenes.h"

namespace nacre::test {
namespace {

using reference::Model;
using reference::ModelLight;
using reference::ModelScene;
using reference::ModelXyz;

Light light_of_scene(const ModelScene& scene) {
    LightSettings settings;
    settings.illuminant = scene.illuminant;
    settings.power = *illuminant_by_name(scene.illuminant);
    settings.observer = scene.observer_deg == 10 ? Observer::cie1964_10deg : Observer::cie1931_2deg;
    return make_light(settings);
}

// What a sum of a hundred wavelengths per nanometre gives, each reflectance by the reference model.
ModelXyz dense_colour(const Mechanism& mechanism, double angle_deg) {
    const ModelLight& light = ModelLight::of("D65", 2);
    const double cos_theta = std::cos(angle_deg * std::numbers::pi / 180.0);
    constexpr int per_nm = 100;
    reference::Triple sum{};
    for (int i = 0; i < (reference::light_ends_nm - reference::light_begins_nm) * per_nm; ++i) {
        const double nm = reference::light_begins_nm + (i + 0.5) / per_nm;
        const double share = reference::reflectance(mechanism, cos_theta, nm) / per_nm;
        const reference::Triple weight = light.weight_at(nm);
        for (std::size_t j = 0; j < 3; ++j) sum[j] += share * weight[j];
    }
    return light.adapted(sum);
}

double difference_to(const ModelXyz& meant, const Mechanism& mechanism, const Geometry& geometry, const Light& light) {
    const Xyz seen = adapt(light.adaptation, reflectance_xyz(mechanism, geometry, light));
    return reference::difference({seen.x, seen.y, seen.z}, meant, reference::scale_of_brightest(meant.y));
}

// A gap below a prism: beyond the critical angle a wave is caught in it, and the spectrum has a dip of a few
// nanometres that a sum of 24 wavelengths misses by CIEDE2000 1.8.
TEST(ExactColours, SeeTheWaveThatIsCaughtInAGap) {
    const Light light = light_of_scene({});
    Film gap;
    gap.incident = 1.33;
    gap.index = 1.0;
    gap.substrate = reference::tabulated_index("ag");
    for (const double thickness_nm : {200.0, 400.0, 800.0, 1200.0}) {
        gap.thickness_nm = thickness_nm;
        for (const double angle_deg : {48.0, 49.5, 51.0, 54.494, 60.0, 75.0}) {
            EXPECT_LT(difference_to(dense_colour(gap, angle_deg), gap, Incidence::from_degrees(angle_deg), light), 1e-3)
                << thickness_nm << " nm at " << angle_deg;
        }
    }
}

TEST(ExactColours, AreThoseOfADenseSumForFilmsOfEveryThickness) {
    const Light light = light_of_scene({});
    Film film;
    film.index = 1.33;
    film.substrate = 1.0;
    for (const double thickness_nm : {1.0, 90.0, 900.0, 20e3}) {
        film.thickness_nm = thickness_nm;
        for (const double angle_deg : {0.0, 60.0, 85.0}) {
            EXPECT_LT(difference_to(dense_colour(film, angle_deg), film, Incidence::from_degrees(angle_deg), light),
                      1e-3)
                << thickness_nm << " nm at " << angle_deg;
        }
    }
}

// Uneven layers are a mean over samples in one and an integral in the other: there the promise is 0.1.
TEST(ExactColours, AreThoseOfTheReferenceModelForRandomEffects) {
    const std::vector<ModelScene> scenes = reference::random_effects();
    for (std::size_t i = 10; i < scenes.size(); i += 29) {
        const ModelScene& scene = scenes[i];
        const Light light = light_of_scene(scene);
        const Model model(scene, 1e-4);
        const double promise = is_layered(scene.mechanism) && is_irregular(scene.mechanism) ? 0.1 : 2e-3;
        for (const double x : {0.62, 0.9}) {
            const Geometry geometry = default_axis(quantity_of(scene.mechanism)).kind->geometry(x);
            EXPECT_LT(difference_to(model.at(x), scene.mechanism, geometry, light), promise)
                << scene.name << ", " << mechanism_name(scene.mechanism) << ", tilt "
                << scene.mechanism.effects.relief.tilt_deg << ", at " << x;
        }
    }
}

// CPU time, so that other programs do not count. The bound is that of the promise, not of what is reached: a film of
// water takes a hundredth of it.
TEST(ExactColours, OfAFilmCostAtMostTwentyMillisecondsEach) {
    const Light light = light_of_scene({});
    constexpr int count = 256;
    Film film;
    film.index = 1.33;
    film.substrate = 1.0;
    const std::clock_t begin = std::clock();
    ExactColours colours(light);
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        film.thickness_nm = 900.0 + i;
        sum += colours.at(film, Incidence::from_degrees(30.0)).y;
    }
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_GT(sum, 0.0);
    EXPECT_LT(seconds, 0.02 * count);
}

}  // namespace
}  // namespace nacre::test
