#include "nacre/optics/crystal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "nacre/optics/multilayer/multilayer.h"

namespace nacre {
namespace {

constexpr double pi = std::numbers::pi;

Crystal crystal_of(const Index& sphere, const Index& medium, double spacing_nm = 0.0) {
    Crystal crystal;
    crystal.sphere = sphere;
    crystal.medium = medium;
    crystal.diameter_nm = 270.0;
    crystal.spacing_nm = spacing_nm;
    crystal.planes = 60;
    return crystal;
}

// Of the slices of one period, in the order in which light meets them: by their permittivity.
std::vector<double> shares_of(const Crystal& crystal, int slices) {
    const LayerSystem system = layer_system(crystal, slices);
    const auto square = [](RefractiveIndex n) { return (n * n).real(); };
    const double medium = square(crystal.medium.constant), sphere = square(crystal.sphere.constant);
    std::vector<double> shares;
    for (const LayerNode& node : system.nodes) {
        if (node.repeat > 0) continue;
        shares.push_back((square(system.index_at(node.medium, 550.0)) - medium) / (sphere - medium));
    }
    return shares;
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

TEST(Crystal, TouchingSpheresFillPiOverTheRootOfEighteen) {
    // Gauss 1831: the densest packing. The layers hold as much, however many there are.
    const Crystal crystal = crystal_of(1.45, 1.0);
    EXPECT_NEAR(plane_spacing_nm(crystal), 270.0 * std::sqrt(2.0 / 3.0), 1e-12);
    for (const int slices : {4, 8, 12, 32, 100})
        EXPECT_NEAR(mean(shares_of(crystal, slices)), pi / std::sqrt(18.0), 1e-14) << slices;
    const double n2 = 1.0 + pi / std::sqrt(18.0) * (1.45 * 1.45 - 1.0);
    EXPECT_NEAR(effective_index(crystal, 550.0).real(), std::sqrt(n2), 1e-15);
}

TEST(Crystal, PlanesFurtherApartHoldLess) {
    // A sphere over its cell, whatever the distance; beyond a diameter there is nothing between planes.
    for (const double spacing_nm : {230.0, 260.0, 300.0, 500.0}) {
        const Crystal crystal = crystal_of(1.45, 1.0, spacing_nm);
        const double cell = 0.5 * std::sqrt(3.0) * 270.0 * 270.0 * spacing_nm;
        for (const int slices : {8, 12}) {
            EXPECT_NEAR(mean(shares_of(crystal, slices)), pi / 6.0 * std::pow(270.0, 3) / cell, 1e-14)
                << spacing_nm << " " << slices;
        }
    }
    const std::vector<double> shares = shares_of(crystal_of(1.45, 1.0, 500.0), 20);
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 0.0);
}

// Whether a point is in a sphere of a face-centred cubic packing: planes A, B and C of hexagonal lattices.
bool is_in_packing(double x_nm, double y_nm, double z_nm, double diameter_nm, double spacing_nm) {
    for (int plane = -3; plane <= 3; ++plane) {
        const double across = static_cast<double>(((plane % 3) + 3) % 3);
        const double origin_x = across * 0.5 * diameter_nm, origin_y = across * diameter_nm / (2.0 * std::sqrt(3.0));
        for (int row = -5; row <= 5; ++row) {
            for (int column = -7; column <= 7; ++column) {
                const double x = x_nm - origin_x - (column + 0.5 * row) * diameter_nm;
                const double y = y_nm - origin_y - row * 0.5 * std::sqrt(3.0) * diameter_nm;
                const double z = z_nm - plane * spacing_nm;
                if (x * x + y * y + z * z < 0.25 * diameter_nm * diameter_nm) return true;
            }
        }
    }
    return false;
}

TEST(Crystal, ShareIsWhatPointsOfThePackingAreInSpheres) {
    for (const double spacing_nm : {0.0, 240.0}) {
        const Crystal crystal = crystal_of(1.45, 1.0, spacing_nm);
        for (const double z_share : {0.0, 0.2, 0.42, 0.5, 0.77}) {
            const double z_nm = z_share * plane_spacing_nm(crystal);
            constexpr int points = 120;
            int inside = 0;
            for (int i = 0; i < points; ++i) {
                for (int j = 0; j < points; ++j) {
                    // A cell of the lattice.
                    const double a = (i + 0.5) / points, b = (j + 0.5) / points;
                    const double x_nm = 270.0 * (a + 0.5 * b), y_nm = 270.0 * 0.5 * std::sqrt(3.0) * b;
                    inside += is_in_packing(x_nm, y_nm, z_nm, 270.0, plane_spacing_nm(crystal));
                }
            }
            // Points along the circles' edges, some 4 of 120 across: a few of them are on the wrong side.
            EXPECT_NEAR(sphere_share(crystal, z_nm), inside / static_cast<double>(points * points), 3e-3) << z_share;
        }
    }
}

TEST(Crystal, ProfileRepeatsAndIsTheSameUpwardsAndDownwards) {
    for (const double spacing_nm : {0.0, 90.0, 150.0, 400.0}) {
        const Crystal crystal = crystal_of(1.45, 1.0, spacing_nm);
        const double period_nm = plane_spacing_nm(crystal);
        for (const double z_nm : {0.0, 13.0, 77.0, 110.0}) {
            EXPECT_NEAR(sphere_share(crystal, z_nm), sphere_share(crystal, -z_nm), 1e-14);
            EXPECT_NEAR(sphere_share(crystal, z_nm), sphere_share(crystal, z_nm + 3.0 * period_nm), 1e-12);
            EXPECT_LE(sphere_share(crystal, z_nm), 1.0);
        }
        const LayerSystem system = layer_system(crystal, 12);
        ASSERT_EQ(system.nodes.size(), 13u);
        EXPECT_EQ(system.nodes[0].repeat, 60);
        for (std::size_t i = 1; i <= 12; ++i) EXPECT_EQ(system.nodes[i], system.nodes[13 - i]) << i;
    }
    // The largest circle of touching spheres: of a hexagonal packing of discs.
    EXPECT_NEAR(sphere_share(crystal_of(1.45, 1.0), 0.0), pi / std::sqrt(12.0), 1e-15);
}

TEST(Crystal, WhatOverlapsFillsAtMostEverything) {
    for (const double spacing_nm : {40.0, 120.0, 145.0, 170.0, 190.0}) {
        const Crystal crystal = crystal_of(1.45, 1.0, spacing_nm);
        // Two slices have one mean.
        const int pairs = 10;
        const std::vector<double> shares = shares_of(crystal, 2 * pairs);
        bool is_full_somewhere = false;
        for (int i = 0; i < pairs; ++i) {
            constexpr int points = 4000;
            double sum = 0.0;
            for (int j = 0; j < points; ++j) {
                const double z_nm = spacing_nm * ((i + (j + 0.5) / points) / pairs - 0.5);
                sum += sphere_share(crystal, z_nm) / points;
                is_full_somewhere = is_full_somewhere || sphere_share(crystal, z_nm) == 1.0;
            }
            // The midpoint rule, with a bend or two: a part in 4000, squared.
            const auto first = 2 * static_cast<std::size_t>(i);
            EXPECT_NEAR(0.5 * (shares[first] + shares[first + 1]), sum, 3e-8) << spacing_nm << " " << i;
            for (const double share : {shares[first], shares[first + 1]}) {
                EXPECT_GE(share, 0.0);
                EXPECT_LE(share, 1.0);
            }
        }
        EXPECT_EQ(is_full_somewhere, spacing_nm < 180.0);
    }
}

TEST(Crystal, WithoutContrastItIsASlab) {
    Crystal crystal = crystal_of(1.4, 1.4);
    crystal.planes = 7;
    crystal.substrate = 1.7;
    LayerSystemBuilder slab(1.0, 1.7);
    slab.layer(1.4, 7.0 * plane_spacing_nm(crystal));
    const LayerSystem slab_system = slab.take();
    for (const double theta_deg : {0.0, 35.0, 80.0}) {
        const Incidence incidence = Incidence::from_degrees(theta_deg);
        const Response one = multilayer_response(layer_system(crystal, 12), incidence, 550.0);
        const Response other = multilayer_response(slab_system, incidence, 550.0);
        EXPECT_NEAR(one.reflectance_s, other.reflectance_s, 1e-13) << theta_deg;
        EXPECT_NEAR(one.reflectance_p, other.reflectance_p, 1e-13) << theta_deg;
    }
}

double response_of(const Response& response, bool is_p) {
    return is_p ? response.reflectance_p : response.reflectance_s;
}

// The middle of the first stop band, as wavelengths at half of its height.
double band_centre_nm(const Crystal& crystal, int slices, double theta_deg, double expected_nm, bool is_p) {
    std::vector<double> wavelengths_nm;
    for (int i = 0; i <= 4000; ++i) wavelengths_nm.push_back(expected_nm * (0.8 + 0.4 * i / 4000.0));
    std::vector<Response> responses(wavelengths_nm.size());
    MultilayerSolver(layer_system(crystal, slices), wavelengths_nm)
        .responses(Incidence::from_degrees(theta_deg), responses);
    std::size_t highest = 0;
    for (std::size_t i = 0; i < responses.size(); ++i)
        if (response_of(responses[i], is_p) > response_of(responses[highest], is_p)) highest = i;
    const double half = 0.5 * response_of(responses[highest], is_p);
    std::size_t first = highest, last = highest;
    while (first > 0 && response_of(responses[first], is_p) > half) --first;
    while (last + 1 < responses.size() && response_of(responses[last], is_p) > half) ++last;
    EXPECT_TRUE(first > 0 && last + 1 < responses.size()) << "the band is all there";
    return 0.5 * (wavelengths_nm[first] + wavelengths_nm[last]);
}

double bragg_snell_nm(const Crystal& crystal, double theta_deg) {
    const double sine = std::sin(theta_deg * pi / 180.0);
    const double n = effective_index(crystal, 550.0).real();
    return 2.0 * plane_spacing_nm(crystal) * std::sqrt(n * n - sine * sine);
}

TEST(Crystal, ReflectsWhereBraggAndSnellSay) {
    struct Case {
        const char* name;
        double sphere, medium;
        double p_tolerance;  // within a slice of p, E across it feels 1 / permittivity: more so at more contrast
    };
    for (const Case& c : {Case{"opal", 1.45, 1.0, 0.005}, Case{"inverse opal", 1.0, 1.55, 0.012},
                          Case{"inverse opal of titania", 1.0, 2.2, 0.02}}) {
        const Crystal crystal = crystal_of(c.sphere, c.medium);
        for (const double theta_deg : {0.0, 15.0, 30.0, 45.0, 60.0}) {
            const double expected_nm = bragg_snell_nm(crystal, theta_deg);
            const std::string what = std::string(c.name) + " " + std::to_string(theta_deg);
            EXPECT_NEAR(band_centre_nm(crystal, 32, theta_deg, expected_nm, false), expected_nm, 0.006 * expected_nm)
                << what;
            EXPECT_NEAR(band_centre_nm(crystal, 32, theta_deg, expected_nm, true), expected_nm,
                        c.p_tolerance * expected_nm)
                << what;
        }
    }
}

TEST(Crystal, OfLittleContrastReflectsAsCoupledWavesDo) {
    // Kogelnik 1969, Bell Syst. Tech. J. 48, 2909: at the Bragg wavelength R = tanh^2(kappa L), kappa = pi e / (lambda
    // n) with e the first Fourier coefficient of the permittivity: the form factor of a sphere (Rayleigh 1914).
    Crystal crystal = crystal_of(1.50, 1.49);
    const double radius_nm = 135.0, spacing_nm = plane_spacing_nm(crystal);
    const double q = 2.0 * pi / spacing_nm, qr = q * radius_nm;
    const double form = pi * 4.0 * (std::sin(qr) - qr * std::cos(qr)) / (q * q * q);
    const double coefficient = (1.50 * 1.50 - 1.49 * 1.49) * form / (0.5 * std::sqrt(3.0) * 270.0 * 270.0 * spacing_nm);
    const double n = effective_index(crystal, 550.0).real();
    crystal.incident = crystal.substrate = n;
    for (const int planes : {50, 200, 400}) {
        crystal.planes = planes;
        const double wavelength_nm = 2.0 * spacing_nm * n;
        const double expected = std::pow(std::tanh(pi * coefficient / (wavelength_nm * n) * planes * spacing_nm), 2);
        // Second order in the contrast of 1.3 %.
        EXPECT_NEAR(
            multilayer_response(layer_system(crystal, 64), Incidence::from_degrees(0.0), wavelength_nm).reflectance_s,
            expected, 0.01 * expected)
            << planes;
    }
}

TEST(Crystal, ConvergesFasterThanWithTheSquareOfASlice) {
    Crystal crystal = crystal_of(1.45, 1.0);
    crystal.planes = 20;
    const auto reflectance = [&](int slices) {
        std::vector<double> wavelengths_nm;
        for (int i = 0; i < 64; ++i) wavelengths_nm.push_back(420.0 + 5.0 * i);
        std::vector<Response> responses(64);
        MultilayerSolver(layer_system(crystal, slices), wavelengths_nm)
            .responses(Incidence::from_degrees(25.0), responses);
        return responses;
    };
    const std::vector<Response> limit = reflectance(512);
    const auto worst = [&](int slices) {
        const std::vector<Response> responses = reflectance(slices);
        double largest = 0.0;
        for (std::size_t i = 0; i < responses.size(); ++i)
            largest = std::max(largest, std::abs(responses[i].reflectance() - limit[i].reflectance()));
        return largest;
    };
    EXPECT_LT(worst(8), 0.05);
    EXPECT_LT(worst(32), worst(8) / 32.0);
    EXPECT_LT(worst(128), worst(8) / 1000.0);
}

TEST(Crystal, AbsorbingSpheresHaveAnAbsorbingMean) {
    const Crystal crystal = crystal_of(RefractiveIndex(1.6, 0.05), 1.0);
    const RefractiveIndex n = effective_index(crystal, 550.0);
    const RefractiveIndex n2 =
        1.0 + pi / std::sqrt(18.0) * (RefractiveIndex(1.6, 0.05) * RefractiveIndex(1.6, 0.05) - 1.0);
    EXPECT_GT(n.imag(), 0.0);
    EXPECT_NEAR(std::abs(n * n - n2), 0.0, 1e-14);
    const Response r = multilayer_response(layer_system(crystal, 16), Incidence::from_degrees(20.0), 500.0);
    EXPECT_LT(r.reflectance() + r.transmittance(), 0.9);
}

}  // namespace
}  // namespace nacre
