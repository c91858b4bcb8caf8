#include "nacre/colour/spectral_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <string>

#include "nacre/colour/illuminant.h"

namespace nacre {
namespace {

constexpr double pi = std::numbers::pi;
using Curve = std::function<double(double nm)>;

TristimulusWeights weights_of(std::string_view illuminant = "D65", int first_nm = 360, int last_nm = 830) {
    return make_tristimulus_weights(Observer::cie1931_2deg, *illuminant_by_name(illuminant), first_nm, last_nm);
}

// The second road: within every nanometre weights are linear, and the rest is smooth, so Gauss-Legendre with five nodes
// (Abramowitz & Stegun, table 25.4) on `parts` parts of it.
Xyz dense_integral(const TristimulusWeights& weights, const Curve& curve, int parts) {
    constexpr double at[] = {-0.906179845938663993, -0.538469310105683091, 0.0, 0.538469310105683091,
                             0.906179845938663993};
    constexpr double share[] = {0.236926885056189088, 0.478628670499366468, 0.568888888888888889, 0.478628670499366468,
                                0.236926885056189088};
    Xyz sum;
    for (int cell = 0; cell + 1 < weights.count(); ++cell) {
        const auto i = static_cast<std::size_t>(cell);
        for (int part = 0; part < parts; ++part) {
            for (int node = 0; node < 5; ++node) {
                const double along = (part + 0.5 + 0.5 * at[node]) / parts;
                const double r = 0.5 * share[node] / parts * curve(weights.first_nm + cell + along);
                sum.x += r * std::lerp(weights.x[i], weights.x[i + 1], along);
                sum.y += r * std::lerp(weights.y[i], weights.y[i + 1], along);
                sum.z += r * std::lerp(weights.z[i], weights.z[i + 1], along);
            }
        }
    }
    return sum;
}

Xyz sum_over(const SpectralNodes& nodes, const Curve& curve) {
    Xyz sum;
    for (std::size_t i = 0; i < nodes.wavelength_nm.size(); ++i) {
        const double r = curve(nodes.wavelength_nm[i]);
        sum.x += r * nodes.x[i];
        sum.y += r * nodes.y[i];
        sum.z += r * nodes.z[i];
    }
    return sum;
}

double distance(const Xyz& a, const Xyz& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

// Fringes of two beams whose paths differ.
Curve fringes(double path_nm) {
    return [path_nm](double nm) { return 0.5 + 0.5 * std::cos(2.0 * pi * path_nm / nm); };
}

// How many of them lie in a range.
double fringe_count(double path_nm, const TristimulusWeights& weights) {
    return path_nm * (1.0 / weights.first_nm - 1.0 / weights.last_nm);
}

TEST(SpectralNodes, WhiteIsExact) {
    for (const char* illuminant : {"D65", "A", "FL11"}) {
        for (const auto& [first_nm, last_nm] : {std::pair{360, 830}, {380, 780}, {500, 501}}) {
            const TristimulusWeights weights = weights_of(illuminant, first_nm, last_nm);
            // A wavenumber range of 1 nm is known to 1e-13 of its width.
            const double tolerance = last_nm - first_nm == 1 ? 1e-12 : 1e-13;
            for (const int count : {8, 16, 192, 193, 1000}) {
                const Xyz white = sum_over(make_spectral_nodes(weights, count), [](double) { return 1.0; });
                EXPECT_NEAR(white.y, 1.0, tolerance) << illuminant << " " << first_nm << " " << count;
                EXPECT_LT(distance(white, weights.white), tolerance) << illuminant << " " << first_nm << " " << count;
            }
        }
    }
}

TEST(SpectralNodes, LieWithinTheRangeAndArePaddedToARegister) {
    const TristimulusWeights weights = weights_of("D65", 380, 780);
    for (const int count : {2, 7, 8, 192, 193, 577}) {
        const SpectralNodes nodes = make_spectral_nodes(weights, count);
        EXPECT_EQ(nodes.count, count);
        EXPECT_EQ(nodes.wavelength_nm.size(), static_cast<std::size_t>(count));
        const std::set<double> different(nodes.wavelength_nm.begin(), nodes.wavelength_nm.end());
        EXPECT_EQ(different.size(), nodes.wavelength_nm.size());
        EXPECT_GT(*different.begin(), 380.0);
        EXPECT_LT(*different.rbegin(), 780.0);
        for (const auto* list : {&nodes.x, &nodes.y, &nodes.z}) {
            EXPECT_EQ(list->size() % SpectralNodes::padding, 0u);
            ASSERT_GE(list->size(), nodes.wavelength_nm.size());
            for (std::size_t i = nodes.wavelength_nm.size(); i < list->size(); ++i) EXPECT_EQ((*list)[i], 0.0);
        }
    }
}

TEST(SpectralNodes, PolynomialsInTheWavenumberAreExactUpToTheNumberOfNodes) {
    for (const char* illuminant : {"D65", "FL11"}) {
        const TristimulusWeights weights = weights_of(illuminant);
        const double low = 1.0 / 830.0, high = 1.0 / 360.0;
        for (const int count : {2, 5, 16, 64}) {
            const SpectralNodes nodes = make_spectral_nodes(weights, count);
            for (const int degree : {0, 1, count / 2, count - 1}) {
                const Curve power = [&](double nm) {
                    return std::pow((2.0 / nm - (low + high)) / (high - low), degree);
                };
                // Moments by four nodes per 1.5 of phase: 1e-10 of the weight that a panel's narrowest parts have.
                EXPECT_LT(distance(sum_over(nodes, power), dense_integral(weights, power, 4)), 1e-11)
                    << illuminant << " " << count << " " << degree;
            }
            const Curve one_more = [&](double nm) {
                return std::cos(count * std::acos((2.0 / nm - (low + high)) / (high - low)));
            };
            // That polynomial is 0 at all nodes.
            EXPECT_LT(distance(sum_over(nodes, one_more), {}), 1e-12);
            EXPECT_GT(distance(dense_integral(weights, one_more, 4), {}), 1e-7) << illuminant << " " << count;
        }
    }
}

TEST(SpectralNodes, FringesNeedLittleMoreThanPiNodesEach) {
    for (const char* illuminant : {"D65", "FL11", "A"}) {
        for (const auto& [first_nm, last_nm] : {std::pair{360, 830}, {380, 780}}) {
            const TristimulusWeights weights = weights_of(illuminant, first_nm, last_nm);
            for (const double path_nm : {300.0, 3000.0, 20000.0}) {
                const Curve curve = fringes(path_nm);
                const Xyz exact = dense_integral(weights, curve, 2);
                const int count = 24 + static_cast<int>(1.1 * pi * fringe_count(path_nm, weights));
                // Bessel functions J_n(pi F) fall faster than exponentially beyond n = pi F: 1e-10 is far behind that.
                EXPECT_LT(distance(sum_over(make_spectral_nodes(weights, count), curve), exact), 1e-9)
                    << illuminant << " " << first_nm << " " << path_nm;
            }
        }
    }
}

TEST(SpectralNodes, OneNodePerFringeIsNotEnoughAndTheErrorFallsWithEveryStep) {
    const TristimulusWeights weights = weights_of();
    const Curve curve = fringes(20000.0);  // 31 fringes
    const Xyz exact = dense_integral(weights, curve, 2);
    const auto error = [&](int count) { return distance(sum_over(make_spectral_nodes(weights, count), curve), exact); };
    EXPECT_GT(error(31), 1e-3);
    const double at_96 = error(96);
    const double at_112 = error(112);
    const double at_128 = error(128);
    EXPECT_LT(at_112, 0.1 * at_96);
    EXPECT_LT(at_128, 0.1 * at_112);
}

TEST(SpectralNodes, MoreThanOnePanelHoldsIsSpreadOverSeveral) {
    for (const char* illuminant : {"D65", "FL11"}) {
        const TristimulusWeights weights = weights_of(illuminant);
        for (const double path_nm : {20000.0, 150000.0, 600000.0}) {
            const Curve curve = fringes(path_nm);
            const double count = fringe_count(path_nm, weights);
            const Xyz exact = dense_integral(weights, curve, 4 + static_cast<int>(path_nm / 50000.0));
            const int nodes = std::max(most_nodes_of_one_panel + 1, static_cast<int>(5.0 * count));
            EXPECT_GT(nodes, most_nodes_of_one_panel);
            EXPECT_LT(distance(sum_over(make_spectral_nodes(weights, nodes), curve), exact), 1e-9)
                << illuminant << " " << path_nm;
        }
    }
}

TEST(SpectralNodes, OnAGridAreTheGridsOwnSum) {
    const TristimulusWeights weights = weights_of("FL11", 380, 780);
    for (const int count : {2, 41, 400, 401, 4001}) {
        const WavelengthGrid grid{380.0, 780.0, count};
        const GridWeights grid_weights = make_grid_weights(weights, grid);
        const SpectralNodes nodes = make_spectral_nodes(grid_weights, grid);
        EXPECT_EQ(nodes.count, count);
        const Curve curve = fringes(3000.0);
        Spectrum spectrum{grid, {}};
        for (int i = 0; i < count; ++i) spectrum.value.push_back(curve(grid.wavelength_nm(i)));
        EXPECT_LT(distance(sum_over(nodes, curve), to_xyz(grid_weights, spectrum)), 1e-14) << count;
        EXPECT_EQ(nodes.x.size() % SpectralNodes::padding, 0u);
        EXPECT_LT(distance(sum_over(nodes, [](double) { return 1.0; }), grid_weights.white), 1e-14) << count;
    }
}

}  // namespace
}  // namespace nacre
