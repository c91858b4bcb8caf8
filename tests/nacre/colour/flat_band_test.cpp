// Bands with a plateau: the closed form against 50 digits. NACRE_TEST_SWEEP takes all widths, flatnesses and peaks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "nacre/colour/illuminant.h"
#include "nacre/colour/tristimulus.h"
#include "reference/lobe_quadrature.h"
#include "reference/weights.h"

namespace nacre {
namespace {

constexpr double flatnesses[] = {1e-6, 0.01, 0.3, 0.5, 0.9, 0.99, 0.999};

struct FlatSetting {
    Observer observer;
    const char* illuminant;
    int first_nm, last_nm;
};

struct BothWeights {
    TristimulusWeights core;
    reference::Weights exact;
};

BothWeights weights_of(const FlatSetting& setting) {
    const char* file =
        setting.observer == Observer::cie1931_2deg ? "cmf_cie1931_2deg_1nm.csv" : "cmf_cie1964_10deg_1nm.csv";
    return {make_tristimulus_weights(setting.observer, *illuminant_by_name(setting.illuminant), setting.first_nm,
                                     setting.last_nm),
            reference::weights_from_files(file, setting.illuminant, setting.first_nm, setting.last_nm)};
}

double distance(const Xyz& colour, const reference::XyzNumbers& exact) {
    if (!std::isfinite(colour.x + colour.y + colour.z)) return std::numeric_limits<double>::infinity();
    return std::max({reference::distance(colour.x, exact.x), reference::distance(colour.y, exact.y),
                     reference::distance(colour.z, exact.z)});
}

// From a hundredth of a nanometre to beyond the range; at random, with ends at whole nanometres, and with the
// plateau's.
std::vector<BandShape> hard_bands(bool all) {
    std::vector<double> widths{1.0, 2.0, 64.0, 940.0};
    for (int k = 0; k <= 22; ++k) widths.push_back(std::pow(10.0, -2.0 + 0.25 * k));
    reference::Uniform uniform(18);
    std::vector<BandShape> bands;
    for (const double width : widths) {
        for (const double flatness : flatnesses) {
            const double whole = std::floor(uniform.between(300.0, 900.0));
            const BandShape one{uniform.between(300.0, 900.0), width, flatness};
            const BandShape ends_whole{whole + 0.5 * width, width, flatness};
            const BandShape plateau_ends_whole{whole + 0.5 * flatness * width, width, flatness};
            const BandShape at_the_range{360.0 + uniform.between(-0.5, 0.5) * width, width, flatness};
            if (all) {
                bands.insert(bands.end(), {one, ends_whole, plateau_ends_whole, at_the_range});
                for (int i = 0; i < 10; ++i) bands.push_back({uniform.between(300.0, 900.0), width, flatness});
            } else {
                bands.push_back(std::array{one, ends_whole, plateau_ends_whole, at_the_range}[bands.size() % 4]);
            }
        }
    }
    return bands;
}

TEST(FlatBand, AgreesWithAntiderivativesIn50Digits) {
    const bool all = std::getenv("NACRE_TEST_SWEEP") != nullptr;
    std::vector<BothWeights> settings{weights_of({Observer::cie1931_2deg, "D65", 360, 830}),
                                      weights_of({Observer::cie1964_10deg, "FL11", 380, 780})};
    if (all) settings.push_back(weights_of({Observer::cie1931_2deg, "A", 360, 830}));
    double worst = 0.0, worst_per_cell = 0.0;
    std::ostringstream where;
    for (const BandShape& band : hard_bands(all)) {
        const auto cells = reference::FlatBandMoments(band.peak_nm, band.width_nm, band.flatness).cells();
        for (const BothWeights& weights : settings) {
            const reference::XyzNumbers exact = reference_lobe_to_xyz(weights.exact, cells, 1.0);
            const double error = distance(band_to_xyz(weights.core, band), exact);
            worst_per_cell = std::max(worst_per_cell, distance(band_to_xyz_per_cell(weights.core, band), exact));
            if (error <= worst) continue;
            worst = error;
            where.str("");
            where << "peak " << band.peak_nm << " width " << band.width_nm << " flatness " << band.flatness;
        }
    }
    // Hundreds of products, each rounded to 1.1e-16 of at most 1; 1e-12 is the project's promise.
    EXPECT_LT(worst, 1e-12) << where.str();
    EXPECT_LT(worst_per_cell, 1e-12);
    RecordProperty("worst", std::to_string(worst * 1e15) + "e-15 at " + where.str());
}

TEST(FlatBand, OfFlatnessZeroIsTheHalfCosineBitByBit) {
    const TristimulusWeights weights = weights_of({Observer::cie1931_2deg, "D65", 360, 830}).core;
    for (const double width_nm : {0.3, 40.0, 250.0, 900.0})
        EXPECT_EQ(band_to_xyz(weights, {520.25, width_nm}), band_to_xyz(weights, {520.25, width_nm, 0.0}));
}

TEST(FlatBand, OnAPlateauIsWhatTheWeightsSumUpTo) {
    // Whole nanometres: the trapezium rule of weights that are linear is exact.
    const TristimulusWeights weights = weights_of({Observer::cie1931_2deg, "D65", 360, 830}).core;
    double sum = 0.0;
    for (std::size_t i = 140; i < 240; ++i) sum += 0.5 * (weights.y[i] + weights.y[i + 1]);
    EXPECT_NEAR(plateau_to_xyz(weights, 500.0, 600.0).y, sum, 1e-14);
    EXPECT_NEAR(plateau_to_xyz(weights, 500.5, 501.0).y, 0.25 * (0.5 * weights.y[140] + 1.5 * weights.y[141]), 1e-15);
    EXPECT_NEAR(plateau_to_xyz(weights, 0.0, 1e6).y, 1.0, 1e-14);
    EXPECT_EQ(plateau_to_xyz(weights, 900.0, 1000.0), Xyz{});
}

}  // namespace
}  // namespace nacre
