#include "nacre/optics/multilayer/multilayer.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace nacre {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

LayerSystem bare(const Index& incident, const Index& substrate) {
    return LayerSystemBuilder(incident, substrate).take();
}

LayerSystem coated(const Index& incident, const Index& film, double thickness_nm, const Index& substrate) {
    LayerSystemBuilder builder(incident, substrate);
    builder.layer(film, thickness_nm);
    return builder.take();
}

Response solved(const LayerSystem& system, double theta_deg, double wavelength_nm) {
    Response response;
    MultilayerSolver(system, {&wavelength_nm, 1}).responses(Incidence::from_degrees(theta_deg), {&response, 1});
    return response;
}

// The scalar reference implementation and the solver: every textbook identity holds for both.
std::vector<Response> both(const LayerSystem& system, double theta_deg, double wavelength_nm = 550.0) {
    return {multilayer_response(system, Incidence::from_degrees(theta_deg), wavelength_nm),
            solved(system, theta_deg, wavelength_nm)};
}

void expect_near(const Response& one, const Response& other, double tolerance, const std::string& what) {
    EXPECT_NEAR(one.reflectance_s, other.reflectance_s, tolerance) << what;
    EXPECT_NEAR(one.reflectance_p, other.reflectance_p, tolerance) << what;
    EXPECT_NEAR(one.transmittance_s, other.transmittance_s, tolerance) << what;
    EXPECT_NEAR(one.transmittance_p, other.transmittance_p, tolerance) << what;
}

// Born & Wolf, Principles of Optics, 7th ed., section 1.5.2, equations 20 and 21; k of the second medium too.
Response fresnel(double n0, Complex n1, double theta_deg) {
    const double sine = std::sin(theta_deg * pi / 180.0);
    const double cosine = std::cos(theta_deg * pi / 180.0);
    const Complex cosine_1 = std::sqrt(1.0 - std::pow(n0 * sine / n1, 2));
    Response r;
    r.reflectance_s = std::norm((n0 * cosine - n1 * cosine_1) / (n0 * cosine + n1 * cosine_1));
    r.reflectance_p = std::norm((n1 * cosine - n0 * cosine_1) / (n1 * cosine + n0 * cosine_1));
    r.transmittance_s = 1.0 - r.reflectance_s;
    r.transmittance_p = 1.0 - r.reflectance_p;
    return r;
}

TEST(Multilayer, BareSurfaceReflectsAsFresnelSays) {
    for (const Complex n1 : {Complex(1.5), Complex(4.0), Complex(0.75), Complex(0.2, 3.4), Complex(2.0, 1e-3)}) {
        for (const double theta_deg : {0.0, 1e-6, 30.0, 45.0, 56.0, 60.0, 75.0, 89.0}) {
            for (const Response& r : both(bare(1.0, n1), theta_deg)) {
                // Rounding of Fresnel's formula itself, where cosines cancel next to the critical angle.
                expect_near(r, fresnel(1.0, n1, theta_deg), 1e-13, std::to_string(theta_deg));
            }
        }
    }
    for (const Response& r : both(bare(1.0, 1.5), 0.0)) EXPECT_NEAR(r.reflectance(), 0.04, 1e-16) << "glass: 4 %";
}

TEST(Multilayer, BrewstersAngleHasNoPPolarisedReflection) {
    for (const double n : {1.33, 1.52, 2.4}) {
        const double brewster_deg = std::atan(n) * 180.0 / pi;
        for (const Response& r : both(bare(1.0, n), brewster_deg)) {
            EXPECT_LT(r.reflectance_p, 1e-30) << n;  // the angle's rounding, squared
            const double s = (n * n - 1.0) / (n * n + 1.0);
            EXPECT_NEAR(r.reflectance_s, s * s, 1e-15) << n;
        }
    }
}

TEST(Multilayer, QuarterWaveFilmOfTheRootOfTheSubstratesIndexReflectsNothing) {
    for (const double substrate : {1.52, 2.4, 4.0}) {
        const double film = std::sqrt(substrate);
        for (const Response& r : both(coated(1.0, film, 550.0 / (4.0 * film), substrate), 0.0)) {
            EXPECT_LT(r.reflectance(), 1e-30) << substrate;
            EXPECT_NEAR(r.transmittance(), 1.0, 1e-15) << substrate;
        }
    }
}

