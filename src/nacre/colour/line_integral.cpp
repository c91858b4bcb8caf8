// The line sinc^2(t) = sin^2(pi t) / (pi t)^2 times 1, t and t^2 has the integrals from 0, with z = 2 pi t,
//
//   J0 = (Si(z) - (1 - cos z) / z) / pi,   J1 = Cin(z) / (2 pi^2),   J2 = (z - sin z) / (4 pi^3)
//
// by parts and by sin^2 = (1 - cos) / 2. What J0 lacks of 1/2 is kept rather than J0, so that tails keep their digits.
#include "nacre/colour/line_integral.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace nacre {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double half_pi = 0.5 * std::numbers::pi;

// Power series up to here: their largest terms are below 3, so next to nothing cancels.
constexpr double series_up_to = 4.0;

// DLMF 6.6.5 and 6.6.6.
SineCosineIntegrals by_series(double x) {
    const double q = x * x;
    double si = x;
    double cin = 0.0;
    double power = x;  // (-1)^k x^(2 k + 1) / (2 k + 1)!, or with one factor less
    for (int k = 1; k < 20; ++k) {
        const double even = -power * x / (2.0 * k);
        power = even * x / (2.0 * k + 1.0);
        cin -= even / (2.0 * k);
        si += power / (2.0 * k + 1.0);
        if (std::abs(even) < 1e-18 * q) break;
    }
    return {si, cin};
}

// f and g of DLMF 6.2.17 and 6.2.18: Si = pi / 2 - f cos - g sin, Ci = f sin - g cos.
struct Auxiliary {
    double f;
    double g;
};

// g - i f = exp(i x) E1(i x) = 1 / (1 + i x - 1 / (3 + i x - 4 / (5 + i x - 9 / ...))), the even part of DLMF 6.9.1,
// from its end. After n terms what is left out is of the order exp(-4 sqrt(n x / 2)).
Auxiliary by_fraction(double x) {
    const int terms = 5 + static_cast<int>(190.0 / x);
    double real = 2.0 * terms + 1.0;
    double imaginary = x;
    for (int k = terms; k >= 1; --k) {
        const double share = static_cast<double>(k) * k / (real * real + imaginary * imaginary);
        real = 2.0 * k - 1.0 - share * real;
        imaginary = x + share * imaginary;
    }
    const double norm = real * real + imaginary * imaginary;
    return {imaginary / norm, real / norm};
}

// What J0, J1 and J2 need at one end.
struct End {
    double sign;
    double tail;  // 1/2 - J0(|t|)
    double j1;
    double j2;
};

End end_at(double t) {
    const double size = std::abs(t);
    const double sign = t < 0.0 ? -1.0 : 1.0;
    const double z = 2.0 * pi * size;
    // The sine of the reduced argument; z itself would have rounded.
    const double reduced = 2.0 * pi * (size - std::nearbyint(size));
    const double sine = std::sin(reduced);
    const double cosine = std::cos(reduced);
    const double j2 = sign * (z - sine) / (4.0 * pi * pi * pi);
    if (z <= series_up_to) {
        const auto [si, cin] = by_series(z);
        const double half_sine = std::sin(0.5 * z);
        const double j0 = z > 0.0 ? (si - 2.0 * half_sine * half_sine / z) / pi : 0.0;
        return {sign, 0.5 - j0, cin / (2.0 * pi * pi), j2};
    }
    const auto [f, g] = by_fraction(z);
    const double cin = std::numbers::egamma + std::log(z) - f * sine + g * cosine;
    return {sign, (1.0 / z + (f - 1.0 / z) * cosine + g * sine) / pi, cin / (2.0 * pi * pi), j2};
}

// Gauss and Legendre's rule on [-1, 1]: one half of its nodes.
struct Node {
    double place;
    double weight;
};

double sinc_squared(double t) {
    if (std::abs(t) < 1e-9) return 1.0;
    const double sinc = std::sin(pi * (t - std::nearbyint(t))) / (pi * t);
    return sinc * sinc;
}

template <std::size_t size>
Moments by_gauss(const std::array<Node, size>& rule, double middle, double half) {
    Moments sum;
    for (const auto& [place, weight] : rule) {
        const double left = weight * sinc_squared(middle - half * place);
        const double right = weight * sinc_squared(middle + half * place);
        sum.zeroth += left + right;
        sum.first += place * (right - left);
        sum.second += place * place * (left + right);
    }
    return sum;
}

