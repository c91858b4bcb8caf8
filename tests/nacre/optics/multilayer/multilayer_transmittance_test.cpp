// Transmittance: what is not reflected, where nothing absorbs; and the textbook's, where there is one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "nacre/optics/crystal.h"
#include "nacre/optics/multilayer/multilayer.h"

namespace nacre {
namespace {

using Complex = std::complex<double>;

// In no order, and no multiple of any register.
const std::vector<double> wavelengths_nm{700.0, 380.0, 555.5, 830.0, 481.25};

class RandomSystem {
public:
    RandomSystem(unsigned number, bool is_lossless) : generator_(number), is_lossless_(is_lossless) {}

    /// Layers that are even, graded, incoherent or evanescent, groups and groups within groups, and crystals.
    LayerSystem system() {
        if (uniform(0.0, 1.0) < 0.03) return crystal();
        const double incident = uniform(1.0, 2.2);
        // A third lies between equal media.
        LayerSystemBuilder builder(incident, uniform(0.0, 1.0) < 0.33 ? RefractiveIndex(incident) : index());
        for (int items = whole(0, 6); items > 0; --items) {
            const double kind = uniform(0.0, 1.0);
            if (kind < 0.4) {
                builder.layer(index(), uniform(0.0, 500.0));
            } else if (kind < 0.5) {
                const Index from = index(), to = index();
                for (int slice = 0; slice < 8; ++slice)
                    builder.graded_layer(from, to, slice / 7.0, 20.0,
                                         slice % 2 == 0 ? Mixing::index : Mixing::permittivity);
            } else if (kind < 0.6) {
                builder.layer(index(), uniform(1e3, 1e5), true);
            } else {
                group(builder, kind > 0.8);
            }
        }
        return builder.take();
    }

    Incidence incidence() {
        return uniform(0.0, 1.0) < 0.2 ? Incidence::from_degrees(uniform(80.0, 89.9))
                                       : Incidence::from_degrees(uniform(0.0, 80.0));
    }

private:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }
    RefractiveIndex index() {
        const double n = uniform(1.0, 3.0);
        return {n, is_lossless_ ? 0.0 : std::exp(uniform(-9.0, 1.0))};
    }
    void group(LayerSystemBuilder& builder, bool holds_a_group) {
        builder.begin_group(whole(1, 12));
        for (int members = whole(1, 6); members > 0; --members) builder.layer(index(), uniform(0.0, 200.0));
        if (holds_a_group) {
            builder.begin_group(3);
            builder.layer(index(), 30.0);
            builder.end_group();
        }
        builder.end_group();
    }
    LayerSystem crystal() {
        Crystal crystal;
        crystal.sphere = index();
        crystal.medium = index();
        crystal.planes = whole(1, 12);
        crystal.substrate = index();
        return layer_system(crystal, 12);
    }

