#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_complex.hpp>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "reference/number.h"

/// Scattering of a sphere in 50 digits, by the textbook: Bohren & Huffman 1983, equations 4.53 with mu = 1 (all Bessel
/// functions at their own argument, no logarithmic derivative), extinction by the optical theorem, absorption as a
/// difference, angular functions from Legendre polynomials and their differential equation. n + ik, exp(-i omega t).
namespace nacre::reference {

using ComplexNumber =
    boost::multiprecision::number<boost::multiprecision::cpp_complex_backend<50>, boost::multiprecision::et_off>;

struct ExactMie {
    std::vector<ComplexNumber> a, b;  ///< [n]; [0] is not used
    Number q_ext = 0, q_sca = 0, g = 0;

    Number q_abs() const { return q_ext - q_sca; }
};

/// psi_n(z) = z j_n(z) for n = 0 ... count by Miller's algorithm: downward from far above, then scaled to sin z, or to
/// psi_1 where that is larger. The exponents of these numbers do not overflow.
template <class Value>
std::vector<Value> exact_psi(const Value& z, std::size_t count) {
    using std::abs;
    const auto size = static_cast<double>(abs(z));
    const double highest = std::max(static_cast<double>(count), size);
    const auto start = static_cast<std::size_t>(highest + 25.0 * std::cbrt(highest)) + 60;
    std::vector<Value> psi(start + 2);
    psi[start + 1] = Value(0);
    psi[start] = Value(Number("1e-1000"));
    for (std::size_t n = start; n > 0; --n) psi[n - 1] = Value(2 * n + 1) / z * psi[n] - psi[n + 1];
    const Value zeroth = sin(z);
    const Value first = size < 1e-3 ? Value(z * z / 3 * (1 - z * z / 10 * (1 - z * z / 28 * (1 - z * z / 54))))
                                    : Value(zeroth / z - cos(z));
    const Value scale = abs(zeroth) > abs(first) ? Value(zeroth / psi[0]) : Value(first / psi[1]);
    psi.resize(count + 1);
    for (Value& value : psi) value *= scale;
    return psi;
}

/// @param x,m  the very numbers that the doubles hold
inline ExactMie exact_mie(double x, std::complex<double> m) {
    const auto terms = static_cast<std::size_t>(x + 9.0 * std::cbrt(x)) + 8;
    const Number real_x = x;
    const ComplexNumber index(Number(m.real()), Number(m.imag()));
    const ComplexNumber z = index * ComplexNumber(real_x);
    const std::vector<Number> psi = exact_psi(real_x, terms);
    const std::vector<ComplexNumber> inside = exact_psi(z, terms);
    std::vector<Number> chi(terms + 1);
    chi[0] = cos(real_x);
    chi[1] = cos(real_x) / real_x + sin(real_x);
    for (std::size_t n = 1; n < terms; ++n) chi[n + 1] = (2 * n + 1) / real_x * chi[n] - chi[n - 1];

    ExactMie exact;
    exact.a.resize(terms + 1);
    exact.b.resize(terms + 1);
    Number directed = 0;
    const auto product = [](const ComplexNumber& u, const ComplexNumber& v) {
        return Number(u.real() * v.real() + u.imag() * v.imag());
    };
    for (std::size_t n = 1; n <= terms; ++n) {
        const Number order = n;
        const Number psi_slope = psi[n - 1] - order / real_x * psi[n];
        const ComplexNumber inside_slope = inside[n - 1] - ComplexNumber(order) / z * inside[n];
        const ComplexNumber xi(psi[n], -chi[n]);
        const ComplexNumber xi_slope(psi_slope, -(chi[n - 1] - order / real_x * chi[n]));
        exact.a[n] = (index * inside[n] * psi_slope - psi[n] * inside_slope) /
                     (index * inside[n] * xi_slope - xi * inside_slope);
        exact.b[n] = (inside[n] * psi_slope - index * psi[n] * inside_slope) /
                     (inside[n] * xi_slope - index * xi * inside_slope);
        exact.q_ext += (2 * n + 1) * (exact.a[n].real() + exact.b[n].real());
        exact.q_sca += (2 * n + 1) * (product(exact.a[n], exact.a[n]) + product(exact.b[n], exact.b[n]));
        directed += (2 * order + 1) / (order * (order + 1)) * product(exact.a[n], exact.b[n]);
        if (n > 1)
            directed += (order - 1) * (order + 1) / order *
                        (product(exact.a[n - 1], exact.a[n]) + product(exact.b[n - 1], exact.b[n]));
    }
    exact.g = 2 * directed / exact.q_sca;
    exact.q_ext *= 2 / (real_x * real_x);
    exact.q_sca *= 2 / (real_x * real_x);
    return exact;
}

struct ExactAmplitudes {
    ComplexNumber s1 = 0, s2 = 0;
};

inline ExactAmplitudes exact_amplitudes(const ExactMie& mie, double cos_scatter) {
    const Number mu = cos_scatter;
    Number before = 1;        // P_{n-1}
    Number last = mu;         // P_n
    Number slope_before = 0;  // of P_{n-1}
    Number slope = 1;         // of P_n: pi_n
    ExactAmplitudes sum;
    for (std::size_t n = 1; n < mie.a.size(); ++n) {
        const Number order = n;
        const Number tau = order * (order + 1) * last - mu * slope;
        const Number weight = (2 * order + 1) / (order * (order + 1));
        sum.s1 += weight * (mie.a[n] * slope + mie.b[n] * tau);
        sum.s2 += weight * (mie.a[n] * tau + mie.b[n] * slope);
        const Number next = ((2 * order + 1) * mu * last - order * before) / (order + 1);
        const Number next_slope = slope_before + (2 * order + 1) * last;
        before = last;
        last = next;
        slope_before = slope;
        slope = next_slope;
    }
    return sum;
}

}  // namespace nacre::reference
