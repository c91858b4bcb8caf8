// The reference model of films and stacks is judged before it judges, by closed forms of textbooks.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "reference/materials.h"
#include "reference/model.h"

namespace nacre::reference {
namespace {

Layer layer_of(const Index& index, double thickness_nm) {
    Layer layer;
    layer.index = index;
    layer.thickness_nm = thickness_nm;
    return layer;
}

// Born & Wolf, Principles of Optics, 7th ed., 1.6.4: a quarter wave of index sqrt(n0 n2) reflects nothing, a half wave
// is as if it were not there; N periods of quarter waves have admittance n2 (nH / nL)^(2N).
TEST(ReferenceLayers, QuarterAndHalfWavesDoWhatTheTextbookSays) {
    const double wavelength_nm = 550.0;
    const Film quarter{1.0, std::sqrt(1.52), wavelength_nm / (4.0 * std::sqrt(1.52)), 1.52, 0.0};
    EXPECT_NEAR(reflectance(quarter, 1.0, wavelength_nm), 0.0, 1e-15);

    const Film half{1.0, 2.3, wavelength_nm / (2.0 * 2.3), 1.52, 0.0};
    EXPECT_NEAR(reflectance(half, 1.0, wavelength_nm), std::pow(0.52 / 2.52, 2.0), 1e-14);

    Layer pairs;
    pairs.repeat = 4;
    pairs.layers = {layer_of(2.3, wavelength_nm / (4.0 * 2.3)), layer_of(1.38, wavelength_nm / (4.0 * 1.38))};
    const Stack mirror{1.0, {pairs}, 1.52, 0.0};
    const double admittance = 1.52 * std::pow(2.3 / 1.38, 8.0);
    const double expected = std::pow((1.0 - admittance) / (1.0 + admittance), 2.0);
    EXPECT_NEAR(reflectance(mirror, 1.0, wavelength_nm), expected, 1e-13);
}

// Light totally reflected at a prism's base leaks through a gap (Born & Wolf 1.5.4): nothing of a wide one, all of
// none.
TEST(ReferenceLayers, AGapBetweenPrismsReflectsAllWhenWideAndNothingWhenClosed) {
    Film gap{1.5, 1.0, 5000.0, 1.5, 0.0};
    const double cos_theta = std::cos(std::numbers::pi / 3.0);
    EXPECT_NEAR(reflectance(gap, cos_theta, 500.0), 1.0, 1e-14);
    gap.thickness_nm = 0.0;
    EXPECT_NEAR(reflectance(gap, cos_theta, 500.0), 0.0, 1e-15);
}

// Brewster's angle: half of what s reflects is all that is left. A metal at normal incidence: ((n-1)^2 + k^2) /
// ((n+1)^2 + k^2).
TEST(ReferenceLayers, BareFacesFollowFresnel) {
    const Film glass{1.0, 1.5, 100.0, 1.5, 0.0};
    const double brewster = 1.0 / std::sqrt(1.0 + 1.5 * 1.5);  // its cosine
    const double s = std::pow((1.5 * 1.5 - 1.0) / (1.5 * 1.5 + 1.0), 2.0);
    EXPECT_NEAR(reflectance(glass, brewster, 600.0), 0.5 * s, 1e-15);

    const Film metal{1.0, 1.0, 100.0, named_index("ag"), 0.0};
    const std::complex<double> n = material_index("ag", 600.0);
    EXPECT_NEAR(reflectance(metal, 1.0, 600.0), std::norm((n - 1.0) / (n + 1.0)), 1e-14);
}

}  // namespace
}  // namespace nacre::reference
