// The reference model of films and stacks is judged before it judges, by closed forms of textbooks.
#include "reference/dense_layers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace nacre::reference {
namespace {

// Born & Wolf, Principles of Optics, 7th ed., 1.6.4: a quarter wave of index sqrt(n0 n2) reflects nothing, a half wave
// is as if it were not there; N periods of quarter waves have admittance n2 (nH / nL)^(2N).
TEST(DenseLayers, QuarterAndHalfWavesDoWhatTheTextbookSays) {
    const double wavelength_nm = 550.0;
    const auto stack = [](double substrate) {
        LayersModel model;
        model.substrate = {"", substrate};
        return model;
    };
    const auto add = [](LayersModel& model, double n, double thickness_nm) {
        model.layers.push_back({{"", n}, thickness_nm});
        return model.layers.size() - 1;
    };
    LayersModel quarter = stack(1.52);
    quarter.groups = {{1, false, {add(quarter, std::sqrt(1.52), wavelength_nm / (4.0 * std::sqrt(1.52)))}}};
    EXPECT_NEAR(DenseLayers(quarter).reflectance(1.0, wavelength_nm), 0.0, 1e-15);

    LayersModel half = stack(1.52);
    half.groups = {{1, false, {add(half, 2.3, wavelength_nm / (2.0 * 2.3))}}};
    EXPECT_NEAR(DenseLayers(half).reflectance(1.0, wavelength_nm), std::pow(0.52 / 2.52, 2.0), 1e-14);

    LayersModel mirror = stack(1.52);
    const std::size_t high = add(mirror, 2.3, wavelength_nm / (4.0 * 2.3));
    const std::size_t low = add(mirror, 1.38, wavelength_nm / (4.0 * 1.38));
    mirror.groups = {{4, true, {high, low}}};
    const double admittance = 1.52 * std::pow(2.3 / 1.38, 8.0);
    const double expected = std::pow((1.0 - admittance) / (1.0 + admittance), 2.0);
    EXPECT_NEAR(DenseLayers(mirror).reflectance(1.0, wavelength_nm), expected, 1e-13);
}

// Light totally reflected at a prism's base leaks through a gap (Born & Wolf 1.5.4): nothing of a wide one, all of
// none.
TEST(DenseLayers, AGapBetweenPrismsReflectsAllWhenWideAndNothingWhenClosed) {
    LayersModel model;
    model.incident = model.substrate = {"", 1.5};
    model.layers = {{{"", 1.0}, 5000.0}};
    model.groups = {{1, false, {0}}};
    const double cos_theta = std::cos(std::numbers::pi / 3.0);
    EXPECT_NEAR(DenseLayers(model).reflectance(cos_theta, 500.0), 1.0, 1e-14);
    model.layers[0].thickness_nm = 0.0;
    EXPECT_NEAR(DenseLayers(model).reflectance(cos_theta, 500.0), 0.0, 1e-15);
}

// Brewster's angle: half of what s reflects is all that is left. A metal at normal incidence: ((n-1)^2 + k^2) /
// ((n+1)^2 + k^2).
TEST(DenseLayers, BareFacesFollowFresnel) {
    LayersModel glass;
    glass.substrate = {"", 1.5};
    glass.layers = {{{"", 1.5}, 100.0}};
    glass.groups = {{1, false, {0}}};
    const double brewster = 1.0 / std::sqrt(1.0 + 1.5 * 1.5);  // its cosine
    const double s = std::pow((1.5 * 1.5 - 1.0) / (1.5 * 1.5 + 1.0), 2.0);
    EXPECT_NEAR(DenseLayers(glass).reflectance(brewster, 600.0), 0.5 * s, 1e-15);

    LayersModel metal = glass;
    metal.substrate = {"ag", {}};
    metal.layers[0] = {{"", 1.0}, 100.0};
    const std::complex<double> n = material_index("ag", 600.0);
    EXPECT_NEAR(DenseLayers(metal).reflectance(1.0, 600.0), std::norm((n - 1.0) / (n + 1.0)), 1e-14);
}

}  // namespace
}  // namespace nacre::reference
