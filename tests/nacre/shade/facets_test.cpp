// The mean over facets, against Monte Carlo and against an integral around the eye (tests/reference/facets.h).
#include "nacre/shade/facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "reference/facets.h"

namespace nacre {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;

// Exact to 1e-13 for what is smooth.
XyzCurve curve_of(const std::function<Xyz(double cos_theta)>& colour, std::vector<double> borders = {}) {
    const auto difference = [](const Xyz& one, const Xyz& other) {
        return std::max({std::abs(one.x - other.x), std::abs(one.y - other.y), std::abs(one.z - other.z)}) / 1e-12;
    };
    return XyzCurve([&](double s) { return colour(s * s); }, curve_borders(std::move(borders)), difference);
}

// Smooth, steep and rippled.
Xyz varied(double cos_theta) {
    return {0.3 + 0.5 * cos_theta, std::pow(1.0 - cos_theta, 5.0), 0.5 + 0.5 * std::cos(9.0 * cos_theta)};
}

double largest_distance(const Xyz& one, const Xyz& other) {
    return std::max({std::abs(one.x - other.x), std::abs(one.y - other.y), std::abs(one.z - other.z)});
}

constexpr std::array tilts_deg{0.01, 0.1, 0.29, 0.31, 1.0, 5.0, 15.0, 30.0, 60.0};
constexpr std::array angles_deg{0.0, 0.5, 20.0, 45.0, 70.0, 85.0, 89.0, 89.9, 90.0};

TEST(VisibleFacets, AreAllThatIsSeen) {
    for (const double tilt_deg : tilts_deg) {
        for (const double theta_deg : angles_deg) {
            double sum = 0.0;
            for (const Facet& facet : tilted_facets(tilt_deg, Incidence::from_degrees(theta_deg))) {
                EXPECT_GE(facet.cos_theta, 0.0);
                EXPECT_LE(facet.cos_theta, 1.0);
                EXPECT_GE(facet.share, 0.0);
                sum += facet.share;
            }
            EXPECT_NEAR(sum, 1.0, 1e-13) << tilt_deg << " " << theta_deg;
        }
    }
}

TEST(FacetColours, OfOneColourHaveThatColour) {
    FacetColours facets(curve_of([](double) { return Xyz{0.2, 0.7, 1.1}; }));
    std::uint64_t points = 0;
    for (const double tilt_deg : tilts_deg) {
        for (const double theta_deg : angles_deg) {
            const Xyz mean = facets.mean({tilt_deg}, Incidence::from_degrees(theta_deg), points);
            // At grazing a series in Legendre polynomials is a small difference of larger terms.
            EXPECT_LT(largest_distance(mean, {0.2, 0.7, 1.1}), 1e-9) << tilt_deg << " " << theta_deg;
        }
    }
    EXPECT_GT(points, 0u);
}

TEST(FacetColours, AgreeWithAnIntegralAroundTheEye) {
    const XyzCurve colour = curve_of(varied);
    FacetColours facets(colour);
    std::uint64_t points = 0;
    for (const double tilt_deg : tilts_deg) {
        for (const double theta_deg : angles_deg) {
            Xyz expected;
            for (const reference::ModelFacet& facet : reference::facets_seen(tilt_deg, theta_deg)) {
                const Xyz seen = varied(facet.cos_beta);
                expected = {expected.x + facet.share * seen.x, expected.y + facet.share * seen.y,
                            expected.z + facet.share * seen.z};
            }
            const Incidence incidence = Incidence::from_degrees(theta_deg);
            const Xyz mean = facets.mean({tilt_deg}, incidence, points);
            // The reference's midpoints meet the edge of facets at right angles: 2e-5 of tilts beyond 15 degrees.
            EXPECT_LT(largest_distance(mean, expected), 5e-5) << tilt_deg << " " << theta_deg;
            const Xyz summed = mean_over_facets(tilted_facets(tilt_deg, incidence, {48, 96}), colour, points);
            EXPECT_LT(largest_distance(summed, expected), 5e-5) << tilt_deg << " " << theta_deg;
        }
    }
}

// Normals drawn from the density and weighted by what is seen of them.
TEST(FacetColours, AgreeWithMonteCarlo) {
    constexpr int samples = 200000;
    FacetColours facets(curve_of(varied));
    std::uint64_t points = 0;
    std::mt19937_64 generator(20261122);
    const auto unit = [&] { return static_cast<double>(generator() >> 11U) * 0x1p-53; };
    for (const double tilt_deg : {0.2, 3.0, 25.0, 60.0}) {
        for (const double theta_deg : {0.0, 40.0, 80.0, 90.0}) {
            const double tilt = tilt_deg * rad_per_deg;
            const double theta = theta_deg * rad_per_deg;
            std::array<double, 3> sum{};
            std::array<double, 3> squares{};
            double visible = 0.0;
            for (int i = 0; i < samples; ++i) {
                // tau exp(-tau^2 / (2 tilt^2)) is Rayleigh's distribution; sin(tau) / tau is left as a weight.
                const double tau = tilt * std::sqrt(-2.0 * std::log1p(-unit()));
                const double around = 2.0 * std::numbers::pi * unit();
                if (tau >= 0.5 * std::numbers::pi) continue;
                const double cosine =
                    std::cos(theta) * std::cos(tau) + std::sin(theta) * std::sin(tau) * std::cos(around);
                if (cosine <= 0.0) continue;
                const double weight = cosine * (tau > 0.0 ? std::sin(tau) / tau : 1.0);
                const Xyz seen = varied(std::min(cosine, 1.0));
                visible += weight;
                const std::array<double, 3> parts{seen.x, seen.y, seen.z};
                for (std::size_t c = 0; c < 3; ++c) {
                    sum[c] += weight * parts[c];
                    squares[c] += weight * weight * parts[c] * parts[c];
                }
            }
            const Xyz mean = facets.mean({tilt_deg}, Incidence::from_degrees(theta_deg), points);
            const std::array<double, 3> means{mean.x, mean.y, mean.z};
            for (std::size_t c = 0; c < 3; ++c) {
                // Five standard deviations of the sum, which is more than the ratio's.
                EXPECT_NEAR(sum[c] / visible, means[c], 5.0 * std::sqrt(squares[c]) / visible + 1e-9)
                    << tilt_deg << " " << theta_deg << " " << c;
            }
        }
    }
}

// Seen from above a little tilt is a blur of variance tilt^2 along each of two directions: the mean of cos^n differs
// from 1 by (n / 2) 2 tilt^2, weights included.
TEST(FacetColours, OfALittleTiltDifferByTheSquareOfIt) {
    FacetColours facets(curve_of([](double c) { return Xyz{c, c * c, c * c * c}; }));
    std::uint64_t points = 0;
    for (const double tilt_deg : {0.05, 0.2, 0.5, 1.0}) {
        const double square = tilt_deg * rad_per_deg * tilt_deg * rad_per_deg;
        const Xyz mean = facets.mean({tilt_deg}, Incidence::from_degrees(0.0), points);
        // Higher powers; and what the sum over a few rings errs by, where there is no series.
        const double left =
            20.0 * square * square + (tilt_deg < FacetColours::least_blurred_deg ? 3e-4 * square : 1e-9);
        EXPECT_NEAR(mean.x, 1.0 - square, left);
        EXPECT_NEAR(mean.y, 1.0 - 2.0 * square, 2.0 * left);
        EXPECT_NEAR(mean.z, 1.0 - 3.0 * square, 3.0 * left);
    }
}

// What is seen along the surface are the facets turned to the eye: of those, by a Gaussian of slopes, the mean cosine
// is tilt * sqrt(pi / 2): the mean of x^2 over that of x, both for x > 0.
TEST(FacetColours, AlongTheSurfaceAreTurnedToTheEye) {
    FacetColours facets(curve_of([](double c) { return Xyz{c, c, c}; }));
    std::uint64_t points = 0;
    for (const double tilt_deg : {0.02, 0.1, 0.28, 0.5, 1.0}) {
        const double tilt = tilt_deg * rad_per_deg;
        const Xyz mean = facets.mean({tilt_deg}, Incidence::from_degrees(90.0), points);
        const double expected = tilt * std::sqrt(std::numbers::pi / 2.0);
        // Beyond slopes come squares of the tilt. A sum over a few rings errs by 4e-4, of a cosine that is some 1e-3.
        const double rule = tilt_deg < FacetColours::least_blurred_deg ? 5e-4 : 1e-6;
        EXPECT_NEAR(mean.y / expected, 1.0, rule + 3.0 * tilt * tilt) << tilt_deg;
    }
}

TEST(FacetColours, StayBetweenTheDarkestAndTheBrightest) {
    // A bend, as where total reflection begins.
    const auto bent = [](double c) {
        const double y = c < 0.6 ? 1.0 : 1.0 - 0.9 * std::sqrt((c - 0.6) / 0.4);
        return Xyz{y, y, y};
    };
    FacetColours facets(curve_of(bent, {std::sqrt(0.6)}));
    std::uint64_t points = 0;
    for (const double tilt_deg : tilts_deg) {
        for (const double theta_deg : angles_deg) {
            const double y = facets.mean({tilt_deg}, Incidence::from_degrees(theta_deg), points).y;
            EXPECT_LE(y, 1.0 + 1e-6) << tilt_deg << " " << theta_deg;
            EXPECT_GE(y, 0.1 - 1e-6) << tilt_deg << " " << theta_deg;
        }
    }
}

}  // namespace
}  // namespace nacre
