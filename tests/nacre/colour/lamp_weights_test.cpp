// Lamps whose lines are narrower than a nanometre.
#include "nacre/colour/lamp_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "nacre/accuracy/reference.h"
#include "nacre/colour/light.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/shade/grating_pieces.h"
#include "nacre/shade/measured_colour.h"
#include "support/mercury_lamp.h"
#include "support/palette_luts.h"

namespace nacre {
namespace {

using test::mercury_lamp;
using Curve = std::function<double(double nm)>;

TristimulusWeights weights_of(const SampledCurve& lamp) {
    return make_tristimulus_weights(Observer::cie1931_2deg, lamp);
}

// The independent reference: midpoints of 0.001 nm, and nothing of how the weights are made.
Xyz fine_sum(const SampledCurve& lamp, const Curve& curve) {
    Xyz sum;
    double luminance = 0.0;
    for (int i = 0; i < 470000; ++i) {
        const double nm = 360.0 + (i + 0.5) * 0.001;
        const int left = static_cast<int>(nm);
        const double power = lamp.at(nm), reflected = power * curve(nm);
        const auto& a = colour_matching(Observer::cie1931_2deg, left);
        const auto& b = colour_matching(Observer::cie1931_2deg, left + 1);
        const double t = nm - left;
        sum.x += reflected * std::lerp(a[0], b[0], t);
        sum.y += reflected * std::lerp(a[1], b[1], t);
        sum.z += reflected * std::lerp(a[2], b[2], t);
        luminance += power * std::lerp(a[1], b[1], t);
    }
    return {sum.x / luminance, sum.y / luminance, sum.z / luminance};
}

Xyz sum_over_nodes(const TristimulusWeights& weights, int count, const Curve& curve) {
    const SpectralNodes nodes = make_spectral_nodes(weights, count);
    Xyz sum;
    for (std::size_t i = 0; i < nodes.wavelength_nm.size(); ++i) {
        const double reflectance = curve(nodes.wavelength_nm[i]);
        sum.x += reflectance * nodes.x[i];
        sum.y += reflectance * nodes.y[i];
        sum.z += reflectance * nodes.z[i];
    }
    return sum;
}

void expect_near(const Xyz& a, const Xyz& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

// Airy's formula for a free film of index 1.333 at normal incidence.
Curve film(double thickness_nm) {
    return [=](double nm) {
        const double n = 1.333, r = (n - 1.0) / (n + 1.0), s = std::sin(2.0 * std::numbers::pi * n * thickness_nm / nm);
        const double finesse = 4.0 * r * r / ((1.0 - r * r) * (1.0 - r * r));
        return finesse * s * s / (1.0 + finesse * s * s);
    };
}

TEST(FineLamp, IsOneWithNodesCloserThanANanometreInTheRange) {
    EXPECT_TRUE(has_fine_lines(mercury_lamp(), 360, 830));
    EXPECT_TRUE(has_fine_lines({{360, 500, 500.5, 830}, {1, 1, 1, 1}}, 360, 830));
    EXPECT_FALSE(has_fine_lines({{300, 300.5, 360, 830, 830.5, 831}, {1, 1, 1, 1, 1, 1}}, 360, 830));
    EXPECT_FALSE(has_fine_lines({{360.1, 361.1, 362.1, 830}, {1, 1, 1, 1}}, 361, 800));  // steps of 1 nm, rounded
}

TEST(FineLamp, CellsOfANanometreStayWhatTheyAreForCoarserLamps) {
    const TristimulusWeights weights = weights_of({{360, 361, 830}, {1, 2, 1}});
    EXPECT_EQ(weights.cells_per_nm, 1);
    EXPECT_EQ(weights.count(), 471);
}

TEST(FineLamp, WhiteIsTheIntegralOnTheLampsOwnNodes) {
    const SampledCurve lamp = mercury_lamp();
    expect_near(weights_of(lamp).white, fine_sum(lamp, [](double) { return 1.0; }), 1e-6);
}

TEST(FineLamp, FilmsAreWhatAFineQuadratureGives) {
    const SampledCurve lamp = mercury_lamp();
    const TristimulusWeights weights = weights_of(lamp);
    // Thin, the quadrature's own error; thick, the curvature of fringes within an eighth of a nanometre.
    expect_near(sum_over_nodes(weights, 64, film(400.0)), fine_sum(lamp, film(400.0)), 1e-7);
    expect_near(sum_over_nodes(weights, 128, film(3000.0)), fine_sum(lamp, film(3000.0)), 1e-6);
    expect_near(sum_over_nodes(weights, 600, film(20000.0)), fine_sum(lamp, film(20000.0)), 2e-5);
}

TEST(FineLamp, BandsOfPalettesAreWhatAFineQuadratureGives) {
    const SampledCurve lamp = mercury_lamp();
    const TristimulusWeights weights = weights_of(lamp);
    for (const BandShape band :
         {BandShape{546.3, 60.0, 0.0}, {436.1, 20.0, 0.0}, {577.7, 80.0, 0.4}, {362.0, 30.0, 0.2}}) {
        const Curve curve = [&](double nm) {
            const double from_plateau = std::abs(nm - band.peak_nm) - 0.5 * band.plateau_nm();
            const double shoulder_nm = 0.5 * (band.width_nm - band.plateau_nm());
            if (from_plateau >= shoulder_nm) return 0.0;
            return from_plateau <= 0.0 ? 1.0 : std::cos(0.5 * std::numbers::pi * from_plateau / shoulder_nm);
        };
        const Xyz expected = fine_sum(lamp, curve);
        expect_near(band_to_xyz(weights, band), expected, 2e-6);
        expect_near(band_to_xyz(weights, band), band_to_xyz_per_cell(weights, band), 1e-13);
    }
}

TEST(FineLamp, PlateausMayEndInAnyPartOfANanometre) {
    const SampledCurve lamp = mercury_lamp();
    const auto box = [](double nm) { return nm > 545.25 && nm < 578.5 ? 1.0 : 0.0; };
    expect_near(plateau_to_xyz(weights_of(lamp), 545.25, 578.5), fine_sum(lamp, box), 2e-4);
}

// A laser of no width has the chromaticity of the spectrum's edge, also between whole nanometres.
TEST(FineLamp, OneLineHasTheColourMatchingFunctionsOfItsWavelength) {
    const SampledCurve laser{{360, 532.369, 532.37, 532.371, 830}, {0, 0, 1, 0, 0}};
    const Xyz white = weights_of(laser).white;
    const auto& a = colour_matching(Observer::cie1931_2deg, 532);
    const auto& b = colour_matching(Observer::cie1931_2deg, 533);
    expect_near(white,
                {std::lerp(a[0], b[0], 0.37) / std::lerp(a[1], b[1], 0.37), 1.0,
                 std::lerp(a[2], b[2], 0.37) / std::lerp(a[1], b[1], 0.37)},
                1e-9);
    expect_near(sum_over_nodes(weights_of(laser), 64, film(400.0)),
                {white.x * film(400.0)(532.37), film(400.0)(532.37), white.z * film(400.0)(532.37)}, 1e-6);
}

TEST(FineLamp, MeasuredSpectraAreExactBetweenTheirWavelengths) {
    LightSettings settings;
    settings.power = mercury_lamp();
    const Light light = make_light(settings);
    const MeasuredSpectra spectra{"", {360, 440, 546, 600, 830}, {0.0}, {0.1, 0.9, 0.2, 0.7, 0.3}};
    const SampledCurve curve{spectra.wavelength_nm, spectra.reflectance};
    expect_near(MeasuredColour(spectra, light).at(Incidence::from_degrees(0.0)),
                fine_sum(settings.power, [&](double nm) { return curve.at(nm); }), 2e-6);
}

// Pieces of a nanometre carry three moments of the light times wavelength.
TEST(FineLamp, GratingsSeeTheLinesWithinTheirPieces) {
    const SampledCurve lamp = mercury_lamp();
    const GratingPieces pieces = grating_pieces(weights_of(lamp), 1, 0.0);
    const Curve curve = [](double nm) { return std::sin(nm / 7.0); };
    Xyz sum;
    for (std::size_t i = 0; i < pieces.weights.size(); ++i) {
        const double length = pieces.per_nm[2 * i] - pieces.per_nm[2 * i + 2];
        for (std::size_t j = 0; j < 3; ++j) {
            const double nm = 1.0 / pieces.per_nm[2 * i + j];
            const double share = length * (j == 1 ? 4.0 : 1.0) / 6.0 * nm * curve(nm);  // d nm = nm^2 d (1 / nm)
            sum.x += share * pieces.weights[i][j].x;
            sum.y += share * pieces.weights[i][j].y;
            sum.z += share * pieces.weights[i][j].z;
        }
    }
    expect_near(sum, fine_sum(lamp, curve), 2e-4);
}

// What bakes are judged by walks from node to node of the lamp.
TEST(FineLamp, TheReferenceSeesWhatAFineQuadratureSees) {
    LightSettings settings;
    settings.power = mercury_lamp();
    settings.is_table = true;
    settings.adaptation = Adaptation::none;
    const auto light = std::make_shared<const Light>(make_light(settings));
    Job palette = test::job_of(Palette{{{0.0, {577.7, 80.0, 0.9}}}});
    palette.light = light;
    expect_near(Reference(palette).at(1.0),
                fine_sum(settings.power,
                         [](double nm) {
                             return std::abs(nm - 577.7) < 40.0 ? 0.9 * std::cos(std::numbers::pi * (nm - 577.7) / 80.0)
                                                                : 0.0;
                         }),
                2e-6);
    for (const double thickness_nm : {400.0, 20000.0}) {
        Film model;
        model.index = Index(1.333);
        model.thickness_nm = thickness_nm;
        Job layer = palette;
        layer.material = {"film", {model}, {}};
        expect_near(Reference(layer, 1e-6).at(1.0), fine_sum(settings.power, film(thickness_nm)), 1e-6);
    }
    const MeasuredSpectra measured{"", {360, 440, 546, 600, 830}, {0.0}, {0.1, 0.9, 0.2, 0.7, 0.3}};
    Job spectra = palette;
    spectra.material = {"measured", {measured}, {}};
    expect_near(Reference(spectra).at(1.0), MeasuredColour(measured, *light).at(Incidence::from_degrees(0.0)), 1e-12);
}

}  // namespace
}  // namespace nacre
