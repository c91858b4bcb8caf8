#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

#include "nacre/optics/multilayer/multilayer.h"

namespace nacre {
namespace {

using Complex = std::complex<double>;

RefractiveIndex mixture(const Index& one, const Index& other, double share, Mixing mixing) {
    LayerSystemBuilder builder(1.0, 1.5);
    builder.graded_layer(one, other, share, 10.0, mixing);
    const LayerSystem system = builder.take();
    return system.index_at(system.nodes[0].medium, 550.0);
}

LayerSystem mixed_film(const Index& one, const Index& other, double share, Mixing mixing, double thickness_nm) {
    LayerSystemBuilder builder(1.0, 1.52);
    builder.graded_layer(one, other, share, thickness_nm, mixing);
    return builder.take();
}

LayerSystem film(const Index& index, double thickness_nm) {
    LayerSystemBuilder builder(1.0, 1.52);
    builder.layer(index, thickness_nm);
    return builder.take();
}

Response solved(const LayerSystem& system, double theta_deg, double wavelength_nm) {
    Response response;
    MultilayerSolver(system, {&wavelength_nm, 1}).responses(Incidence::from_degrees(theta_deg), {&response, 1});
    return response;
}

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

TEST(Mixing, SquaresOfIndicesAreMixedAndTheRootDoesNotAmplify) {
    // (1 + 7) / 2 = 2^2.
    EXPECT_NEAR(mixture(1.0, std::sqrt(7.0), 0.5, Mixing::permittivity).real(), 2.0, 1e-15);
    EXPECT_EQ(mixture(1.0, std::sqrt(7.0), 0.5, Mixing::permittivity).imag(), 0.0) << "lossless stays lossless";
    EXPECT_NEAR(mixture(1.0, 3.0, 0.5, Mixing::index).real(), 2.0, 1e-15);
    // (2 + i)^2 = 3 + 4i; half of it and of 1 is 2 + 2i, of size r, whose root is sqrt((r + 2) / 2) + i sqrt((r - 2) /
    // 2).
    const RefractiveIndex half = mixture(1.0, RefractiveIndex(2.0, 1.0), 0.5, Mixing::permittivity);
    const double size = std::sqrt(8.0);
    EXPECT_NEAR(half.real(), std::sqrt((size + 2.0) / 2.0), 1e-15);
    EXPECT_NEAR(half.imag(), std::sqrt((size - 2.0) / 2.0), 1e-15);
    // A metal without losses: -9 and 1 in equal shares, -4.
    const RefractiveIndex metal = mixture(1.0, RefractiveIndex(0.0, 3.0), 0.5, Mixing::permittivity);
    EXPECT_NEAR(metal.real(), 0.0, 1e-15);
    EXPECT_NEAR(metal.imag(), 2.0, 1e-15);
}

TEST(Mixing, AllOfOneIsThatOneWhicheverIsMixed) {
    const Index one = 1.37;
    const Index other = RefractiveIndex(2.1, 0.4);
    for (const Mixing mixing : {Mixing::index, Mixing::permittivity}) {
        EXPECT_EQ(mixture(one, other, 0.0, mixing), one.constant);
        EXPECT_EQ(mixture(one, other, 1.0, mixing), other.constant);
    }
}

TEST(Mixing, IndicesAndPermittivitiesAreDifferentMedia) {
    LayerSystemBuilder builder(1.0, 1.5);
    builder.graded_layer(1.0, 2.0, 0.5, 10.0, Mixing::index);
    builder.graded_layer(1.0, 2.0, 0.5, 10.0, Mixing::permittivity);
    builder.graded_layer(1.0, 2.0, 0.5, 10.0, Mixing::permittivity);
    builder.graded_layer(1.0, 2.0, 0.5, 10.0);
    const LayerSystem system = builder.take();
    EXPECT_NE(system.nodes[0].medium, system.nodes[1].medium);
    EXPECT_EQ(system.nodes[1].medium, system.nodes[2].medium);
    EXPECT_EQ(system.nodes[0].medium, system.nodes[3].medium) << "the index, unless said otherwise";
}

TEST(Mixing, AMixtureReflectsAsAMaterialOfItsIndex) {
    const std::array<Index, 4> others{Index(2.4), Index(RefractiveIndex(1.8, 1e-3)), Index(RefractiveIndex(0.06, 4.0)),
                                      Index(RefractiveIndex(3.5, 2.0))};
    for (const Index& other : others) {
        for (const double share : {0.01, 0.3, 0.9}) {
            const Complex square =
                (1.0 - share) * 1.33 * 1.33 + share * other.constant * other.constant;  // and its root by its angle
            const Index index = std::polar(std::sqrt(std::abs(square)), 0.5 * std::arg(square));
            for (const double theta_deg : {0.0, 40.0, 85.0}) {
                const Response expected = both(film(index, 140.0), theta_deg).front();
                const LayerSystem mixed = mixed_film(1.33, other, share, Mixing::permittivity, 140.0);
                // A rounding of the permittivity, in films whose fields decay by up to e^6.
                for (const Response& r : both(mixed, theta_deg))
                    expect_near(r, expected, 1e-13, std::to_string(share) + " " + std::to_string(theta_deg));
            }
        }
    }
}

// Rytov 1956, Sov. Phys. JETP 2, 466: layers much thinner than the wavelength have the mean permittivity for fields
// along them; what is left falls with the square of the period.
TEST(Mixing, FineLayersAreAMixtureOfPermittivitiesForFieldsAlongThem) {
    for (const Index& other : {Index(2.4), Index(RefractiveIndex(2.0, 0.3)), Index(RefractiveIndex(0.1, 3.0))}) {
        const double thickness_nm = 200.0, share = 0.35;
        const auto fine = [&](int periods) {
            LayerSystemBuilder builder(1.0, 1.52);
            builder.begin_group(periods);
            builder.layer(1.33, 0.5 * (1.0 - share) * thickness_nm / periods);
            builder.layer(other, share * thickness_nm / periods);
            builder.layer(1.33, 0.5 * (1.0 - share) * thickness_nm / periods);
            builder.end_group();
            return builder.take();
        };
        const LayerSystem mixed = mixed_film(1.33, other, share, Mixing::permittivity, thickness_nm);
        for (const double theta_deg : {0.0, 60.0}) {
            const double limit = solved(mixed, theta_deg, 550.0).reflectance_s;
            const double coarse_error = std::abs(solved(fine(250), theta_deg, 550.0).reflectance_s - limit);
            const double fine_error = std::abs(solved(fine(2000), theta_deg, 550.0).reflectance_s - limit);
            EXPECT_LT(coarse_error, 3e-5);
            EXPECT_LT(fine_error, coarse_error / 50.0 + 1e-12) << "8^2 would be 64";
        }
        const double other_way =
            solved(mixed_film(1.33, other, share, Mixing::index, thickness_nm), 0.0, 550.0).reflectance_s;
        EXPECT_GT(std::abs(other_way - solved(mixed, 0.0, 550.0).reflectance_s), 1e-3) << "the test can tell";
    }
}

// Lets the dispatcher choose among these alone; 0 restores all.
void allow_instruction_sets(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

// Glasses, absorbers, metals, and dispersion.
Index random_index(std::mt19937& generator) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator);
    };
    const double kind = uniform(0.0, 1.0);
    if (kind < 0.4) return uniform(1.0, 3.0);
    if (kind < 0.6) return RefractiveIndex(uniform(0.3, 4.0), std::exp(uniform(-9.0, 1.0)));
    if (kind < 0.8) return RefractiveIndex(uniform(0.05, 0.5), uniform(2.0, 5.0));
    IndexCurve cauchy;
    cauchy.n = IndexFormula{5, {uniform(1.3, 2.0), 0.01, -2.0}};
    return Index(std::make_shared<const IndexCurve>(cauchy));
}

