#include "nacre/optics/lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "reference/number.h"

namespace nacre {
namespace {

using reference::Number;

TEST(Lobe, PeakReflectsTheHeight) {
    EXPECT_EQ(lobe_reflectance({460.0, 70.0, 0.7}, 460.0), 0.7);
    EXPECT_EQ(lobe_reflectance({460.3, 1e-3, 1.0}, 460.3), 1.0);
}

TEST(Lobe, HalfTheHeightIsReachedAThirdOfTheWidthFromThePeak) {
    const Lobe lobe{500.0, 90.0, 0.8};  // cos(pi / 3) = 1 / 2
    EXPECT_NEAR(lobe_reflectance(lobe, 530.0), 0.4, 1e-15);
    EXPECT_NEAR(lobe_reflectance(lobe, 470.0), 0.4, 1e-15);
}

TEST(Lobe, ReflectsNothingAtItsEndsAndBeyond) {
    const Lobe lobe{500.0, 90.0, 1.0};
    for (const double away_nm : {45.0, 45.1, 90.0, 135.0, 180.0, 1e6}) {
        EXPECT_EQ(lobe_reflectance(lobe, 500.0 + away_nm), 0.0) << away_nm;
        EXPECT_EQ(lobe_reflectance(lobe, 500.0 - away_nm), 0.0) << away_nm;
    }
}

TEST(Lobe, OfNoWidthIsBlackEvenAtItsPeak) {
    EXPECT_EQ(lobe_reflectance({500.0, 0.0, 1.0}, 500.0), 0.0);
    EXPECT_EQ(lobe_reflectance({500.0, 0.0, 1.0}, 500.0 + 1e-13), 0.0);
}

TEST(Lobe, OfTheSmallestAndLargestWidthStaysFiniteAndWithinItsHeight) {
    for (const double width_nm :
         {std::numeric_limits<double>::denorm_min(), 1e-300, 1e-12, 1e12, 1e300, std::numeric_limits<double>::max()}) {
        for (const double wavelength_nm : {360.0, 500.0, 500.0 + 1e-13, 830.0}) {
            const double reflectance = lobe_reflectance({500.0, width_nm, 0.9}, wavelength_nm);
            EXPECT_GE(reflectance, 0.0) << width_nm << ' ' << wavelength_nm;  // fails for NaN too
            EXPECT_LE(reflectance, 0.9) << width_nm << ' ' << wavelength_nm;
        }
    }
}

TEST(Lobe, IsTheHalfCosineIn50Digits) {
    reference::Uniform uniform(1);
    for (int i = 0; i < 2000; ++i) {
        const Lobe lobe{uniform.between(300.0, 900.0), std::pow(10.0, uniform.between(-2.0, 3.0)),
                        uniform.between(0.0, 1.0)};
        const double wavelength_nm = lobe.peak_nm + 0.55 * lobe.width_nm * uniform.between(-1.0, 1.0);
        const Number away = Number(wavelength_nm) - Number(lobe.peak_nm);
        const bool inside = 2 * abs(away) < Number(lobe.width_nm);
        const Number exact = inside ? Number(lobe.height) * cos(reference::pi() * away / lobe.width_nm) : Number(0);
        const double reflectance = lobe_reflectance(lobe, wavelength_nm);
        // The subtraction is exact for neighbours and else below 1 ulp; the phase, at most pi / 2, and the cosine
        // round a few times.
        EXPECT_LT(reference::distance(reflectance, exact), 1e-15) << wavelength_nm << ' ' << lobe.width_nm;
        EXPECT_GE(reflectance, 0.0);
        EXPECT_LE(reflectance, lobe.height);
    }
}

TEST(Lobe, IsTheSameOnBothSidesOfThePeak) {
    const Lobe lobe{512.0, 77.0, 1.0};
    for (double away_nm = 0.0; away_nm < 50.0; away_nm += 0.25) {
        EXPECT_EQ(lobe_reflectance(lobe, 512.0 - away_nm), lobe_reflectance(lobe, 512.0 + away_nm)) << away_nm;
    }
}

// A plateau of 50 nm between shoulders of 25 nm.
const Lobe flat_band{500.0, 100.0, 0.9, 0.1, 0.5};
const Lobe flat_notch{500.0, 100.0, 0.0, 1.0, 0.5};
constexpr double sqrt_half = 0.70710678118654752;

TEST(Lobe, WithFlatnessIsItsHeightOnThePlateauAndItsFloorOutside) {
    for (const double away_nm : {0.0, 10.0, 24.999, 25.0}) {
        EXPECT_EQ(lobe_reflectance(flat_band, 500.0 - away_nm), 0.9) << away_nm;
        EXPECT_EQ(lobe_reflectance(flat_band, 500.0 + away_nm), 0.9) << away_nm;
    }
    for (const double away_nm : {50.0, 50.001, 75.0, 1e6}) {
        EXPECT_EQ(lobe_reflectance(flat_band, 500.0 - away_nm), 0.1) << away_nm;
        EXPECT_EQ(lobe_reflectance(flat_band, 500.0 + away_nm), 0.1) << away_nm;
    }
}

TEST(Lobe, ShouldersAreQuartersOfACosine) {
    // cos(pi / 4) half way down, cos(pi / 3) two thirds of the way.
    EXPECT_NEAR(lobe_reflectance(flat_band, 537.5), 0.1 + 0.8 * sqrt_half, 1e-15);
    EXPECT_NEAR(lobe_reflectance(flat_band, 462.5), 0.1 + 0.8 * sqrt_half, 1e-15);
    EXPECT_NEAR(lobe_reflectance(flat_band, 500.0 + 125.0 / 3.0), 0.5, 1e-14);
    EXPECT_NEAR(lobe_reflectance({500.0, 100.0, 0.9, 0.1}, 525.0), 0.1 + 0.8 * sqrt_half, 1e-15);
}

TEST(Lobe, NotchIsWhatABandLeaves) {
    EXPECT_EQ(lobe_reflectance(flat_notch, 510.0), 0.0);
    EXPECT_EQ(lobe_reflectance(flat_notch, 560.0), 1.0);
    EXPECT_NEAR(lobe_reflectance(flat_notch, 537.5), 1.0 - sqrt_half, 1e-15);
    for (double nm = 440.0; nm < 560.0; nm += 0.5) {
        const double band = lobe_reflectance({500.0, 100.0, 1.0, 0.0, 0.5}, nm);
        EXPECT_NEAR(lobe_reflectance(flat_notch, nm), 1.0 - band, 1e-15) << nm;
    }
}

TEST(Lobe, GreyAndWithoutWidthIsItsFloorEverywhere) {
    for (const double nm : {360.0, 500.0, 501.0, 830.0}) {
        EXPECT_EQ(lobe_reflectance({500.0, 100.0, 0.3, 0.3, 0.7}, nm), 0.3);
        EXPECT_EQ(lobe_reflectance({500.0, 0.0, 0.8, 0.3, 0.7}, nm), 0.3);
    }
}

TEST(Lobe, WithoutFloorAndFlatnessIsTheHalfCosineBitByBit) {
    reference::Uniform uniform(5);
    for (int i = 0; i < 1000; ++i) {
        const double width_nm = uniform.between(1.0, 400.0), height = uniform.between(0.0, 1.0);
        const double away_nm = std::abs(500.0 + uniform.between(-0.49, 0.49) * width_nm - 500.0);
        EXPECT_EQ(lobe_reflectance({500.0, width_nm, height}, 500.0 + away_nm),
                  height * std::cos(std::numbers::pi * std::abs(500.0 + away_nm - 500.0) / width_nm));
    }
}

TEST(Lobe, WithFloorAndFlatnessIsItsFormulaIn50Digits) {
    reference::Uniform uniform(6);
    for (int i = 0; i < 2000; ++i) {
        const Lobe lobe{uniform.between(300.0, 900.0), std::pow(10.0, uniform.between(0.0, 3.0)),
                        uniform.between(0.0, 1.0), uniform.between(0.0, 1.0), uniform.between(0.0, 0.9)};
        const double wavelength_nm = lobe.peak_nm + 0.55 * lobe.width_nm * uniform.between(-1.0, 1.0);
        const Number x = abs(Number(wavelength_nm) - Number(lobe.peak_nm)) / Number(lobe.width_nm);
        const Number s(lobe.flatness);
        const Number band = 2 * x <= s  ? Number(1)
                            : 2 * x < 1 ? Number(cos(reference::pi() * (x - s / 2) / (1 - s)))
                                        : Number(0);
        const Number exact = lobe.floor + (Number(lobe.height) - Number(lobe.floor)) * band;
        // The distance, 1e-16 of the width, is divided by the shoulders, a tenth of it at least.
        EXPECT_LT(reference::distance(lobe_reflectance(lobe, wavelength_nm), exact), 1e-14);
    }
}

}  // namespace
}  // namespace nacre