    std::mt19937 generator_;
    bool is_lossless_;
};

TEST(Transmittance, IsWhatTenThousandLosslessStacksDoNotReflect) {
    std::size_t through = 0, dark = 0;
    for (unsigned number = 0; number < 10000; ++number) {
        RandomSystem random(number, true);
        const LayerSystem system = random.system();
        const Incidence incidence = random.incidence();
        std::vector<Response> responses(wavelengths_nm.size());
        MultilayerSolver(system, wavelengths_nm).responses(incidence, responses);
        responses.push_back(multilayer_response(system, incidence, wavelengths_nm.front()));
        for (const Response& r : responses) {
            ASSERT_NEAR(r.reflectance_s + r.transmittance_s, 1.0, 1e-12) << number << ", " << incidence.theta_deg;
            ASSERT_NEAR(r.reflectance_p + r.transmittance_p, 1.0, 1e-12) << number << ", " << incidence.theta_deg;
            through += r.transmittance() > 0.1 ? 1 : 0;
            dark += r.transmittance() == 0.0 ? 1 : 0;
        }
    }
    EXPECT_GT(through, 20000u);  // of 60 000
    EXPECT_GT(dark, 1000u) << "some reflect totally";
}

TEST(Transmittance, OfAbsorbingStacksIsNeverMoreThanWhatTheyDoNotReflect) {
    for (unsigned number = 0; number < 10000; ++number) {
        RandomSystem random(number, false);
        const LayerSystem system = random.system();
        const Incidence incidence = random.incidence();
        std::vector<Response> responses(wavelengths_nm.size());
        MultilayerSolver(system, wavelengths_nm).responses(incidence, responses);
        for (const Response& r : responses) {
            ASSERT_GE(std::min(r.transmittance_s, r.transmittance_p), 0.0);
            ASSERT_LE(r.reflectance_s + r.transmittance_s, 1.0 + 1e-12) << number << ", " << incidence.theta_deg;
            ASSERT_LE(r.reflectance_p + r.transmittance_p, 1.0 + 1e-12) << number << ", " << incidence.theta_deg;
        }
    }
}

// Fresnel's amplitudes, and what enters the medium below: Re(n2 cos2) / (n1 cos1) |t_s|^2 and
// Re(n2 conj(cos2)) / (n1 cos1) |t_p|^2 (Born & Wolf, Principles of Optics, sections 1.5 and 14.2).
TEST(Transmittance, OfABareSurfaceIsFresnels) {
    for (const Complex n : {Complex(1.5), Complex(2.4), Complex(0.15, 3.5), Complex(1.8, 0.3)}) {
        const LayerSystem bare = LayerSystemBuilder(1.0, n).take();
        for (const double theta_deg : {0.0, 30.0, 56.3, 80.0, 89.0}) {
            const Incidence incidence = Incidence::from_degrees(theta_deg);
            const double cos1 = incidence.cos_theta;
            const double sin1 = std::sin(theta_deg * std::numbers::pi / 180.0);
            const Complex cos2 = std::sqrt(1.0 - sin1 * sin1 / (n * n));
            const Complex t_s = 2.0 * cos1 / (cos1 + n * cos2), t_p = 2.0 * cos1 / (n * cos1 + cos2);
            const Response r = multilayer_response(bare, incidence, 550.0);
            EXPECT_NEAR(r.transmittance_s, (n * cos2).real() / cos1 * std::norm(t_s), 1e-14);
            EXPECT_NEAR(r.transmittance_p, (n * std::conj(cos2)).real() / cos1 * std::norm(t_p), 1e-14);
            EXPECT_NEAR(r.transmittance_s + r.reflectance_s, 1.0, 1e-14) << "all that enters counts, absorbed or not";
        }
    }
}

// T = 1 / (1 + F sin^2(delta / 2)), F = 4 R / (1 - R)^2, of a plate between equal media (Airy 1833; Born & Wolf,
// section 7.6.1).
TEST(Transmittance, OfAFreeFilmIsAirys) {
    constexpr double n = 1.7, thickness_nm = 430.0;
    LayerSystemBuilder builder(1.0, 1.0);
    builder.layer(n, thickness_nm);
    const LayerSystem film = builder.take();
    for (const double theta_deg : {0.0, 35.0, 70.0, 88.0}) {
        const double cos1 = std::cos(theta_deg * std::numbers::pi / 180.0);
        const double cos2 = std::sqrt(1.0 - (1.0 - cos1 * cos1) / (n * n));
        for (const double nm : wavelengths_nm) {
            const double half_delta = 2.0 * std::numbers::pi * n * thickness_nm * cos2 / nm;
            const auto airy = [&](double r) {
                const double finesse = 4.0 * r * r / ((1.0 - r * r) * (1.0 - r * r));
                return 1.0 / (1.0 + finesse * std::pow(std::sin(half_delta), 2.0));
            };
            const Response seen = multilayer_response(film, Incidence::from_degrees(theta_deg), nm);
            EXPECT_NEAR(seen.transmittance_s, airy((cos1 - n * cos2) / (cos1 + n * cos2)), 1e-12);
            EXPECT_NEAR(seen.transmittance_p, airy((n * cos1 - cos2) / (n * cos1 + cos2)), 1e-12);
        }
    }
}

TEST(Transmittance, SumsOverWavelengthsAreThoseOfTheSpectrum) {
    for (unsigned number = 0; number < 300; ++number) {
        RandomSystem random(number, number % 2 == 0);
        const LayerSystem system = random.system();
        const Incidence incidence = random.incidence();
        const MultilayerSolver solver(system, wavelengths_nm);
        std::vector<Response> responses(wavelengths_nm.size());
        solver.responses(incidence, responses);
        std::vector<double> rising(solver.padded_count(), 0.0), second(solver.padded_count(), 0.0);
        for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) rising[i] = static_cast<double>(i + 1);
        second[1] = 1.0;
        for (const Polarisation polarisation : {Polarisation::mean, Polarisation::s, Polarisation::p}) {
            for (const Observed observed : {Observed::reflectance, Observed::transmittance}) {
                const auto sums =
                    solver.weighted(incidence, {rising.data(), second.data(), second.data()}, observed, polarisation);
                double sum = 0.0;
                for (std::size_t i = 0; i < wavelengths_nm.size(); ++i)
                    sum += rising[i] * observed_of(responses[i], observed, polarisation);
                EXPECT_NEAR(sums[0], sum, 1e-12) << number;
                EXPECT_NEAR(sums[1], observed_of(responses[1], observed, polarisation), 1e-12) << number;
            }
        }
    }
}

}  // namespace
}  // namespace nacre
