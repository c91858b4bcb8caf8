#include "nacre/optics/grating.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

#include "reference/number.h"

namespace nacre {
namespace {

constexpr double pi = std::numbers::pi;
using reference::Number;

Grating ruled(GratingProfile profile, double depth_nm) {
    Grating grating;
    grating.profile = profile;
    grating.depth_nm = depth_nm;
    return grating;
}

std::vector<int> orders_up_to(int last) {
    std::vector<int> orders(static_cast<std::size_t>(last) + 1);
    std::iota(orders.begin(), orders.end(), 0);
    return orders;
}

TEST(Grating, LightOfASinusoidalProfileIsTheSquareOfABesselFunction) {
    // Depths from none to the deepest that a scene may have (1e5 nm at 360 nm: J_m(1745)).
    for (const double depth_nm : {1e-12, 1e-9, 1e-3, 1.0, 40.0, 140.0, 333.3, 1000.0, 6000.0, 1e5}) {
        const Grating grating = ruled(GratingProfile::sinusoidal, depth_nm);
        const double z = 2.0 * pi * depth_nm / 400.0;
        const std::vector<int> orders{0, 1, 2, 3, 7, 20, 100, 200, 1500, 1700, 3000};
        std::vector<double> efficiency(orders.size());
        grating_efficiencies(grating, orders, 400.0, efficiency);
        for (std::size_t i = 0; i < orders.size(); ++i) {
            // At the very double that the profile sees: near a zero of J_m the last bit of z would count.
            const Number bessel = boost::math::cyl_bessel_j(orders[i], Number(z));
            // J_m J_m' < 1 / z, so a z that is off by some 2^-53 z moves the square by 1e-16; the sums add as much.
            EXPECT_LT(reference::distance(efficiency[i], bessel * bessel), 4e-15) << depth_nm << ' ' << orders[i];
            // Alone an order's recurrence starts elsewhere, and rounds otherwise.
            EXPECT_NEAR(efficiency[i], grating_efficiency(grating, orders[i], 400.0), 4e-15) << orders[i];
            // Where the order is far beyond the argument nothing oscillates and every digit is there; the smallest
            // numbers may vanish.
            if (orders[i] > 1.5 * z + 5 && bessel > 1e-100) {
                EXPECT_LT(reference::relative_distance(efficiency[i], bessel * bessel), 1e-12) << orders[i];
            }
        }
    }
}

TEST(Grating, OrdersAreTheFourierSeriesOfThePhaseOverAPeriod) {
    // Second road: |1/n sum of exp(i (phase(x) - 2 pi m x))|^2; the rule of equal steps converges exponentially for the
    // sinusoidal profile. The lamellar one is cut where it jumps.
    for (const double depth_nm : {50.0, 125.0, 700.0}) {
        const double wavelength_nm = 543.21;
        const double phi = 4.0 * pi * depth_nm / wavelength_nm;
        Grating sinusoidal = ruled(GratingProfile::sinusoidal, depth_nm);
        Grating lamellar = ruled(GratingProfile::lamellar, depth_nm);
        lamellar.land = 0.37;
        for (int m = -9; m <= 9; ++m) {
            std::complex<double> sum;
            constexpr int steps = 256;
            for (int k = 0; k < steps; ++k) {
                const double angle = 2.0 * pi * k / steps;
                sum += std::polar(1.0 / steps, 0.5 * phi * std::sin(angle) - m * angle);
            }
            EXPECT_NEAR(grating_efficiency(sinusoidal, m, wavelength_nm), std::norm(sum), 1e-14) << m;
            const auto stretch = [&](double from, double to, double phase) {
                std::complex<double> part;
                for (int k = 0; k < 8; ++k) {
                    const auto wave = [&](double x) { return std::polar(1.0, phase - 2.0 * pi * m * x); };
                    const double a = from + (to - from) * k / 8, b = from + (to - from) * (k + 1) / 8;
                    using Rule = boost::math::quadrature::gauss<double, 15>;
                    part += std::complex<double>(Rule::integrate([&](double x) { return wave(x).real(); }, a, b),
                                                 Rule::integrate([&](double x) { return wave(x).imag(); }, a, b));
                }
                return part;
            };
            const double expected = std::norm(stretch(0.0, 0.37, phi) + stretch(0.37, 1.0, 0.0));
            EXPECT_NEAR(grating_efficiency(lamellar, m, wavelength_nm), expected, 1e-14) << m;
        }
    }
}

TEST(Grating, AllOrdersTogetherHaveAllTheLight) {
    for (const double depth_nm : {0.0, 30.0, 120.0, 5000.0}) {
        const std::vector<int> orders = orders_up_to(2000);
        std::vector<double> efficiency(orders.size());
        const auto sum = [&](const Grating& grating) {
            grating_efficiencies(grating, orders, 480.0, efficiency);
            return 2.0 * std::accumulate(efficiency.begin(), efficiency.end(), 0.0) - efficiency.front();
        };
        // J_m(z) vanishes beyond z = 65; 4001 numbers are summed.
        EXPECT_NEAR(sum(ruled(GratingProfile::sinusoidal, depth_nm)), 1.0, 1e-13);
        Grating lamellar = ruled(GratingProfile::lamellar, depth_nm);
        for (const double land : {0.0, 0.1, 0.5, 0.77, 1.0}) {
            lamellar.land = land;
            // The tail of 4 sin^2(pi m D) / (pi m)^2 on both sides is at most 8 / (pi^2 2000).
            EXPECT_NEAR(sum(lamellar), 1.0, 8.0 / (pi * pi * 2000.0)) << land;
            EXPECT_LE(sum(lamellar), 1.0 + 1e-13) << land;
        }
    }
}

TEST(Grating, LamellarOfEqualLandAndGrooveHasNoEvenOrders) {
    const Grating grating = ruled(GratingProfile::lamellar, 100.0);
    for (int m = 2; m < 5000; m += 2) EXPECT_EQ(grating_efficiency(grating, m, 500.0), 0.0) << m;
}

TEST(Grating, QuarterWaveDepthSendsNoLightStraightBack) {
    // Depth = wavelength / 4: land and groove are half a wave out of step.
    EXPECT_NEAR(grating_efficiency(ruled(GratingProfile::lamellar, 125.0), 0, 500.0), 0.0, 1e-15);
    // The first order of a binary phase grating: (2 / pi)^2 = 40.5 %, the textbook's number.
    EXPECT_NEAR(grating_efficiency(ruled(GratingProfile::lamellar, 125.0), 1, 500.0), 4.0 / (pi * pi), 1e-15);
}

TEST(Grating, CoatTakesItsShareOfEveryOrder) {
    Grating grating = ruled(GratingProfile::sinusoidal, 80.0);
    const double bare = grating_efficiency(grating, 1, 600.0);
    grating.coat = Index(RefractiveIndex{0.25, 3.1});
    const double reflectance = (0.75 * 0.75 + 3.1 * 3.1) / (1.25 * 1.25 + 3.1 * 3.1);
    EXPECT_NEAR(coat_reflectance(grating, 600.0), reflectance, 2e-16);
    EXPECT_NEAR(grating_efficiency(grating, 1, 600.0), reflectance * bare, 1e-16);
}

TEST(Grating, GivenEfficienciesAreTakenAndTheRestGoesStraightBack) {
    Grating grating = ruled(GratingProfile::given, 0.0);
    grating.efficiency = {0.25, 0.125};
    EXPECT_EQ(grating_efficiency(grating, 1, 500.0), 0.25);
    EXPECT_EQ(grating_efficiency(grating, -2, 500.0), 0.125);
    EXPECT_EQ(grating_efficiency(grating, 3, 500.0), 0.0);
    EXPECT_EQ(grating_efficiency(grating, 0, 500.0), 0.25);
}

TEST(Grating, OrdersThatNoAngleShowsDoNotCount) {
    Grating grating;
    EXPECT_EQ(counted_orders(grating, 400.0), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));  // 2 * 1600 / 400, just
    EXPECT_EQ(largest_visible_order(grating, 400.1), 7);
    grating.orders = {0, 2, 7, 9};
    EXPECT_EQ(counted_orders(grating, 400.1), (std::vector<int>{0, 2, 7}));
    grating.period_nm = 100.0;
    EXPECT_EQ(counted_orders(grating, 400.0), (std::vector<int>{0}));
}

TEST(Grating, EqualOrdersMakeTheArrayFactorOfTheGrooves) {
    // Sum over all m of N sinc^2(N (x - m)) = sin^2(pi N x) / (N sin^2(pi x)) (Fejer's kernel).
    constexpr int last = 20000;
    Grating grating = ruled(GratingProfile::given, 0.0);
    grating.efficiency.assign(last, 0.5 / (2 * last + 1));
    const double share = grating.efficiency.front();
    // Order 0 has what the others leave: the same. 1 - 2 sum rounds some 20000 times.
    ASSERT_NEAR(grating_efficiency(grating, 0, 500.0), 0.5 + 0.5 / (2 * last + 1), 1e-12);
    std::vector<int> orders = orders_up_to(last);
    orders.erase(orders.begin());
    for (const int grooves : {1, 2, 7, 100}) {
        grating.grooves = grooves;
        grating.period_nm = 1000.0;
        for (const double u : {0.05, 0.31, 0.77, 1.303, 1.999}) {
            const double x = 2.0 * u;  // in orders, at 500 nm
            const double wave = std::sin(pi * grooves * x);
            const double zeroth = wave * wave / (pi * pi * grooves * x * x);
            const double sine = std::sin(pi * x);
            const double sum = grating_density(grating, orders, u, 500.0) / (2.0 * share) + zeroth;
            // Orders beyond 20000: below 2 / (pi^2 N 20000).
            EXPECT_NEAR(sum, wave * wave / (grooves * sine * sine), 1.1e-5 / grooves) << grooves << ' ' << u;
        }
    }
}

TEST(Grating, EveryOrderSpreadsItsEfficiencyOverU) {
    Grating grating = ruled(GratingProfile::lamellar, 110.0);
    grating.land = 0.3;
    grating.period_nm = 25000.0;
    for (const int grooves : {3, 50}) {
        grating.grooves = grooves;
        for (const int m : {0, 1, 2, 40}) {
            double sum = 0.0;
            const int steps = 200 * grooves;  // of half a line's width
            for (int k = 0; k < steps; ++k) {
                sum += boost::math::quadrature::gauss<double, 15>::integrate(
                    [&](double u) { return grating_density(grating, {m}, u, 500.0); }, 2.0 * k / steps,
                    2.0 * (k + 1) / steps);
            }
            // u >= 0 is half of all u, with both signs of m. Beyond u = 2, T = N (100 -+ m) whole widths from the line,
            // is 1 / (2 pi^2 T) of either.
            const double efficiency = grating_efficiency(grating, m, 500.0);
            const double beyond =
                (1.0 / (100.0 - m) + 1.0 / (100.0 + m)) / (2.0 * pi * pi * grooves) * (m == 0 ? 0.5 : 1.0);
            // The next term of the tail: T^-3 / (2 pi^4) or so.
            EXPECT_NEAR(sum, efficiency * ((m == 0 ? 0.5 : 1.0) - beyond), 3e-8) << grooves << ' ' << m;
        }
    }
}

TEST(Grating, StraightGroovesKeepLightInThePlaneAcrossThem) {
    Grating grating = ruled(GratingProfile::lamellar, 110.0);
    const std::vector<int> orders{1, 2, 3};
    grating.azimuth_deg = 20.0;
    EXPECT_EQ(grating_density(grating, orders, 0.4, 500.0), 0.0);  // endless
    grating.groove_length_um = 1.0;
    Grating turned = grating;
    turned.azimuth_deg = 0.0;
    // Across the grooves lies u cos(azimuth); along them the far field of a Gaussian 1 um long.
    const double across = 0.4 * std::cos(20.0 * pi / 180.0);
    const double along = 1000.0 * 0.4 * std::sin(20.0 * pi / 180.0) / 500.0;
    EXPECT_NEAR(grating_density(grating, orders, 0.4, 500.0),
                grating_density(turned, orders, across, 500.0) * std::exp(-pi * along * along), 1e-12);
    grating.azimuth_deg = 90.0;
    EXPECT_EQ(share_across(grating), 0.0);
    EXPECT_EQ(grating_density(grating, orders, 0.4, 500.0), 0.0);  // order 0 alone is seen along the grooves
}

}  // namespace
}  // namespace nacre
