#pragma once

#include <complex>

namespace nacre::reference {

using Complex = std::complex<double>;

inline double square(double value) {
    return value * value;
}

// Products and quotients are written out: the numbers are finite, and the library's are slow because theirs need not
// be.
inline Complex times(const Complex& a, const Complex& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
inline double squared_magnitude(const Complex& a) {
    return a.real() * a.real() + a.imag() * a.imag();
}
/// a / b; 0 for 0 / 0: a face between equal media, both with the wave running along it.
inline Complex over(const Complex& a, const Complex& b) {
    const double size = squared_magnitude(b);
    return size == 0.0 ? Complex(0.0) : times(a, std::conj(b)) / size;
}

}  // namespace nacre::reference
