#include "nacre/optics/measured_spectra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <vector>

#include "reference/number.h"

namespace nacre {
namespace {

// Angles at uneven distances from first_deg on, and reflectances of any shape: flats, jumps, peaks.
MeasuredSpectra random_spectra(reference::Uniform& uniform, std::size_t angles, std::size_t wavelengths) {
    MeasuredSpectra spectra;
    double angle_deg = uniform.between(0.0, 20.0);
    for (std::size_t i = 0; i < angles; ++i) {
        spectra.angle_deg.push_back(angle_deg);
        angle_deg += uniform.between(0.01, 70.0 / static_cast<double>(angles));
    }
    for (std::size_t i = 0; i < wavelengths; ++i)
        spectra.wavelength_nm.push_back(380.0 + 400.0 * static_cast<double>(i) / static_cast<double>(wavelengths));
    for (std::size_t i = 0; i < angles * wavelengths; ++i) {
        const bool is_flat = i >= wavelengths && uniform.between(0.0, 1.0) < 0.2;
        const double size = std::pow(10.0, uniform.between(-6.0, 0.0));
        spectra.reflectance.push_back(is_flat ? spectra.reflectance[i - wavelengths] : size);
    }
    return spectra;
}

std::vector<double> spectrum_at(const MeasuredSpectra& spectra, double theta_deg) {
    std::vector<double> out;
    MeasuredCurve(spectra).at(theta_deg, out);
    return out;
}

MeasuredSpectra one_wavelength(std::vector<double> angles_deg, const std::vector<double>& reflectances) {
    MeasuredSpectra spectra{"", {500.0, 600.0}, std::move(angles_deg), {}};
    for (const double reflectance : reflectances) spectra.reflectance.insert(spectra.reflectance.end(), 2, reflectance);
    return spectra;
}

TEST(MeasuredSpectra, WhatWasMeasuredComesBackToTheBit) {
    reference::Uniform uniform(1);
    for (const std::size_t angles : {1U, 2U, 3U, 7U, 40U}) {
        const MeasuredSpectra spectra = random_spectra(uniform, angles, 5);
        for (std::size_t angle = 0; angle < angles; ++angle) {
            const std::vector<double> out = spectrum_at(spectra, spectra.angle_deg[angle]);
            ASSERT_EQ(out.size(), 5u);
            for (std::size_t i = 0; i < 5; ++i) {
                EXPECT_EQ(out[i], spectra.reflectance[angle * 5 + i]) << angles << " " << angle;
                EXPECT_EQ(measured_reflectance(spectra, spectra.angle_deg[angle], spectra.wavelength_nm[i]), out[i]);
            }
        }
    }
}

TEST(MeasuredSpectra, BetweenTwoAnglesThereIsNothingButWhatIsBetweenTheirReflectances) {
    reference::Uniform uniform(2);
    for (int round = 0; round < 200; ++round) {
        const MeasuredSpectra spectra = random_spectra(uniform, 2 + static_cast<std::size_t>(round % 12), 6);
        const MeasuredCurve curve(spectra);
        std::vector<double> before(6), out;
        for (std::size_t angle = 0; angle + 1 < spectra.angle_deg.size(); ++angle) {
            curve.at(spectra.angle_deg[angle], before);
            const double width_deg = spectra.angle_deg[angle + 1] - spectra.angle_deg[angle];
            for (int step = 1; step < 50; ++step) {
                curve.at(spectra.angle_deg[angle] + width_deg * step / 50.0, out);
                for (std::size_t i = 0; i < 6; ++i) {
                    const auto [least, most] =
                        std::minmax(spectra.reflectance[angle * 6 + i], spectra.reflectance[(angle + 1) * 6 + i]);
                    ASSERT_GE(out[i], least);
                    ASSERT_LE(out[i], most);
                    // Monotone, but for a rounding.
                    const double rise = spectra.reflectance[(angle + 1) * 6 + i] - spectra.reflectance[angle * 6 + i];
                    ASSERT_GE((out[i] - before[i]) * (rise > 0.0 ? 1.0 : -1.0), -4e-16 * most);
                }
                before = out;
            }
        }
    }
}

TEST(MeasuredSpectra, InnerIntervalsAreThoseOfBoostsPchip) {
    // Another program of Fritsch and Butland's slopes, in 50 digits. It has other slopes at the ends.
    reference::Uniform uniform(3);
    for (int round = 0; round < 50; ++round) {
        const MeasuredSpectra spectra = random_spectra(uniform, 8, 2);
        const MeasuredCurve curve(spectra);
        std::vector<reference::Number> angles_deg(spectra.angle_deg.begin(), spectra.angle_deg.end()), values;
        for (std::size_t angle = 0; angle < 8; ++angle) values.emplace_back(spectra.reflectance[angle * 2]);
        const boost::math::interpolators::pchip<std::vector<reference::Number>> other(std::move(angles_deg),
                                                                                      std::move(values));
        std::vector<double> out;
        for (int i = 0; i <= 100; ++i) {
            const double theta_deg = spectra.angle_deg[1] + (spectra.angle_deg[6] - spectra.angle_deg[1]) * i / 100.0;
            curve.at(theta_deg, out);
            // A rounding of the angle next to jumps of up to 1 in a hundredth of a degree.
            EXPECT_LT(reference::distance(out[0], other(theta_deg)), 1e-12) << round << " " << i;
        }
    }
}

TEST(MeasuredSpectra, ParabolasEndsAreTheirOwn) {
    // At the ends the slope is that of the parabola through three: one that rises throughout is met at its end.
    const auto parabola = [](double x) { return 0.01 + 1e-4 * x * x; };
    std::vector<double> values;
    for (const double angle_deg : {10.0, 25.0, 30.0, 60.0}) values.push_back(parabola(angle_deg));
    const MeasuredSpectra spectra = one_wavelength({10.0, 25.0, 30.0, 60.0}, values);
    const double step_deg = 1e-4;
    EXPECT_NEAR((spectrum_at(spectra, 10.0 + step_deg)[0] - values[0]) / step_deg, 2e-4 * 10.0, 1e-7);
    EXPECT_NEAR((values[3] - spectrum_at(spectra, 60.0 - step_deg)[0]) / step_deg, 2e-4 * 60.0, 1e-7);
    // One that would leave the end backwards stays flat.
    const MeasuredSpectra bent = one_wavelength({5.0, 15.0, 25.0}, {0.1, 0.11, 0.5});
    EXPECT_NEAR((spectrum_at(bent, 5.0 + step_deg)[0] - 0.1) / step_deg, 0.0, 1e-7);
    // Hermite's cubic half-way: the mean of values, and an eighth of the width times the difference of slopes.
    const double inner = 2.0 / (1.0 / 0.001 + 1.0 / 0.039);
    EXPECT_NEAR(spectrum_at(bent, 10.0)[0], 0.105 - 10.0 / 8.0 * inner, 1e-15);
    // One that turns round at once is no steeper than three times what follows.
    const MeasuredSpectra steep = one_wavelength({5.0, 15.0, 25.0}, {0.1, 0.11, 0.01});
    EXPECT_NEAR((spectrum_at(steep, 5.0 + step_deg)[0] - 0.1) / step_deg, 3.0 * 0.001, 1e-7);
}

TEST(MeasuredSpectra, AreLevelAtTheNormalBecauseASurfaceLooksAlikeFromEitherSideOfIt) {
    // A cubic that starts level moves by its curvature alone: 3 * 0.01 / 10^2 * step^2 at most.
    const double step_deg = 1e-4;
    for (const double last : {0.01, 0.12, 0.5}) {
        const MeasuredSpectra spectra = one_wavelength({0.0, 10.0, 20.0}, {0.1, 0.11, last});
        EXPECT_NEAR((spectrum_at(spectra, step_deg)[0] - 0.1) / step_deg, 0.0, 1e-7) << last;
        EXPECT_GT(spectrum_at(spectra, 5.0)[0], 0.1) << last;
    }
    // Where nobody looked at the normal nothing is said of it.
    const MeasuredSpectra oblique = one_wavelength({1.0, 10.0, 20.0}, {0.1, 0.19, 0.29});
    EXPECT_NEAR((spectrum_at(oblique, 1.0 + step_deg)[0] - 0.1) / step_deg, 0.01, 1e-6);
}

TEST(MeasuredSpectra, AStraightLineStaysOne) {
    const MeasuredSpectra spectra = one_wavelength({5.0, 6.0, 30.0, 31.5, 80.0}, {0.05, 0.06, 0.3, 0.315, 0.8});
    for (double theta_deg = 5.0; theta_deg < 80.0; theta_deg += 0.37)
        EXPECT_NEAR(spectrum_at(spectra, theta_deg)[0], 0.01 * theta_deg, 4e-16);
    const MeasuredSpectra two = one_wavelength({20.0, 70.0}, {0.6, 0.1});
    EXPECT_NEAR(spectrum_at(two, 35.0)[1], 0.45, 1e-15);
}

TEST(MeasuredSpectra, BeyondTheAnglesTheirEndsAreHeld) {
    reference::Uniform uniform(4);
    const MeasuredSpectra spectra = random_spectra(uniform, 6, 4);
    EXPECT_EQ(spectrum_at(spectra, 0.0), spectrum_at(spectra, spectra.angle_deg.front()));
    EXPECT_EQ(spectrum_at(spectra, 90.0), spectrum_at(spectra, spectra.angle_deg.back()));
    const MeasuredSpectra one = random_spectra(uniform, 1, 4);
    for (const double theta_deg : {0.0, one.angle_deg[0], 90.0})
        EXPECT_EQ(spectrum_at(one, theta_deg), one.reflectance) << "one angle is all angles";
}

TEST(MeasuredSpectra, BetweenWavelengthsReflectanceIsStraightAndBeyondThemHeld) {
    reference::Uniform uniform(5);
    const MeasuredSpectra spectra = random_spectra(uniform, 5, 7);
    for (const double theta_deg : {0.0, 12.3, 33.3, 60.0, 90.0}) {
        const std::vector<double> nodes = spectrum_at(spectra, theta_deg);
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            for (const double t : {0.25, 0.5, 0.9}) {
                const double nm =
                    spectra.wavelength_nm[i] + t * (spectra.wavelength_nm[i + 1] - spectra.wavelength_nm[i]);
                EXPECT_NEAR(measured_reflectance(spectra, theta_deg, nm), nodes[i] + t * (nodes[i + 1] - nodes[i]),
                            1e-14);
            }
        }
        EXPECT_EQ(measured_reflectance(spectra, theta_deg, 100.0), nodes.front());
        EXPECT_EQ(measured_reflectance(spectra, theta_deg, 2000.0), nodes.back());
    }
}

}  // namespace
}  // namespace nacre