LayerSystem random_gradients(std::mt19937& generator, int slices) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator);
    };
    LayerSystemBuilder builder(uniform(1.0, 1.6), random_index(generator));
    for (int gradients = std::uniform_int_distribution<int>(1, 3)(generator); gradients > 0; --gradients) {
        const Index from = random_index(generator), to = random_index(generator);
        const Mixing mixing = uniform(0.0, 1.0) < 0.8 ? Mixing::permittivity : Mixing::index;
        builder.begin_group(std::uniform_int_distribution<int>(1, 5)(generator));
        for (int i = 0; i < slices; ++i)
            builder.graded_layer(from, to, uniform(0.0, 1.0), uniform(0.0, 100.0 / slices), mixing);
        builder.end_group();
    }
    return builder.take();
}

TEST(Mixing, EveryInstructionSetGivesTheTwinsNumbers) {
    const std::vector<double> wavelengths_nm{700.0, 380.0, 555.5, 830.0, 360.0, 481.25, 640.0, 399.9, 511.0};
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        allow_instruction_sets(target);
        std::mt19937 generator(21);
        for (int i = 0; i < 150; ++i) {
            // Up to 300 media: more than the solver keeps at hand.
            const LayerSystem system = random_gradients(generator, i % 30 == 0 ? 100 : 1 + i % 9);
            const Incidence incidence =
                Incidence::from_degrees(std::uniform_real_distribution<double>(0.0, 89.0)(generator));
            std::vector<Response> responses(wavelengths_nm.size());
            MultilayerSolver(system, wavelengths_nm).responses(incidence, responses);
            for (std::size_t j = 0; j < responses.size(); ++j) {
                const Response scalar = multilayer_response(system, incidence, wavelengths_nm[j]);
                // A rounding of each index; next to poles of p, where a permittivity is near 0, a thousand times more.
                expect_near(responses[j], scalar, 1e-10,
                            std::string(hwy::TargetName(target)) + " " + std::to_string(i));
            }
            if (HasFailure()) break;
        }
    }
    allow_instruction_sets(0);
}

