// The reference model of all mechanisms is judged before it judges: by 50 digits, by another model, by the energy that
// has to be left, and by a printed table.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "reference/exact_mie.h"
#include "reference/layers.h"
#include "reference/model.h"
#include "reference/spheres.h"

namespace nacre::reference {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;

TEST(ReferenceSpheres, AreThoseOfFiftyDigits) {
    for (const double x : {0.3, 1.0, 3.7, 9.0}) {
        for (const std::complex<double> m : {std::complex<double>(0.75), {1.5, 0.0}, {1.4, 0.05}, {2.2, 0.4}}) {
            const ModelSphere sphere = model_sphere(x, m);
            const ExactMie exact = exact_mie(x, m);
            EXPECT_LT(relative_distance(sphere.q_sca, exact.q_sca), 1e-9) << x << m;
            EXPECT_LT(relative_distance(sphere.q_ext, exact.q_ext), 1e-9) << x << m;
            for (const double cosine : {1.0, 0.4, -0.2, -1.0}) {
                const auto [s1, s2] = sphere.amplitudes(cosine);
                const ExactAmplitudes amplitudes = exact_amplitudes(exact, cosine);
                const double scale = std::abs(sphere.amplitudes(1.0).s1);
                EXPECT_LT(distance(s1.real(), amplitudes.s1.real()), 1e-9 * scale) << x << m << cosine;
                EXPECT_LT(distance(s2.imag(), amplitudes.s2.imag()), 1e-9 * scale) << x << m << cosine;
            }
        }
    }
}

// Two-ports that are composed from above, and Rouard's way from the substrate up.
TEST(ReferenceLayers, AreTheSameFromAboveAndFromBelow) {
    Stack stack;
    stack.incident = 1.0;
    stack.substrate = RefractiveIndex(0.4, 2.5);
    for (const auto& [index, thickness_nm] :
         {std::pair<RefractiveIndex, double>{1.38, 95.0}, {{1.9, 0.05}, 60.0}, {2.3, 140.0}}) {
        Layer layer;
        layer.index = index;
        layer.thickness_nm = thickness_nm;
        stack.layers.push_back(layer);
    }
    for (const double theta_deg : {0.0, 40.0, 75.0, 89.0}) {
        for (const double nm : {400.0, 555.0, 780.0}) {
            const double cos_theta = std::cos(theta_deg * rad_per_deg);
            double of_ports = 0.0;
            for (const bool is_p : {false, true})
                of_ports += 0.5 * layer_powers(stack, {1.0, cos_theta, is_p}, nm).reflectance;
            EXPECT_NEAR(of_ports, reflectance(stack, cos_theta, nm), 1e-12);
        }
    }
}

// What is not reflected passes; along one path as much passes down as up; beyond an incoherent layer, too.
TEST(ReferenceLayers, LoseNoLight) {
    Stack stack;
    stack.incident = 1.0;
    stack.substrate = 1.6;
    for (const auto& [n, thickness_nm] : {std::pair{2.3, 60.0}, std::pair{1.5, 1e6}, std::pair{1.8, 110.0}}) {
        Layer layer;
        layer.index = n;
        layer.thickness_nm = thickness_nm;
        layer.is_incoherent = thickness_nm > 1e5;
        stack.layers.push_back(layer);
    }
    Crystal crystal;
    crystal.sphere = 1.45;
    crystal.medium = 1.0;
    crystal.planes = 11;
    crystal.substrate = 1.4;
    for (const Mechanism& mechanism : {Mechanism(stack), Mechanism(crystal)}) {
        for (const double sine : {0.0, 0.5, 0.95}) {
            for (const bool is_p : {false, true}) {
                const auto powers = layer_powers(mechanism, {1.0, std::sqrt(1.0 - sine * sine), is_p}, 555.0);
                EXPECT_NEAR(powers.reflectance + powers.transmittance, 1.0, 1e-11);
                EXPECT_NEAR(powers.reflectance_below + powers.transmittance_below, 1.0, 1e-11);
                EXPECT_NEAR(powers.transmittance, powers.transmittance_below, 1e-11);
            }
        }
    }
}

// Judd 1942, J. Res. NBS 29, 329, table 1: of light that comes evenly from all directions a face of 1.5 reflects 0.0918
// from outside, so that from inside 1 - (1 - 0.0918) / 1.5^2 are.
TEST(ReferenceBase, BelowGlassIsAsInJuddsTable) {
    Mechanism glass = Film{1.0, 1.5, 100.0, 1.5, 0.0};
    glass.effects.base = GreyBase{0.5};
    const double inside = 1.0 - (1.0 - 0.0918) / 2.25;
    EXPECT_NEAR(base_factor(glass, 555.0), 0.5 * (1.0 - inside) / (1.0 - 0.5 * inside), 1e-4);
}

}  // namespace
}  // namespace nacre::reference
