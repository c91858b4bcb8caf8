#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "nacre/optics/multilayer/multilayer.h"

namespace nacre {
namespace {

constexpr std::array<Polarisation, 3> all{Polarisation::mean, Polarisation::s, Polarisation::p};

// In no order, and no multiple of any register.
const std::vector<double> wavelengths_nm{700.0, 380.0, 555.5, 830.0, 360.0, 481.25, 640.0, 399.9, 511.0, 777.0, 420.0};

double uniform(std::mt19937& generator, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
}

// Lossless, lossy and incoherent layers, short and long groups, one within another.
LayerSystem random_system(std::mt19937& generator) {
    const double lossless_share = uniform(generator, 0.0, 1.0) < 0.5 ? 1.0 : 0.5;
    const auto index = [&]() -> RefractiveIndex {
        const double n = uniform(generator, 0.3, 4.0);
        const bool is_lossless = uniform(generator, 0.0, 1.0) < lossless_share;
        return {n, is_lossless ? 0.0 : std::exp(uniform(generator, -9.0, 1.0))};
    };
    LayerSystemBuilder builder(uniform(generator, 1.0, 1.8), index());
    for (int items = std::uniform_int_distribution<int>(0, 6)(generator); items > 0; --items) {
        const double kind = uniform(generator, 0.0, 1.0);
        if (kind < 0.4) {
            builder.layer(index(), uniform(generator, 0.0, 500.0));
        } else if (kind < 0.6) {
            builder.layer(index(), uniform(generator, 1e3, 1e5), true);
        } else {
            builder.begin_group(std::uniform_int_distribution<int>(1, 12)(generator));
            const int members = std::uniform_int_distribution<int>(1, 6)(generator);
            for (int i = 0; i < members; ++i) builder.layer(index(), uniform(generator, 0.0, 200.0));
            if (kind > 0.8) {
                builder.begin_group(3);
                builder.layer(index(), 30.0);
                builder.end_group();
            }
            builder.end_group();
        }
    }
    return builder.take();
}

// Per polarisation, as in `all`: with the weights 1, 2, 3, ...; of the fourth wavelength; with none.
std::array<std::array<double, 3>, 3> weighted(const MultilayerSolver& solver, const Incidence& incidence) {
    std::vector<double> rising(solver.padded_count(), 0.0);
    for (std::size_t i = 0; i < solver.count(); ++i) rising[i] = static_cast<double>(i + 1);
    std::vector<double> fourth(solver.padded_count(), 0.0);
    fourth[3] = 1.0;
    const std::vector<double> none(solver.padded_count(), 0.0);
    std::array<std::array<double, 3>, 3> sums{};
    for (std::size_t i = 0; i < 3; ++i)
        sums[i] = solver.weighted_reflectances(incidence, {rising.data(), fourth.data(), none.data()}, all[i]);
    return sums;
}

// Lets the dispatcher choose among these alone; 0 restores all.
void allow_instruction_sets(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(MultilayerPolarisation, EachIsThatOfTheResponsesAndTheirMeanIsThatOfUnpolarisedLight) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        allow_instruction_sets(target);
        std::mt19937 generator(12);
        for (int i = 0; i < 200; ++i) {
            const MultilayerSolver solver(random_system(generator), wavelengths_nm);
            const Incidence incidence = Incidence::from_degrees(i % 20 == 0 ? 90.0 : uniform(generator, 0.0, 89.9));
            std::vector<Response> responses(wavelengths_nm.size());
            solver.responses(incidence, responses);
            Response sum;
            for (std::size_t j = 0; j < responses.size(); ++j) {
                sum.reflectance_s += static_cast<double>(j + 1) * responses[j].reflectance_s;
                sum.reflectance_p += static_cast<double>(j + 1) * responses[j].reflectance_p;
            }
            const auto [mean, s, p] = weighted(solver, incidence);
            const std::string what = std::string(hwy::TargetName(target)) + " " + std::to_string(i);
            // The fields are the same; a division, eleven terms of a sum of at most 66.
            const double rounding = 1e-13;
            EXPECT_NEAR(s[0], sum.reflectance_s, rounding) << what;
            EXPECT_NEAR(p[0], sum.reflectance_p, rounding) << what;
            EXPECT_NEAR(s[1], responses[3].reflectance_s, 1e-15) << what;
            EXPECT_NEAR(p[1], responses[3].reflectance_p, 1e-15) << what;
            EXPECT_NEAR(0.5 * (s[0] + p[0]), mean[0], rounding) << what;
            EXPECT_NEAR(0.5 * (s[1] + p[1]), mean[1], 1e-15) << what;
            for (const double nothing : {mean[2], s[2], p[2]}) EXPECT_EQ(nothing, 0.0) << what;
            if (HasFailure()) break;
        }
    }
    allow_instruction_sets(0);
}

TEST(MultilayerPolarisation, UnpolarisedUnlessAskedOtherwise) {
    std::mt19937 generator(3);
    const MultilayerSolver solver(random_system(generator), wavelengths_nm);
    const std::vector<double> ones(solver.padded_count(), 1.0);
    const std::array<const double*, 3> weights{ones.data(), ones.data(), ones.data()};
    const Incidence incidence = Incidence::from_degrees(50.0);
    EXPECT_EQ(solver.weighted_reflectances(incidence, weights),
              solver.weighted_reflectances(incidence, weights, Polarisation::mean));
    EXPECT_NE(solver.weighted_reflectances(incidence, weights, Polarisation::s),
              solver.weighted_reflectances(incidence, weights, Polarisation::p));
}

TEST(MultilayerPolarisation, AtBrewstersAngleOnlySIsReflected) {
    const double n = 1.52;
    const Incidence brewster = Incidence::from_degrees(std::atan(n) * 180.0 / std::numbers::pi);
    const auto [mean, s, p] = weighted({LayerSystemBuilder(1.0, n).take(), wavelengths_nm}, brewster);
    const double amplitude = (n * n - 1.0) / (n * n + 1.0);  // Born & Wolf, 7th ed., section 1.5.3
    EXPECT_NEAR(s[1], amplitude * amplitude, 1e-15);
    EXPECT_LT(p[1], 1e-30) << "the angle's rounding, squared";
    EXPECT_NEAR(mean[1], 0.5 * amplitude * amplitude, 1e-15);
}

TEST(MultilayerPolarisation, AlongTheNormalThereIsOnlyOne) {
    std::mt19937 generator(4);
    for (int i = 0; i < 50; ++i) {
        const auto [mean, s, p] = weighted({random_system(generator), wavelengths_nm}, Incidence::from_degrees(0.0));
        // Layers' roundings differ, a hundred of them, and are larger next to band edges.
        EXPECT_NEAR(s[0], p[0], 1e-10) << i;
        EXPECT_NEAR(s[0], mean[0], 1e-10) << i;
    }
}

}  // namespace
}  // namespace nacre