// A metal and air whose permittivities nearly cancel: neither's index says how small their mixture's is. Fields of p
// grow by its inverse in every period, some 1e11 here, and would overflow if that were not seen coming.
TEST(Mixing, NextToNoPermittivityNothingOverflows) {
    const Incidence incidence = Incidence::from_degrees(30.0);
    const std::vector<double> wavelengths_nm{550.0};
    // Whatever overflows does so some time before fields are brought back to size: every number of periods.
    for (int periods = 1; periods <= 60; ++periods) {
        LayerSystemBuilder builder(1.0, 1.52);
        for (int i = 0; i < periods; ++i) {
            builder.graded_layer(1.0, RefractiveIndex(1e-12, 3.0), 0.1, 10.0, Mixing::permittivity);
            builder.layer(2.0, 50.0);
        }
        const LayerSystem system = builder.take();
        const MultilayerSolver solver(system, wavelengths_nm);
        const Response scalar = multilayer_response(system, incidence, wavelengths_nm[0]);
        Response response;
        solver.responses(incidence, {&response, 1});
        // The permittivity that is left, 6e-13, is known to a part in a thousand, but hardly any light gets past it.
        expect_near(response, scalar, 1e-9, std::to_string(periods));
        EXPECT_GT(scalar.reflectance_p, 0.99) << periods;
        std::vector<double> one(solver.padded_count(), 0.0);
        one[0] = 1.0;
        const std::array<const double*, 3> weights{one.data(), one.data(), one.data()};
        EXPECT_NEAR(solver.weighted_reflectances(incidence, weights)[0], scalar.reflectance(), 1e-9) << periods;
        EXPECT_NEAR(solver.weighted_reflectances(incidence, weights, Polarisation::p)[0], scalar.reflectance_p, 1e-9)
            << periods;
    }
}

}  // namespace
}  // namespace nacre