// Abramowitz & Stegun, table 25.4, n = 4 and n = 6.
constexpr std::array<Node, 2> four_nodes{
    {{0.339981043584856264803, 0.652145154862546142627}, {0.861136311594052575224, 0.347854845137453857373}}};
constexpr std::array<Node, 3> six_nodes{{{0.238619186083196908631, 0.467913934572691047390},
                                         {0.661209386466264513661, 0.360761573048138607570},
                                         {0.932469514203152027812, 0.171324492379170345040}}};

// What ripple_moments() needs of spherical Bessel functions (DLMF 10.49.3), w = 2 pi half.
struct Spherical {
    double one_less_j0;
    double j1;
    double third_less;  // 1/3 - (j0 - 2 j1 / w) = integral of s^2 sin^2(w s / 2)
};

Spherical spherical(double w) {
    if (std::abs(w) < 2.0) {
        // Each is an integral over [-1, 1] of cos(w s) or sin(w s) times a power of s, term by term.
        Spherical sum{0.0, 0.0, 0.0};
        double term = 1.0;                    // (-1)^k w^(2 k) / (2 k)!
        constexpr double negligible = 1e-18;  // of the sums, which begin with the square of w: no digit changes
        for (int k = 1; k < 14; ++k) {
            const double before = term;
            term *= -w * w / ((2.0 * k - 1.0) * (2.0 * k));
            sum.one_less_j0 -= term / (2.0 * k + 1.0);
            sum.j1 += before * w / ((2.0 * k - 1.0) * (2.0 * k + 1.0));
            sum.third_less -= term / (2.0 * k + 3.0);
            if (std::abs(term) < negligible * w * w) break;
        }
        return sum;
    }
    const double sine = std::sin(w);
    const double cosine = std::cos(w);
    const double j0 = sine / w;
    const double j1 = (j0 - cosine) / w;
    return {1.0 - j0, j1, 1.0 / 3.0 - j0 + 2.0 * j1 / w};
}

}  // namespace

SineCosineIntegrals sine_cosine_integrals(double x) {
    assert(x >= 0.0);
    if (x <= series_up_to) return by_series(x);
    const auto [f, g] = by_fraction(x);
    const double sine = std::sin(x);
    const double cosine = std::cos(x);
    return {half_pi - f * cosine - g * sine, std::numbers::egamma + std::log(x) - f * sine + g * cosine};
}

Moments line_moments(double from, double to) {
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    // Closed forms divide by half^3, quadrature does not. Its error: below 1e-9 of 1 / t^2 in the zeroth moment, 2e-8
    // in the second, which curvature over one piece makes small.
    if (std::abs(half) < 0.05) return by_gauss(four_nodes, middle, half);
    if (std::abs(half) < 0.25) return by_gauss(six_nodes, middle, half);
    const End a = end_at(from);
    const End b = end_at(to);
    const double j0 = a.sign == b.sign ? a.sign * (a.tail - b.tail) : b.sign * (1.0 - a.tail - b.tail);
    const double j1 = b.j1 - a.j1;
    const double j2 = b.j2 - a.j2;
    return {j0 / half, (j1 - middle * j0) / (half * half),
            (j2 - middle * (2.0 * j1 - middle * j0)) / (half * half * half)};
}

Moments ripple_moments(double middle, double half) {
    const double angle = pi * (middle - std::nearbyint(middle));
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const auto [one_less_j0, j1, third_less] = spherical(2.0 * pi * half);
    // sin^2(a + b) = sin^2 a cos^2 b + cos^2 a sin^2 b + 2 sin a cos a sin b cos b: nothing cancels in what is even.
    const double dark = cosine * cosine;
    const double bright = sine * sine;
    return {bright * (2.0 - one_less_j0) + dark * one_less_j0, 2.0 * sine * cosine * j1,
            bright * (2.0 / 3.0 - third_less) + dark * third_less};
}

std::array<double, 3> parabola_weights(const Moments& moments) {
    return {0.5 * (moments.second - moments.first), moments.zeroth - moments.second,
            0.5 * (moments.second + moments.first)};
}

}  // namespace nacre
