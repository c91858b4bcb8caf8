#include "nacre/colour/line_integral.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <vector>

#include "reference/number.h"

namespace nacre {
namespace {

using reference::Number;
using LongNumber =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<250>, boost::multiprecision::et_off>;

struct Integrals {
    Number si, cin;
};

// Power series in 250 digits: at x = 400 its terms reach e^400 = 1e173, so 70 digits are left.
Integrals by_long_series(double x) {
    const LongNumber q = LongNumber(x) * x;
    LongNumber odd = x, even = 1, si = x, cin = 0;
    for (int k = 1; k < 2000; ++k) {
        even *= -q / ((2 * k - 1) * (2 * k));
        odd *= -q / ((2 * k) * (2 * k + 1));
        cin -= even / (2 * k);
        si += odd / (2 * k + 1);
    }
    return {Number(si), Number(cin)};
}

// Asymptotic series (DLMF 6.12.3 and 6.12.4) from x = 400 on, where the smallest term is e^-400.
Integrals by_asymptotic_series(double x) {
    const Number z(x);
    Number f = 0, g = 0, term = 1 / z;
    for (int k = 0; k < 60; ++k) {
        f += term;
        term *= (2 * k + 1) / z;
        g += term;
        term *= -(2 * k + 2) / z;
    }
    return {Number(reference::pi() / 2 - f * cos(z) - g * sin(z)),
            Number(boost::math::constants::euler<Number>() + log(z) - f * sin(z) + g * cos(z))};
}

TEST(LineIntegral, SineAndCosineIntegralsHaveAllTheirDigits) {
    EXPECT_EQ(sine_cosine_integrals(0.0).si, 0.0);
    EXPECT_EQ(sine_cosine_integrals(0.0).cin, 0.0);
    reference::Uniform random(1);
    std::vector<double> places{1e-300, 1e-100, 1e-8, 1e-3, 1.0, 3.9999, 4.0, 4.0001, 1e3, 1e6, 1e9, 1e12};
    for (int i = 0; i < 100; ++i) places.push_back(std::exp(random.between(-3.0, 6.0)));
    for (const double x : places) {
        const Integrals exact = x < 400.0 ? by_long_series(x) : by_asymptotic_series(x);
        const SineCosineIntegrals seen = sine_cosine_integrals(x);
        EXPECT_LT(reference::relative_distance(seen.si, exact.si), 2e-15) << x;
        if (x > 1e-150) {  // its square underflows
            EXPECT_LT(reference::relative_distance(seen.cin, exact.cin), 2e-15) << x;
        }
    }
}

// Of sinc^2 (or sin^2), adaptive in 50 digits over stretches of a quarter of a ripple.
template <class Function>
std::array<Number, 3> moments_of(const Function& function, const Number& from, const Number& to) {
    std::array<Number, 3> sum{};
    const int parts = 1 + static_cast<int>(4 * abs(to - from));
    for (int part = 0; part < parts; ++part) {
        const Number a = Number(-1) + Number(2 * part) / parts, b = Number(-1) + Number(2 * part + 2) / parts;
        for (int power = 0; power < 3; ++power) {
            const auto integrand = [&](const Number& s) {
                return Number(pow(s, power) * function((from + to) / 2 + s * (to - from) / 2));
            };
            sum[static_cast<std::size_t>(power)] +=
                boost::math::quadrature::gauss_kronrod<Number, 31>::integrate(integrand, a, b, 0);
        }
    }
    return sum;
}

Number line(const Number& t) {
    if (t == 0) return 1;
    const Number sinc = sin(reference::pi() * t) / (reference::pi() * t);
    return sinc * sinc;
}

Number ripple(const Number& t) {
    const Number sine = sin(reference::pi() * t);
    return sine * sine;
}

TEST(LineIntegral, MomentsOfALineAreItsIntegrals) {
    reference::Uniform random(2);
    for (int i = 0; i < 150; ++i) {
        // Pieces up to 30 lengths from the line, as short as 1e-4 and as long as 30 of its widths.
        const double length = std::exp(random.between(-9.0, 3.4));
        const double from = length * random.between(-30.0, 30.0);
        const double to = i % 2 == 0 ? from + length : from - length;
        const Moments seen = line_moments(from, to);
        const std::array<Number, 3> exact = moments_of(line, Number(from), Number(to));
        // The header's accuracy, of the envelope: where the line has a zero nothing is promised of what is left.
        const bool spans_peak = from * to <= 0.0;
        const double nearest = spans_peak ? 0.0 : std::min(std::abs(from), std::abs(to));
        const double envelope = 2.0 / std::max(1.0, nearest * nearest);
        EXPECT_LT(reference::distance(seen.zeroth, exact[0]), 1e-9 * envelope) << from << ' ' << to;
        EXPECT_LT(reference::distance(seen.first, exact[1]), 2e-8 * envelope) << from << ' ' << to;
        EXPECT_LT(reference::distance(seen.second, exact[2]), 2e-8 * envelope) << from << ' ' << to;
    }
}

TEST(LineIntegral, WholeLineHasUnitArea) {
    // From -T to T: 1 - 1 / (pi^2 T), T whole, up to T^-3 / 10; the moments are over s, so times T.
    for (const double end : {10.0, 1e3, 1e6, 1e9}) {
        EXPECT_NEAR(line_moments(-end, end).zeroth * end, 1.0 - 0.10132118364233778 / end,
                    0.06 / (end * end * end) + 2e-15)
            << end;
        EXPECT_NEAR(line_moments(-end, end).first * end, 0.0, 1e-15) << end;
    }
}

TEST(LineIntegral, TailsOfALineKeepTheirDigits) {
    // From T to 2 T, T whole: (1 / (2 pi^2)) (1 / T - 1 / (2 T)) over half the length T / 2.
    for (const double start : {1e3, 1e5, 1e7}) {
        const double exact = 0.05066059182116889 / (start * start);
        EXPECT_NEAR(line_moments(start, 2.0 * start).zeroth, exact, exact * (0.1 / (start * start) + 1e-13)) << start;
    }
}

TEST(LineIntegral, MomentsOfTheRippleAreItsIntegralsNextToItsZerosToo) {
    reference::Uniform random(3);
    for (int i = 0; i < 150; ++i) {
        const double half = std::exp(random.between(-14.0, 2.7)) * (i % 2 == 0 ? 1.0 : -1.0);
        const double middle = i % 3 == 0 ? random.between(-1e-6, 1e-6) : random.between(-3.0, 3.0);
        const Moments seen = ripple_moments(middle, half);
        const std::array<Number, 3> exact =
            moments_of(ripple, Number(middle) - Number(half), Number(middle) + Number(half));
        // Relative to what the ripple holds; the reduction of a middle of 3 rounds to 4e-16, over its distance from a
        // zero, which the random numbers keep above 1e-3.
        const double tolerance = 1e-12 * static_cast<double>(exact[0]);
        EXPECT_LT(reference::distance(seen.zeroth, exact[0]), tolerance) << middle << ' ' << half;
        EXPECT_LT(reference::distance(seen.first, exact[1]), tolerance) << middle << ' ' << half;
        EXPECT_LT(reference::distance(seen.second, exact[2]), tolerance) << middle << ' ' << half;
    }
}

TEST(LineIntegral, ParabolasAreIntegratedExactly) {
    const Moments moments{1.7, -0.3, 0.9};
    const auto [left, centre, right] = parabola_weights(moments);
    for (const double a : {0.0, 2.0}) {
        for (const double b : {-1.0, 0.5}) {
            for (const double c : {0.0, 3.0}) {
                // Some ten roundings of numbers below 10.
                EXPECT_NEAR(left * (a - b + c) + centre * a + right * (a + b + c),
                            a * moments.zeroth + b * moments.first + c * moments.second, 1e-14);
            }
        }
    }
}

}  // namespace
}  // namespace nacre
