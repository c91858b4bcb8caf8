#include "nacre/optics/structure_factor.h"

#include <array>
#include <cassert>
#include <cmath>
#include <complex>

namespace nacre {
namespace {

using Complex = std::complex<double>;

// The integrals over [0, 1] of s^k exp(i u s), k = 0, 1, 2.
std::array<Complex, 3> moments(double u) {
    if (u < 1.0) {  // powers of i u: below, nothing cancels
        std::array<Complex, 3> sums{};
        double term = 1.0;  // u^j / j!; i^j is 1, i, -1, -i
        for (int j = 0; j < 20 && term > 1e-18; ++j) {
            const double signed_term = j % 4 < 2 ? term : -term;
            const Complex part = j % 2 == 0 ? Complex(signed_term, 0.0) : Complex(0.0, signed_term);
            for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += part / (j + 1.0 + static_cast<double>(k));
            term *= u / (j + 1.0);
        }
        return sums;
    }
    const Complex wave(std::cos(u), std::sin(u));
    const double by_u = 1.0 / u;
    const auto by_iu = [&](const Complex& value) { return Complex(value.imag() * by_u, -value.real() * by_u); };
    const Complex zeroth = by_iu(wave - 1.0);
    const Complex first = by_iu(wave - zeroth);
    return {zeroth, first, by_iu(wave - 2.0 * first)};
}

}  // namespace

// With Baxter's factor function, a / 2 (s^2 - 1) + b (s - 1) for distances s from 0 to one diameter.
HardSpheres::HardSpheres(double volume_fraction) {
    assert(volume_fraction >= 0.0 && volume_fraction <= 0.6);
    const double square = (1.0 - volume_fraction) * (1.0 - volume_fraction);
    const double a = (1.0 + 2.0 * volume_fraction) / square;
    const double b = -1.5 * volume_fraction / square;
    of_square_ = 12.0 * volume_fraction * 0.5 * a;
    of_line_ = 12.0 * volume_fraction * b;
}

double HardSpheres::structure_factor(double q_diameter) const {
    assert(q_diameter >= 0.0);
    const std::array<Complex, 3> moment = moments(q_diameter);
    const Complex factor = 1.0 - (of_square_ * (moment[2] - moment[0]) + of_line_ * (moment[1] - moment[0]));
    return 1.0 / std::norm(factor);
}

double hard_sphere_structure_factor(double volume_fraction, double q_diameter) {
    return HardSpheres(volume_fraction).structure_factor(q_diameter);
}

}  // namespace nacre