TEST(Multilayer, QuarterWaveFilmTurnsTheSubstrateIntoOneOfFilmSquaredOverSubstrate) {
    // Macleod, Thin-Film Optical Filters, 4th ed., section 2.6: admittance n_film^2 / n_substrate.
    const double film = 2.35, substrate = 1.52;
    const double admittance = film * film / substrate;
    const double r0 = (1.0 - admittance) / (1.0 + admittance);
    for (const int odd : {1, 3, 101}) {
        for (const Response& r : both(coated(1.0, film, odd * 550.0 / (4.0 * film), substrate), 0.0))
            EXPECT_NEAR(r.reflectance(), r0 * r0, 1e-13) << odd;  // a phase of 100 turns, rounded
    }
}

TEST(Multilayer, HalfWaveFilmIsAbsent) {
    for (const double film : {1.38, 2.4, 4.0}) {
        for (const int halves : {1, 2, 10}) {
            const LayerSystem system = coated(1.0, film, halves * 550.0 / (2.0 * film), 1.52);
            const Response without = fresnel(1.0, 1.52, 0.0);
            for (const Response& r : both(system, 0.0)) expect_near(r, without, 1e-14, std::to_string(film));
        }
    }
    // At an angle with the same path across the film, n d cos(theta_1), it is absent too.
    const double film = 2.0, theta_deg = 50.0;
    const double cosine_1 = std::sqrt(1.0 - std::pow(std::sin(theta_deg * pi / 180.0) / film, 2));
    for (const Response& r : both(coated(1.0, film, 550.0 / (2.0 * film * cosine_1), 1.52), theta_deg))
        expect_near(r, fresnel(1.0, 1.52, theta_deg), 1e-14, "oblique");
}

TEST(Multilayer, FreeFilmIsAnAiryFunctionOfItsPhase) {
    // Born & Wolf, section 7.6.1, equation 15: R = F sin^2(delta / 2) / (1 + F sin^2(delta / 2)), F = 4 r / (1 - r)^2.
    const double n = 1.5;
    for (const double theta_deg : {0.0, 20.0, 60.0, 80.0}) {
        const Response face = fresnel(1.0, n, theta_deg);
        const double cosine_1 = std::sqrt(1.0 - std::pow(std::sin(theta_deg * pi / 180.0) / n, 2));
        for (const double thickness_nm : {10.0, 123.4, 400.0, 5000.0}) {
            const double half_phase = 2.0 * pi * n * thickness_nm * cosine_1 / 550.0;
            const auto airy = [&](double r) {
                const double f = 4.0 * r / ((1.0 - r) * (1.0 - r)) * std::pow(std::sin(half_phase), 2);
                return f / (1.0 + f);
            };
            for (const Response& r : both(coated(1.0, n, thickness_nm, 1.0), theta_deg)) {
                EXPECT_NEAR(r.reflectance_s, airy(face.reflectance_s), 2e-13) << theta_deg << " " << thickness_nm;
                EXPECT_NEAR(r.reflectance_p, airy(face.reflectance_p), 2e-13) << theta_deg << " " << thickness_nm;
                EXPECT_NEAR(r.transmittance_s, 1.0 - r.reflectance_s, 1e-14);
                EXPECT_NEAR(r.transmittance_p, 1.0 - r.reflectance_p, 1e-14);
            }
        }
    }
}

TEST(Multilayer, QuarterWavePairsReflectAsTheRatioOfIndicesToTheirNumber) {
    // Born & Wolf, section 1.6.5, equation 102: R = ((1 - Y) / (1 + Y))^2, Y = n_substrate (n_low / n_high)^(2 N).
    const double high = 2.3, low = 1.38, substrate = 1.52;
    for (const int pairs : {1, 2, 5, 10}) {
        LayerSystemBuilder builder(1.0, substrate);
        builder.begin_group(pairs);
        builder.layer(low, 550.0 / (4.0 * low));
        builder.layer(high, 550.0 / (4.0 * high));
        builder.end_group();
        const double admittance = substrate * std::pow(low / high, 2 * pairs);
        const double expected = std::pow((1.0 - admittance) / (1.0 + admittance), 2);
        for (const Response& r : both(builder.take(), 0.0)) EXPECT_NEAR(r.reflectance(), expected, 1e-13) << pairs;
    }
}

