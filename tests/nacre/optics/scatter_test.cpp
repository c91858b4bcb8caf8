#include "nacre/optics/scatter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "nacre/base/gauss_points.h"
#include "nacre/optics/structure_factor.h"
#include "reference/number.h"

namespace nacre {
namespace {

constexpr double pi = std::numbers::pi;
using Complex = std::complex<double>;

template <class Function>
double integral(double from, double to, const Function& function) {
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(function, from, to, 12, 1e-12);
}

double seen_at(const ScatterSolver& solver, double cos_scatter, Polarisation polarisation = Polarisation::mean) {
    std::array<double, 1> out{};
    solver.seen(cos_scatter, polarisation, out);
    return out[0];
}

double seen(const Scatter& scatter, double wavelength_nm, double cos_scatter,
            Polarisation polarisation = Polarisation::mean, int sizes = 1) {
    return seen_at(ScatterSolver(scatter, std::array{wavelength_nm}, sizes), cos_scatter, polarisation);
}

// Particles in water that absorb a little.
Scatter latex(ScatterModel model, double radius_nm) {
    Scatter scatter;
    scatter.model = model;
    scatter.particle = Index(Complex(1.59, 0.003));
    scatter.medium = 1.33;
    scatter.radius_nm = radius_nm;
    scatter.volume_fraction = 0.3;
    return scatter;
}

TEST(GaussPoints, IntegratePolynomialsExactly) {
    for (const int count : {1, 2, 3, 10, 64}) {
        double even = 0.0;
        double weights = 0.0;
        const int degree = 2 * count - 2;
        for (const GaussPoint& point : gauss_legendre(count)) {
            even += point.weight * std::pow(point.at, degree);
            weights += point.weight;
        }
        EXPECT_NEAR(even, 2.0 / (degree + 1.0), 1e-14) << count;
        EXPECT_NEAR(weights, 2.0, 1e-14) << count;
    }
    // Moments of a normal variable: 1, 3, 15, ... (degree - 1)!!
    for (const int count : {1, 2, 3, 10, 40, 300}) {
        const int degree = std::min(2 * count - 2, 18);
        double moment = 0.0;
        double weights = 0.0;
        for (const GaussPoint& point : gauss_normal(count)) {
            moment += point.weight * std::pow(point.at, degree);
            weights += point.weight;
        }
        double wanted = 1.0;
        for (int odd = degree - 1; odd > 1; odd -= 2) wanted *= odd;
        EXPECT_NEAR(moment / wanted, 1.0, 1e-12) << count;
        EXPECT_NEAR(weights, 1.0, 1e-13) << count;
    }
}

// The mean of cos(w z) is exp(-w^2 / 2).
TEST(GaussPoints, TakeTheMeanOfRipples) {
    const auto mean = [](int count, double w) {
        double sum = 0.0;
        for (const GaussPoint& point : normal_points(count)) sum += point.weight * std::cos(w * point.at);
        return sum;
    };
    EXPECT_NEAR(mean(16, 2.0), std::exp(-2.0), 1e-9);
    EXPECT_NEAR(mean(64, 2.0), std::exp(-2.0), 1e-8);  // beyond six standard deviations is 2e-9 of all
    EXPECT_NEAR(mean(64, 20.0), 0.0, 1e-8);
    EXPECT_NEAR(mean(256, 100.0), 0.0, 1e-8);
}

TEST(StructureFactor, IsTheCompressibilityOfHardSpheresForLongWaves) {
    for (const double f : {1e-6, 0.1, 0.3, 0.494, 0.6}) {
        const double wanted = std::pow(1.0 - f, 4.0) / ((1.0 + 2.0 * f) * (1.0 + 2.0 * f));
        EXPECT_NEAR(hard_sphere_structure_factor(f, 0.0) / wanted, 1.0, 1e-14) << f;
        EXPECT_NEAR(hard_sphere_structure_factor(f, 1e-8) / wanted, 1.0, 1e-14) << f;
    }
}

// 1 / (1 - rho c(q)) with Wertheim's cubic polynomial for c(r), integrated by quadrature.
TEST(StructureFactor, FollowsFromWertheimsDirectCorrelation) {
    for (const double f : {0.01, 0.2, 0.45, 0.6}) {
        const double fourth = std::pow(1.0 - f, 4.0);
        const double one = (1.0 + 2.0 * f) * (1.0 + 2.0 * f) / fourth;
        const double two = -(1.0 + 0.5 * f) * (1.0 + 0.5 * f) / fourth;
        for (const double u : {1e-3, 0.3, 0.999, 1.0, 1.001, 3.0, 6.9, 12.0, 60.0}) {
            const double correlation = integral(0.0, 1.0, [&](double s) {
                return -(one + 6.0 * f * two * s + 0.5 * f * one * s * s * s) * s * s * std::sin(u * s) / (u * s);
            });
            const double wanted = 1.0 / (1.0 - 24.0 * f * correlation);
            EXPECT_NEAR(hard_sphere_structure_factor(f, u) / wanted, 1.0, 1e-11) << f << " " << u;
        }
    }
}

TEST(StructureFactor, IsOneForFewSpheresAndShortWaves) {
    EXPECT_EQ(hard_sphere_structure_factor(0.0, 3.0), 1.0);
    // First order in the fraction: 1 + 24 f times the integral of -s sin(u s) / u, at most 8 f.
    EXPECT_NEAR(hard_sphere_structure_factor(1e-10, 3.0), 1.0, 8e-10);
    // Contact makes it fall off as 1 / q^2 with a factor of at most 12 f a / 2 each way.
    EXPECT_NEAR(hard_sphere_structure_factor(0.5, 1e4), 1.0, 1e-4 * 50.0 * 1e-2);
}

TEST(Scatter, SpreadsOverTheSphereWhatItTakesAndDoesNotAbsorb) {
    for (const ScatterModel model : {ScatterModel::rayleigh, ScatterModel::mie, ScatterModel::quasi_ordered}) {
        for (const double radius_nm : {5.0, 120.0, 1000.0}) {
            Scatter scatter = latex(model, radius_nm);
            scatter.radius_spread = 0.1;
            scatter.volume_fraction = 0.6;  // as sharp as the structure factor gets
            const ScatterSolver solver(scatter, std::array{500.0}, 4);
            const auto mean = [&](Polarisation polarisation) {
                double sum = 0.0;  // in angles, not cosines: forward peaks of large spheres are narrow
                constexpr int parts = 16;
                for (int part = 0; part < parts; ++part)
                    sum += integral(part * pi / parts, (part + 1) * pi / parts, [&](double angle) {
                        return 0.5 * std::sin(angle) * seen_at(solver, std::cos(angle), polarisation);
                    });
                return sum;
            };
            const double taken = solver.albedo(0) * (1.0 - std::exp(-solver.optical_depth(0)));
            EXPECT_NEAR(mean(Polarisation::mean) / taken, 1.0, 1e-8) << radius_nm;  // exp(-20) of points_over_angles()
            EXPECT_NEAR(0.5 * (mean(Polarisation::s) + mean(Polarisation::p)) / taken, 1.0, 1e-8) << radius_nm;
            EXPECT_LT(solver.albedo(0), 1.0);
        }
    }
}

TEST(Scatter, OfUnpolarisedLightIsHalfOfBothPolarisations) {
    for (const ScatterModel model : {ScatterModel::rayleigh, ScatterModel::mie, ScatterModel::quasi_ordered}) {
        const ScatterSolver solver(latex(model, 90.0), std::array{450.0}, 1);
        for (const double cosine : {-1.0, -0.4, 0.0, 0.8, 1.0}) {
            const double s = seen_at(solver, cosine, Polarisation::s);
            const double p = seen_at(solver, cosine, Polarisation::p);
            EXPECT_DOUBLE_EQ(seen_at(solver, cosine), 0.5 * (s + p));
        }
        EXPECT_NEAR(seen_at(solver, -1.0, Polarisation::s) / seen_at(solver, -1.0, Polarisation::p), 1.0, 1e-12);
    }
}

TEST(Scatter, MakesTheSkyBlueByTheFourthPowerAndPolarisesItAcross) {
    Scatter air;
    air.particle = 1.5;
    air.radius_nm = 1.0;
    air.volume_fraction = 1e-9;
    for (const ScatterModel model : {ScatterModel::rayleigh, ScatterModel::mie}) {
        air.model = model;
        const double blue = seen(air, 400.0, 0.3);
        const double red = seen(air, 800.0, 0.3);
        // Mie's next order: x^2 = 2.5e-4 at 400 nm.
        EXPECT_NEAR(blue / red, 16.0, model == ScatterModel::rayleigh ? 1e-9 : 16.0 * 1e-3);
        EXPECT_LT(seen(air, 500.0, 0.0, Polarisation::p), 1e-3 * seen(air, 500.0, 0.0, Polarisation::s));
    }
    air.model = ScatterModel::rayleigh;
    EXPECT_DOUBLE_EQ(seen(air, 500.0, 0.5) / seen(air, 500.0, 0.0), 1.25);
    EXPECT_EQ(seen(air, 500.0, 0.0, Polarisation::p), 0.0);
}

TEST(Scatter, OfDipolesIsThatOfTinySpheresAbsorbingOrNot) {
    for (const Complex particle : {Complex(1.5), Complex(1.6, 0.2), Complex(0.13, 3.2)}) {
        Scatter scatter = latex(ScatterModel::rayleigh, 0.1);
        scatter.particle = Index(particle);
        scatter.thickness_um = 1e4;
        const ScatterSolver dipoles(scatter, std::array{550.0}, 1);
        scatter.model = ScatterModel::mie;
        const ScatterSolver spheres(scatter, std::array{550.0}, 1);
        const double next = 1e-5;  // x^2 = 2.3e-6, and its factor
        EXPECT_NEAR(dipoles.optical_depth(0) / spheres.optical_depth(0), 1.0, next) << particle;
        EXPECT_NEAR(dipoles.albedo(0) / spheres.albedo(0), 1.0, next) << particle;
        EXPECT_NEAR(seen_at(dipoles, 0.7) / seen_at(spheres, 0.7), 1.0, next) << particle;
    }
}

// The mean over sizes by another quadrature: even steps in ln r, by number and not by volume.
TEST(Scatter, OfManySizesIsTheMeanOverTheirNumber) {
    for (const ScatterModel model : {ScatterModel::rayleigh, ScatterModel::mie}) {
        Scatter scatter = latex(model, model == ScatterModel::mie ? 150.0 : 2.0);
        scatter.radius_spread = 0.3;
        const double sigma = std::sqrt(std::log(1.09));
        const double k = 2.0 * pi * 1.33 / 500.0;
        const Complex m = Complex(1.59, 0.003) / 1.33;
        const Complex alpha = (m * m - 1.0) / (m * m + 2.0);
        double volume = 0.0;
        double extinction = 0.0;
        double across = 0.0;  // |S1|^2 at 90 degrees
        for (double z = -8.0; z < 10.0; z += 0.02) {
            const double r =
                150.0 * (model == ScatterModel::mie ? 1.0 : 2.0 / 150.0) * std::exp(-0.5 * sigma * sigma + sigma * z);
            const double weight = std::exp(-0.5 * z * z);
            const double x = k * r;
            volume += weight * 4.0 / 3.0 * pi * r * r * r;
            if (model == ScatterModel::mie) {
                const MieSphere sphere = mie_sphere(x, m);
                extinction += weight * pi * r * r * sphere.q_ext;
                across += weight * std::norm(mie_amplitudes(sphere, 0.0).s1);
            } else {
                extinction +=
                    weight * pi * r * r * (8.0 / 3.0 * std::pow(x, 4.0) * std::norm(alpha) + 4.0 * x * alpha.imag());
                across += weight * std::pow(x, 6.0) * std::norm(alpha);
            }
        }
        const double depth = 0.3 / volume * extinction * 1e4;
        const double wanted = 4.0 * pi * across / (k * k * extinction) * (1.0 - std::exp(-depth));
        // Cut off at six standard deviations: 2e-9 of the volume, in the smallest and largest spheres.
        const ScatterSolver solver(scatter, std::array{500.0}, 100);
        EXPECT_NEAR(solver.optical_depth(0) / depth, 1.0, 1e-7);
        EXPECT_NEAR(seen_at(solver, 0.0, Polarisation::s) / wanted, 1.0, 1e-7);
    }
}

TEST(Scatter, OfSpheresThatNeedNoRoomIsThatOfSpheresFarApart) {
    Scatter scatter = latex(ScatterModel::quasi_ordered, 100.0);
    scatter.hard_radius_nm = 0.1;  // their share of the volume is 3e-10
    Scatter apart = scatter;
    apart.model = ScatterModel::mie;
    for (const double cosine : {-1.0, 0.0, 1.0})
        EXPECT_NEAR(seen(scatter, 500.0, cosine) / seen(apart, 500.0, cosine), 1.0, 1e-8);
}

TEST(Scatter, OfSmallSpheresThatKeepADistanceIsFainterByTheCompressibility) {
    Scatter scatter = latex(ScatterModel::quasi_ordered, 1.0);
    scatter.particle = 1.59;
    scatter.thickness_um = 1e-3;
    Scatter apart = scatter;
    apart.model = ScatterModel::mie;
    const double wanted = std::pow(0.7, 4.0) / (1.6 * 1.6);
    // (q diameter)^2 is up to (4 * 0.0167)^2 = 4.5e-3 here.
    EXPECT_NEAR(seen(scatter, 500.0, -1.0) / seen(apart, 500.0, -1.0), wanted, 5e-3);
    EXPECT_NEAR(ScatterSolver(scatter, std::array{500.0}, 1).optical_depth(0) /
                    ScatterSolver(apart, std::array{500.0}, 1).optical_depth(0),
                wanted, 5e-3);
}

// Magkiriadou, Park, Kim & Manoharan 2014, Physical Review E 90, 062302: photonic glasses are coloured by the peak of
// the structure factor, q diameter near 7, which is met backwards at wavelength = 4 pi n diameter / 7.
TEST(Scatter, OfQuasiOrderedSpheresPeaksBackwardsWhereTheStructureFactorDoes) {
    Scatter glass;
    glass.model = ScatterModel::quasi_ordered;
    glass.particle = 1.40;
    glass.medium = 1.33;  // weak contrast: what a single sphere sends back varies slowly
    glass.radius_nm = 100.0;
    glass.volume_fraction = 0.5;
    glass.thickness_um = 1.0;
    double peak_q = 0.0;
    double peak = 0.0;
    for (double q = 5.0; q < 9.0; q += 0.01) {
        const double value = hard_sphere_structure_factor(0.5, q);
        if (value > peak) {
            peak = value;
            peak_q = q;
        }
    }
    double brightest_nm = 0.0;
    peak = 0.0;
    for (double nm = 350.0; nm < 700.0; nm += 1.0) {
        const double value = seen(glass, nm, -1.0);
        if (value > peak) {
            peak = value;
            brightest_nm = nm;
        }
    }
    const double expected_nm = 4.0 * pi * 1.33 * 200.0 / peak_q;
    EXPECT_NEAR(brightest_nm / expected_nm, 1.0, 0.05);
    EXPECT_GT(peak, 3.0 * seen(glass, 1.4 * expected_nm, -1.0));
    // Away from straight back the same q is met at shorter waves: by sin(angle / 2).
    double oblique_nm = 0.0;
    peak = 0.0;
    for (double nm = 300.0; nm < 700.0; nm += 1.0) {
        const double value = seen(glass, nm, -0.5, Polarisation::s);
        if (value > peak) {
            peak = value;
            oblique_nm = nm;
        }
    }
    EXPECT_NEAR(oblique_nm / (expected_nm * std::sqrt(0.75)), 1.0, 0.05);
}

TEST(Scatter, IsDarkWithoutContrastAndSendsAllBackWhenThickAndLossless) {
    Scatter scatter = latex(ScatterModel::mie, 100.0);
    scatter.particle = scatter.medium;
    for (const ScatterModel model : {ScatterModel::rayleigh, ScatterModel::mie, ScatterModel::quasi_ordered}) {
        scatter.model = model;
        EXPECT_EQ(seen(scatter, 500.0, 0.2), 0.0);
    }
    Scatter thick = latex(ScatterModel::rayleigh, 50.0);
    thick.particle = 1.59;
    thick.thickness_um = 1e9;
    EXPECT_DOUBLE_EQ(seen(thick, 500.0, 0.0), 0.75);
    thick.thickness_um = 1e-9;  // 1 - exp(-depth) keeps its digits
    const ScatterSolver thin(thick, std::array{500.0}, 1);
    EXPECT_NEAR(seen_at(thin, 0.0) / (0.75 * thin.optical_depth(0)), 1.0, 1e-10);
}

TEST(Scatter, OfSilverAtAnUndampedResonanceIsFinite) {
    Scatter scatter = latex(ScatterModel::rayleigh, 10.0);
    scatter.medium = 1.0;
    scatter.particle = Index(Complex(0.0, std::numbers::sqrt2));
    for (const ScatterModel model : {ScatterModel::rayleigh, ScatterModel::mie, ScatterModel::quasi_ordered}) {
        scatter.model = model;
        EXPECT_TRUE(std::isfinite(seen(scatter, 500.0, 0.3)));
    }
}

TEST(Scatter, CountsItsTermsAndItsLargestSphere) {
    Scatter scatter = latex(ScatterModel::mie, 100.0);
    const std::array<double, 3> wavelengths_nm{400.0, 500.0, 600.0};
    std::size_t terms = 0;
    for (const double nm : wavelengths_nm) terms += static_cast<std::size_t>(mie_terms(2.0 * pi * 1.33 * 100.0 / nm));
    EXPECT_EQ(ScatterSolver(scatter, wavelengths_nm, 1).terms(), terms);
    EXPECT_DOUBLE_EQ(largest_size_parameter(scatter, 400.0, 8), 2.0 * pi * 1.33 * 100.0 / 400.0);
    scatter.radius_spread = 0.2;
    EXPECT_GT(largest_size_parameter(scatter, 400.0, 8), 2.0 * pi * 1.33 * 140.0 / 400.0);
    scatter.model = ScatterModel::rayleigh;
    EXPECT_EQ(ScatterSolver(scatter, wavelengths_nm, 8).terms(), 3U);
    scatter.hard_radius_nm = 125.0;
    EXPECT_DOUBLE_EQ(hard_sphere_fraction(scatter), 0.3 * 1.953125);
}

}  // namespace
}  // namespace nacre
