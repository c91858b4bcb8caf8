// The judge of resonances is judged by the model that it shares only its layers with: even wavelengths, one point at a
// time.
#include "reference/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/dice.h"
#include "reference/materials.h"
#include "reference/model.h"
#include "reference/random_scenes.h"

namespace nacre::reference {
namespace {

Film air_gap(double n, double thickness_nm) {
    Film film;
    film.incident = n;
    film.index = 1.0;
    film.thickness_nm = thickness_nm;
    film.substrate = named_index("ag");
    return film;
}

// Two mirrors of quarter waves around half a wave: a line that is a hundredth of a nanometre wide.
Stack etalon() {
    const auto layer = [](double n, double thickness_nm) {
        Layer made;
        made.index = n;
        made.thickness_nm = thickness_nm;
        return made;
    };
    const auto mirror = [&](double first, double second) {
        Layer group;
        group.repeat = 10;
        group.layers = {layer(first, 550.0 / 4.0 / first), layer(second, 550.0 / 4.0 / second)};
        return group;
    };
    return {1.0, {mirror(2.3, 1.45), layer(2.3, 550.0 / 2.0 / 2.3), mirror(1.45, 2.3)}, 1.0, 0.0};
}

TEST(ModelCurve, IsTheModelBetweenItsPoints) {
    Dice dice(19);
    ModelScene scene;
    scene.x = ModelAxis::sqrt_cos_theta;
    for (const double thickness_nm : {150.0, 800.0}) {
        scene.mechanism = air_gap(1.5, thickness_nm);
        const ModelCurve curve = curve_of_layers(scene);
        const Model model(scene, 1e-6, 1.0);
        for (int i = 0; i < 40; ++i) {
            const double x = dice.unit();
            EXPECT_LE(difference(curve.at(x), model.at(x), 1.0), 2e-5) << x;
        }
    }
}

TEST(ModelCurve, FollowsTheRootWhereTotalReflectionBegins) {
    ModelScene scene;
    scene.x = ModelAxis::cos_theta;
    scene.mechanism = air_gap(1.5, 600.0);
    const ModelCurve curve = curve_of_layers(scene);
    const Model model(scene, 1e-6, 1.0);
    const double critical = std::sqrt(1.0 - 1.0 / 2.25);
    for (const double off : {1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
        for (const double x : {critical - off, critical + off})
            EXPECT_LE(difference(curve.at(x), model.at(x), 1.0), 5e-5) << off;
    }
}

TEST(ModelCurve, BlursByFacetsAsTheModelDoes) {
    ModelScene scene;
    scene.x = ModelAxis::sqrt_cos_theta;
    Film film;
    film.incident = 1.0;
    film.index = 1.5;
    film.thickness_nm = 300.0;
    film.substrate = 1.8;
    scene.mechanism = film;
    scene.mechanism.effects.relief.tilt_deg = 6.0;
    const ModelCurve curve = curve_of_layers(scene);
    const Model model(scene, 1e-5, 1.0);
    for (const double x : {0.05, 0.3, 0.55, 0.8, 0.99}) EXPECT_LE(difference(curve.at(x), model.at(x), 1.0), 1e-3) << x;
}

TEST(ResolvedColour, SeesALineThatIsNarrowerThanAnyStep) {
    ModelScene scene;
    scene.mechanism = etalon();
    const Model model(scene, 1e-7, 1.0);
    for (const double x : {1.0, 0.9, 0.6}) {
        const ModelXyz closely = model.resolved(x, 0.0, 1e-9);
        EXPECT_LE(difference(model.resolved(x, 0.0, 3e-6), closely, 1.0), 1e-4) << x;
        EXPECT_LE(difference(model.at(x), closely, 1.0), 1e-3) << x;
    }
}

TEST(WorstOf, FindsTheDenseMaximum) {
    ModelScene scene;
    scene.x = ModelAxis::sqrt_cos_theta;
    scene.mechanism = air_gap(1.4, 300.0);
    const ModelCurve curve = curve_of_layers(scene);
    const ColourAt colours = [&](double x, double) { return curve.at(x); };
    const Pixels lut = make_lut(colours, 96, 1, StoredAs::half_float);
    const double dense = dense_error(lut, colours, {1000, 1000000, 1e9});
    EXPECT_NEAR(worst_of(lut, curve).error, dense, 1e-3 * dense);
}

}  // namespace
}  // namespace nacre::reference