TEST(Multilayer, BeyondTheCriticalAngleEverythingIsReflected) {
    for (const double theta_deg : {42.0, 60.0, 89.9}) {
        for (const Response& r : both(bare(1.52, 1.0), theta_deg)) expect_near(r, {1, 1, 0, 0}, 1e-15, "glass to air");
        for (const Response& r : both(coated(1.52, 2.4, 300.0, 1.0), theta_deg))
            expect_near(r, {1, 1, 0, 0}, 1e-14, "through a film that lets light pass");
    }
    for (const Response& r : both(bare(1.52, 1.0), 41.0)) EXPECT_LT(r.reflectance(), 0.7);
}

TEST(Multilayer, LightTunnelsThroughAThinGapOfAir) {
    // Frustrated total reflection, s: 1 / T = 1 + sinh^2(kappa d) ((q^2 + kappa^2) / (2 q kappa))^2 (the square barrier
    // of quantum mechanics; Landau & Lifshitz, volume 3, section 25, problem 2). R = 1 - T.
    const double n = 1.52, theta_deg = 50.0;
    const double q = n * std::cos(theta_deg * pi / 180.0);
    const double kappa = std::sqrt(std::pow(n * std::sin(theta_deg * pi / 180.0), 2) - 1.0);
    for (const double gap_nm : {10.0, 100.0, 500.0}) {
        const double sinh = std::sinh(2.0 * pi * kappa * gap_nm / 550.0);
        const double factor = (q * q + kappa * kappa) / (2.0 * q * kappa);
        const double passed = 1.0 / (1.0 + sinh * sinh * factor * factor);
        for (const Response& r : both(coated(n, 1.0, gap_nm, n), theta_deg)) {
            EXPECT_NEAR(r.transmittance_s, passed, 1e-14) << gap_nm;
            EXPECT_NEAR(r.reflectance_s, 1.0 - passed, 1e-14) << gap_nm;
        }
    }
}

TEST(Multilayer, AtNinetyDegreesEverythingIsReflected) {
    for (const Index& substrate : {Index(1.5), Index(RefractiveIndex(0.2, 3.4))}) {
        for (const Response& r : both(coated(1.0, 1.38, 100.0, substrate), 90.0))
            expect_near(r, {1, 1, 0, 0}, 1e-15, "");
    }
}

TEST(Multilayer, WhatHasNoThicknessOrNoContrastIsNotThere) {
    const Response without = fresnel(1.0, 1.52, 40.0);
    for (const Response& r : both(coated(1.0, 2.4, 0.0, 1.52), 40.0)) expect_near(r, without, 1e-15, "no thickness");
    for (const Response& r : both(coated(1.0, 1.52, 321.0, 1.52), 40.0)) expect_near(r, without, 1e-14, "substrate");
    for (const Response& r : both(coated(1.0, 1.0, 321.0, 1.52), 40.0)) expect_near(r, without, 1e-14, "air");
    for (const Response& r : both(coated(1.0, 1.0, 321.0, 1.0), 40.0)) expect_near(r, {0, 0, 1, 1}, 1e-15, "nothing");
}

TEST(Multilayer, AThickMetalIsItsSurface) {
    const RefractiveIndex silver(0.13, 3.4);
    for (const double theta_deg : {0.0, 60.0, 85.0}) {
        const Response face = fresnel(1.0, silver, theta_deg);
        for (const Response& r : both(coated(1.0, silver, 1e6, 1.5), theta_deg))
            expect_near(r, {face.reflectance_s, face.reflectance_p, 0.0, 0.0}, 1e-14, std::to_string(theta_deg));
    }
}

TEST(Multilayer, LightPassesAsMuchBackwardsAsForwards) {
    // Helmholtz reciprocity holds for what absorbs too (Born & Wolf, section 1.6.3, for the transmissivity).
    LayerSystemBuilder forwards(1.0, 1.0);
    forwards.layer(RefractiveIndex(0.13, 3.4), 20.0);
    forwards.layer(1.38, 90.0);
    forwards.layer(RefractiveIndex(2.0, 0.3), 70.0);
    LayerSystemBuilder backwards(1.0, 1.0);
    backwards.layer(RefractiveIndex(2.0, 0.3), 70.0);
    backwards.layer(1.38, 90.0);
    backwards.layer(RefractiveIndex(0.13, 3.4), 20.0);
    const auto there = both(forwards.take(), 35.0);
    const auto back = both(backwards.take(), 35.0);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(there[i].transmittance_s, back[i].transmittance_s, 1e-15);
        EXPECT_NEAR(there[i].transmittance_p, back[i].transmittance_p, 1e-15);
        EXPECT_GT(std::abs(there[i].reflectance() - back[i].reflectance()), 0.1) << "but does not reflect as much";
        EXPECT_LT(there[i].reflectance() + there[i].transmittance(), 0.9) << "for it absorbs";
    }
}

