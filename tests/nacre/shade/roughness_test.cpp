// The mean over GGX facets, against visible normals on a grid (tests/reference/facets.h), and where it is known.
#include "nacre/shade/roughness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <numbers>
#include <utility>
#include <vector>

#include "nacre/shade/facets.h"
#include "reference/facets.h"

namespace nacre {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;

constexpr std::array roughnesses{1e-4, 0.001, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0};
constexpr std::array angles_deg{0.0, 0.01, 1.0, 20.0, 45.0, 60.0, 80.0, 86.0, 89.0, 89.9, 90.0};

// Rippled, steep, and with a root at grazing.
std::array<double, 3> varied(double cos_theta) {
    return {0.5 + 0.5 * std::cos(12.0 * cos_theta), std::pow(1.0 - cos_theta, 5.0), std::sqrt(cos_theta)};
}

std::array<double, 3> mean_of(const std::vector<Facet>& facets) {
    std::array<double, 3> mean{};
    for (const Facet& facet : facets) {
        const std::array<double, 3> seen = varied(facet.cos_theta);
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += facet.share * seen[i];
    }
    return mean;
}

TEST(RoughFacets, AreAllThatIsSeen) {
    const RoughFacets facets;
    for (const double roughness : roughnesses) {
        for (const double theta_deg : angles_deg) {
            double sum = 0.0;
            for (const Facet& facet : facets.at(roughness, Incidence::from_degrees(theta_deg))) {
                EXPECT_GE(facet.cos_theta, 0.0);
                EXPECT_LE(facet.cos_theta, 1.0);
                EXPECT_GE(facet.share, 0.0);
                sum += facet.share;
            }
            // So a perfect reflector is white.
            EXPECT_NEAR(sum, 1.0, 1e-13) << roughness << " " << theta_deg;
        }
    }
}

TEST(RoughFacets, AgreeWithVisibleNormalsOnAGrid) {
    constexpr int side = 1000;
    const RoughFacets rough;
    double largest = 0.0;
    for (const double roughness : {0.02, 0.1, 0.3, 0.6, 1.0}) {
        for (const double theta_deg : {0.0, 20.0, 60.0, 80.0, 89.0, 90.0}) {
            std::array<double, 3> expected{};
            for (const reference::ModelFacet& facet : reference::rough_facets_seen(roughness, theta_deg, side)) {
                const std::array<double, 3> seen = varied(facet.cos_beta);
                for (std::size_t i = 0; i < seen.size(); ++i) expected[i] += facet.share * seen[i];
            }
            const std::array<double, 3> mean = mean_of(rough.at(roughness, Incidence::from_degrees(theta_deg)));
            for (std::size_t i = 0; i < mean.size(); ++i) {
                EXPECT_NEAR(mean[i], expected[i], 5e-5) << roughness << " " << theta_deg << " " << i;
                largest = std::max(largest, std::abs(mean[i] - expected[i]));
            }
        }
    }
    std::cout << "[ ROUGH    ] largest difference " << largest << "\n";
}

// Seen from above, facets are hidden from nobody, and the light that they mirror comes from twice their angle: one
// integral is left, here by Simpson's rule in an angle x, tan(tau) = alpha tan(x).
TEST(RoughFacets, SeenFromAboveAreOneIntegral) {
    constexpr int steps = 20000;
    const RoughFacets rough;
    for (const double roughness : {0.02, 0.2, 0.5, 0.8, 1.0}) {
        const double alpha = roughness * roughness;
        const double last = std::atan(1.0 / alpha);  // tau = 45 degrees: beyond, light comes from below
        std::array<double, 3> sum{};
        double whole = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double x = last * i / steps;
            const double slope = alpha * std::tan(x);
            const double cos_tau = 1.0 / std::sqrt(1.0 + slope * slope);
            const double cos_light = 2.0 * cos_tau * cos_tau - 1.0;
            const double tan_light = std::sqrt(1.0 - cos_light * cos_light) / cos_light;
            const double shaded = 0.5 * (std::sqrt(1.0 + alpha * alpha * tan_light * tan_light) - 1.0);
            // D cos(tau) dOmega = 2 sin(x) cos(x) dx; what is seen of a facet goes with cos(h, v) = cos(tau) too.
            const double weight = (i == 0 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * std::sin(2.0 * x) / (1.0 + shaded);
            whole += weight;
            const std::array<double, 3> seen = varied(cos_tau);
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * seen[k];
        }
        const std::array<double, 3> mean = mean_of(rough.at(roughness, Incidence::from_degrees(0.0)));
        for (std::size_t k = 0; k < sum.size(); ++k)
            EXPECT_NEAR(mean[k], sum[k] / whole, 2e-6) << roughness << " " << k;
    }
}

// What a renderer adds up that lights a Cook-Torrance surface from many directions: F D G / (4 cos(v) cos(l)), by
// light. Where the colour of a facet is F, the sum is the mean over facets times the same sum of a white metal.
TEST(RoughFacets, AreWhatARendererAddsUpUnderAnEvenSky) {
    constexpr int rings = 1500;
    constexpr int spokes = 1500;
    const RoughFacets rough;
    for (const auto& [roughness, theta_deg] : {std::pair{0.5, 10.0}, {0.5, 65.0}, {0.75, 40.0}, {1.0, 80.0}}) {
        const double alpha = roughness * roughness;
        const double eye_x = std::sin(theta_deg * rad_per_deg);
        const double eye_z = std::cos(theta_deg * rad_per_deg);
        std::array<double, 3> sum{};
        double white = 0.0;
        for (int ring = 0; ring < rings; ++ring) {
            const double light_z = (ring + 0.5) / rings;  // even in solid angle
            for (int spoke = 0; spoke < spokes; ++spoke) {
                const double turn = std::numbers::pi * (spoke + 0.5) / spokes;
                const double across = std::sqrt(1.0 - light_z * light_z);
                const double x = eye_x + across * std::cos(turn);
                const double y = across * std::sin(turn);
                const double z = eye_z + light_z;
                const double cos_facet = z / std::sqrt(x * x + y * y + z * z);
                const double cos_seen = std::sqrt(0.5 * (1.0 + eye_x * across * std::cos(turn) + eye_z * light_z));
                const double d = 1.0 + (alpha * alpha - 1.0) * cos_facet * cos_facet;
                const double density = alpha * alpha / (std::numbers::pi * d * d);
                // Filament's and Unreal's form of G / (4 cos(v) cos(l)).
                const double visible =
                    0.5 / (light_z * std::sqrt(eye_z * eye_z * (1.0 - alpha * alpha) + alpha * alpha) +
                           eye_z * std::sqrt(light_z * light_z * (1.0 - alpha * alpha) + alpha * alpha));
                const double weight = density * visible * light_z;
                white += weight;
                const std::array<double, 3> seen = varied(cos_seen);
                for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * seen[i];
            }
        }
        const std::array<double, 3> mean = mean_of(rough.at(roughness, Incidence::from_degrees(theta_deg)));
        for (std::size_t i = 0; i < sum.size(); ++i)
            EXPECT_NEAR(mean[i], sum[i] / white, 5e-5) << roughness << " " << theta_deg << " " << i;
    }
}

TEST(RoughFacets, OfHardlyAnyRoughnessAreAMirror) {
    const RoughFacets rough;
    for (const double roughness : {1e-300, 1e-12, 9e-5, 1e-3}) {
        for (const double theta_deg : angles_deg) {
            const Incidence incidence = Incidence::from_degrees(theta_deg);
            const std::array<double, 3> mean = mean_of(rough.at(roughness, incidence));
            const std::array<double, 3> meant = varied(incidence.cos_theta);
            // A root at grazing turns facets that lean by 1e-6 into 1e-3.
            const double near = theta_deg > 89.5 ? 2e-3 : 1e-5;
            for (std::size_t i = 0; i < mean.size(); ++i) EXPECT_NEAR(mean[i], meant[i], near) << theta_deg;
        }
    }
}

// A curve of many fringes, as thick films have them: its polynomials tell how finely the mean has to be taken.
TEST(RoughFacets, OfFringesAreAveragedAsFinelyAsTheseAre) {
    const auto fringes = [](double s) {
        const double value = 0.5 + 0.5 * std::cos(120.0 * s * s);
        return Xyz{value, value, value};
    };
    const auto difference = [](const Xyz& one, const Xyz& other) { return std::abs(one.y - other.y) / 1e-9; };
    FacetColours facets(XyzCurve(fringes, curve_borders({}), difference));
    std::uint64_t points = 0;
    for (const double roughness : {0.01, 0.05, 0.2, 0.6}) {
        for (const double theta_deg : {0.0, 30.0, 75.0, 88.0}) {
            double expected = 0.0;
            for (const reference::ModelFacet& facet : reference::rough_facets_seen(roughness, theta_deg, 1500))
                expected += facet.share * fringes(std::sqrt(facet.cos_beta)).y;
            EXPECT_NEAR(facets.mean({0.0, roughness}, Incidence::from_degrees(theta_deg), points).y, expected, 2e-4)
                << roughness << " " << theta_deg;
        }
    }
    EXPECT_GT(points, 0u);
}

}  // namespace
}  // namespace nacre
