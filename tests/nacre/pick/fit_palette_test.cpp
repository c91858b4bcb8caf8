#include "nacre/pick/fit_palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/ceres_solver.h"
#include "nacre/colour/illuminant.h"
#include "nacre/optics/incidence.h"
#include "reference/number.h"

// The fit needs a solver, and that is a library's: hence here.
namespace nacre {
namespace {

Light daylight() {
    LightSettings settings;
    settings.power = *illuminant_by_name(settings.illuminant);
    return make_light(settings);
}

// A palette as a spectrometer would see it, every nanometre: cosine lobes.
MeasuredSpectra spectra_of(const Palette& palette, const std::vector<double>& angles_deg) {
    MeasuredSpectra spectra;
    spectra.angle_deg = angles_deg;
    for (int nm = 340; nm <= 850; ++nm) spectra.wavelength_nm.push_back(nm);
    for (const double angle_deg : angles_deg) {
        const Lobe lobe = palette_lobe(palette, Incidence::from_degrees(angle_deg));
        for (const double nm : spectra.wavelength_nm) {
            const double along = (nm - lobe.peak_nm) / lobe.width_nm;
            spectra.reflectance.push_back(std::abs(along) < 0.5 ? lobe.height * std::cos(std::numbers::pi * along)
                                                                : 0.0);
        }
    }
    return spectra;
}

const std::vector<double> eight_angles{0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0};

Palette random_palette(reference::Uniform& random) {
    Palette palette;
    palette.picks = {{0.0, {random.between(540.0, 640.0), random.between(60.0, 200.0), random.between(0.4, 0.95)}},
                     {70.0, {random.between(420.0, 500.0), random.between(60.0, 200.0), random.between(0.4, 0.95)}}};
    palette.shape = random.between(0.1, 0.9);
    return palette;
}

TEST(FittedPalette, ComesBackFromItsOwnSpectra) {
    const Light light = daylight();
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        reference::Uniform random(seed);
        const Palette palette = random_palette(random);
        const PaletteFit fit = fit_palette(spectra_of(palette, eight_angles), 2, light, least_squares_solver());
        EXPECT_LT(fit.error, 0.05) << seed;
        EXPECT_NEAR(fit.palette.shape, palette.shape, 0.01) << seed;
        ASSERT_EQ(fit.palette.picks.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i) {
            const Pick& fitted = fit.palette.picks[i];
            const Pick& truth = palette.picks[i];
            EXPECT_EQ(fitted.angle_deg, truth.angle_deg) << seed;
            EXPECT_NEAR(fitted.lobe.peak_nm, truth.lobe.peak_nm, 0.1) << seed;
            EXPECT_NEAR(fitted.lobe.width_nm, truth.lobe.width_nm, 1.0) << seed;
            EXPECT_NEAR(fitted.lobe.height, truth.lobe.height, 0.01) << seed;
        }
        ASSERT_EQ(fit.angles.size(), eight_angles.size());
        double sum = 0.0;
        for (std::size_t i = 0; i < fit.angles.size(); ++i) {
            const AngleFit& angle = fit.angles[i];
            const Lobe truth = palette_lobe(palette, Incidence::from_degrees(eight_angles[i]));
            EXPECT_EQ(angle.angle_deg, eight_angles[i]);
            EXPECT_NEAR(angle.peak_nm, truth.peak_nm, 0.1) << seed << " at " << angle.angle_deg;
            EXPECT_NEAR(angle.measured_peak_nm, truth.peak_nm, 0.01) << seed << " at " << angle.angle_deg;
            sum += angle.de00 * angle.de00;
        }
        EXPECT_NEAR(fit.error, std::sqrt(sum / 8.0), 1e-12);
    }
}

TEST(FittedPalette, HasAsManyPicksAsAskedFor) {
    const Light light = daylight();
    reference::Uniform random(7);
    const MeasuredSpectra spectra = spectra_of(random_palette(random), eight_angles);
    double before = 1e9;
    for (const std::size_t picks : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{8}}) {
        const PaletteFit fit = fit_palette(spectra, picks, light, least_squares_solver());
        ASSERT_EQ(fit.palette.picks.size(), picks);
        for (const Pick& pick : fit.palette.picks) {
            EXPECT_NE(std::find(eight_angles.begin(), eight_angles.end(), pick.angle_deg), eight_angles.end());
            EXPECT_GE(pick.lobe.height, 0.0);
            EXPECT_LE(pick.lobe.height, 1.0);
        }
        EXPECT_LT(fit.error, before + 0.05) << picks;
        before = fit.error;
        if (picks == 8) {
            EXPECT_EQ(fit.palette.shape, Palette::default_shape);
        }
    }
    EXPECT_LT(before, 0.05);
}

TEST(FittedPalette, OfOneAngleIsItsColour) {
    const Palette palette{{{20.0, {560.0, 120.0, 0.8}}}};
    const PaletteFit fit = fit_palette(spectra_of(palette, {20.0}), 1, daylight(), least_squares_solver());
    ASSERT_EQ(fit.palette.picks.size(), 1u);
    EXPECT_EQ(fit.palette.picks[0].angle_deg, 20.0);
    EXPECT_NEAR(fit.palette.picks[0].lobe.peak_nm, 560.0, 0.1);
    EXPECT_LT(fit.error, 0.05);
}

TEST(FittedPalette, OfBlackAndOfWhiteIsFinite) {
    const Light light = daylight();
    for (const double level : {0.0, 1.0, 0.18}) {
        MeasuredSpectra spectra = spectra_of(Palette{{{0.0, {500.0, 100.0, 0.5}}}}, eight_angles);
        std::fill(spectra.reflectance.begin(), spectra.reflectance.end(), level);
        const PaletteFit fit = fit_palette(spectra, 2, light, least_squares_solver());
        EXPECT_TRUE(std::isfinite(fit.error)) << level;
        for (const Pick& pick : fit.palette.picks) {
            EXPECT_TRUE(std::isfinite(pick.lobe.peak_nm) && std::isfinite(pick.lobe.width_nm)) << level;
            EXPECT_TRUE(std::isfinite(pick.lobe.height)) << level;
        }
        if (level == 0.0) {
            EXPECT_LT(fit.error, 0.05);
        }
    }
}

}  // namespace
}  // namespace nacre