TEST(Multilayer, AnIncoherentPlateAddsIntensities) {
    // All bounces of a plate with faces of r and a passage of tau: R = r + (1 - r)^2 r tau^2 / (1 - r^2 tau^2),
    // T = (1 - r)^2 tau / (1 - r^2 tau^2) (Harbecke 1986, Appl. Phys. B 39, 165-170).
    const double wavelength_nm = 550.0;
    for (const double k : {0.0, 1e-6, 1e-5}) {
        const double thickness_nm = 1e6;
        LayerSystemBuilder builder(1.0, 1.0);
        builder.layer(RefractiveIndex(1.52, k), thickness_nm, true);
        const double r = fresnel(1.0, {1.52, k}, 0.0).reflectance();
        const double tau = std::exp(-4.0 * pi * k * thickness_nm / wavelength_nm);
        const double trapped = 1.0 - r * r * tau * tau;
        for (const Response& plate : both(builder.take(), 0.0)) {
            EXPECT_NEAR(plate.reflectance(), r + (1.0 - r) * (1.0 - r) * r * tau * tau / trapped, 1e-9) << k;
            EXPECT_NEAR(plate.transmittance(), (1.0 - r) * (1.0 - r) * tau / trapped, 1e-9) << k;
        }
    }
}

TEST(Multilayer, AnIncoherentPlateIsTheMeanOverThePhaseOfACoherentOne) {
    const double n = 2.4, theta_deg = 40.0, wavelength_nm = 550.0;
    const double cosine_1 = std::sqrt(1.0 - std::pow(std::sin(theta_deg * pi / 180.0) / n, 2));
    LayerSystemBuilder builder(1.0, 1.5);
    builder.layer(1.38, 90.0);
    builder.layer(n, 1e5, true);
    builder.layer(1.7, 60.0);
    Response mean;
    constexpr int phases = 64;  // a periodic function that is smooth: the trapezium rule is exact
    for (int i = 0; i < phases; ++i) {
        LayerSystemBuilder coherent(1.0, 1.5);
        coherent.layer(1.38, 90.0);
        coherent.layer(n, 1e5 + wavelength_nm / (2.0 * n * cosine_1) * i / phases);
        coherent.layer(1.7, 60.0);
        const Response r = both(coherent.take(), theta_deg).front();
        mean.reflectance_s += r.reflectance_s / phases;
        mean.reflectance_p += r.reflectance_p / phases;
        mean.transmittance_s += r.transmittance_s / phases;
        mean.transmittance_p += r.transmittance_p / phases;
    }
    for (const Response& r : both(builder.take(), theta_deg)) expect_near(r, mean, 1e-12, "mean");
}

TEST(Multilayer, AGroupIsWhatItStandsFor) {
    LayerSystemBuilder grouped(1.0, 1.5);
    LayerSystemBuilder written(1.0, 1.5);
    grouped.begin_group(7);
    for (int i = 0; i < 7; ++i) {
        written.layer(RefractiveIndex(1.56, 0.01), 94.0);
        for (int j = 0; j < 3; ++j) {
            written.layer(1.0, 50.0);
            written.layer(2.0, 20.0);
        }
    }
    grouped.layer(RefractiveIndex(1.56, 0.01), 94.0);
    grouped.begin_group(3);
    grouped.layer(1.0, 50.0);
    grouped.layer(2.0, 20.0);
    grouped.end_group();
    grouped.end_group();
    const LayerSystem group = grouped.take();
    const LayerSystem list = written.take();
    for (const double theta_deg : {0.0, 50.0, 88.0}) {
        const auto one = both(group, theta_deg);
        const auto other = both(list, theta_deg);
        for (std::size_t i = 0; i < 2; ++i) expect_near(one[i], other[i], 1e-12, std::to_string(theta_deg));
    }
}

