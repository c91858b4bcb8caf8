#include "reference/spheres.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nacre::reference {

ModelSphere model_sphere(double x, Complex m) {
    const auto terms = static_cast<int>(x + 4.0 * std::cbrt(x) + 6.0);
    const Complex z = m * x;
    // The logarithmic derivative of psi_n downward from where it does not matter.
    const int start = std::max(terms, static_cast<int>(std::abs(z))) + 30;
    std::vector<Complex> slope(static_cast<std::size_t>(start) + 1, 0.0);
    for (int n = start; n > 0; --n) {
        const Complex ratio = static_cast<double>(n) / z;
        slope[static_cast<std::size_t>(n) - 1] = ratio - 1.0 / (slope[static_cast<std::size_t>(n)] + ratio);
    }
    // psi downward too: upward it drowns beyond n = x.
    std::vector<double> psi(static_cast<std::size_t>(start) + 2, 0.0);
    psi[static_cast<std::size_t>(start)] = 1e-280;
    for (int n = start; n > 0; --n) {
        const auto i = static_cast<std::size_t>(n);
        psi[i - 1] = (2.0 * n + 1.0) / x * psi[i] - psi[i + 1];
        if (std::abs(psi[i - 1]) > 1e200)
            for (std::size_t k = i - 1; k <= static_cast<std::size_t>(start); ++k) psi[k] *= 1e-200;
    }
    const double first = std::sin(x) / x - std::cos(x);
    const double scale = std::abs(std::sin(x)) > std::abs(first) ? std::sin(x) / psi[0] : first / psi[1];
    ModelSphere sphere;
    sphere.a.resize(static_cast<std::size_t>(terms) + 1);
    sphere.b.resize(sphere.a.size());
    double chi_before = -std::sin(x), chi = std::cos(x);
    for (int n = 0; n <= terms; ++n) {
        const auto i = static_cast<std::size_t>(n);
        if (n > 0) {
            const Complex xi(scale * psi[i], -chi), xi_before(scale * psi[i - 1], -chi_before);
            const double up = n / x;
            const Complex of_a = slope[i] / m + up, of_b = slope[i] * m + up;
            sphere.a[i] = (of_a * scale * psi[i] - scale * psi[i - 1]) / (of_a * xi - xi_before);
            sphere.b[i] = (of_b * scale * psi[i] - scale * psi[i - 1]) / (of_b * xi - xi_before);
            const double weight = 2.0 / (x * x) * (2.0 * n + 1.0);
            sphere.q_ext += weight * (sphere.a[i].real() + sphere.b[i].real());
            sphere.q_sca += weight * (squared_magnitude(sphere.a[i]) + squared_magnitude(sphere.b[i]));
        }
        const double next = (2.0 * n + 1.0) / x * chi - chi_before;
        chi_before = chi;
        chi = next;
    }
    return sphere;
}

ModelSphere::Amplitudes ModelSphere::amplitudes(double mu) const {
    Amplitudes sum{};
    double before = 0.0, now = 1.0;  // pi_(n-1), pi_n
    for (std::size_t i = 1; i < a.size(); ++i) {
        const auto n = static_cast<double>(i);
        const double tau = n * mu * now - (n + 1.0) * before;
        const double weight = (2.0 * n + 1.0) / (n * (n + 1.0));
        sum.s1 += weight * (a[i] * now + b[i] * tau);
        sum.s2 += weight * (a[i] * tau + b[i] * now);
        const double next = ((2.0 * n + 1.0) * mu * now - (n + 1.0) * before) / n;
        before = now;
        now = next;
    }
    return sum;
}

}  // namespace nacre::reference