// A stack of anything that a scene may hold.
LayerSystem random_system(std::mt19937& generator) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator);
    };
    const auto index = [&]() -> RefractiveIndex {
        const double n = uniform(0.3, 4.0);
        return {n, uniform(0.0, 1.0) < 0.6 ? 0.0 : std::exp(uniform(-9.0, 1.0))};
    };
    LayerSystemBuilder builder(uniform(1.0, 1.8), index());
    const int items = std::uniform_int_distribution<int>(1, 6)(generator);
    for (int i = 0; i < items; ++i) {
        const double kind = uniform(0.0, 1.0);
        if (kind < 0.5) {
            builder.layer(index(), uniform(0.0, 500.0));
        } else if (kind < 0.7) {
            builder.layer(index(), uniform(1e3, 1e5), true);
        } else {
            builder.begin_group(std::uniform_int_distribution<int>(1, 12)(generator));
            const int members = std::uniform_int_distribution<int>(1, 6)(generator);
            for (int j = 0; j < members; ++j) builder.layer(index(), uniform(0.0, 200.0));
            builder.end_group();
        }
    }
    return builder.take();
}

// Lets the dispatcher choose among these alone; 0 restores all.
void allow_instruction_sets(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(Multilayer, EveryInstructionSetGivesTheTwinsNumbers) {
    // In no order, and no multiple of any register.
    const std::vector<double> wavelengths_nm{700.0, 380.0, 555.5, 830.0, 360.0, 481.25,
                                             640.0, 399.9, 511.0, 777.0, 420.0};
    std::vector<Response> responses(wavelengths_nm.size());
    const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    ASSERT_GE(targets.size(), 1u);
    for (const std::int64_t target : targets) {
        allow_instruction_sets(target);
        std::mt19937 generator(11);
        for (int i = 0; i < 150; ++i) {
            const LayerSystem system = random_system(generator);
            const Incidence incidence =
                Incidence::from_degrees(std::uniform_real_distribution<double>(0.0, 89.0)(generator));
            const MultilayerSolver solver(system, wavelengths_nm);
            EXPECT_EQ(solver.count(), wavelengths_nm.size());
            EXPECT_GE(solver.padded_count(), solver.count());
            solver.responses(incidence, responses);
            double sum = 0.0;
            std::vector<double> weights(solver.padded_count(), 0.0);
            for (std::size_t j = 0; j < wavelengths_nm.size(); ++j) {
                const Response scalar = multilayer_response(system, incidence, wavelengths_nm[j]);
                // Up to 100 layers of a few roundings each, next to band edges up to a thousand times more.
                expect_near(responses[j], scalar, 1e-10,
                            std::string(hwy::TargetName(target)) + " " + std::to_string(i));
                weights[j] = 0.1 * static_cast<double>(j + 1);
                sum += weights[j] * scalar.reflectance();
            }
            std::vector<double> ones(solver.padded_count(), 0.0);
            ones[3] = 1.0;
            const std::vector<double> none(solver.padded_count(), 0.0);
            const auto sums = solver.weighted_reflectances(incidence, {weights.data(), ones.data(), none.data()});
            EXPECT_NEAR(sums[0], sum, 1e-9) << hwy::TargetName(target) << " " << i;
            EXPECT_NEAR(sums[1], responses[3].reflectance(), 1e-10) << hwy::TargetName(target) << " " << i;
            EXPECT_EQ(sums[2], 0.0);
            if (HasFailure()) break;
        }
    }
    allow_instruction_sets(0);
}

TEST(Multilayer, DispersionIsLookedUpAtEveryWavelength) {
    IndexCurve cauchy;
    cauchy.n = IndexFormula{5, {1.5, 0.01, -2.0}};
    const Index film(std::make_shared<const IndexCurve>(cauchy));
    const LayerSystem system = coated(1.0, film, 300.0, 1.0);
    const std::vector<double> wavelengths_nm{400.0, 500.0, 800.0};
    std::vector<Response> responses(3);
    MultilayerSolver(system, wavelengths_nm).responses(Incidence::from_degrees(30.0), responses);
    for (std::size_t i = 0; i < 3; ++i) {
        const double n = 1.5 + 0.01 / std::pow(1e-3 * wavelengths_nm[i], 2);
        const Response constant = solved(coated(1.0, n, 300.0, 1.0), 30.0, wavelengths_nm[i]);
        expect_near(responses[i], constant, 1e-14, std::to_string(wavelengths_nm[i]));
    }
}

}  // namespace
}  // namespace nacre
