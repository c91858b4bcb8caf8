#include "nacre/optics/mie.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace nacre {
namespace {

using Complex = std::complex<double>;

// Where a downward recurrence starts with a wrong ratio, so that the error falls below 1e-18 on the way to `terms`. Far
// above |z| a ratio is at most |z| / (2 n + 3 - |z|), and an error shrinks by its square at every step; in any case
// enough are the orders of the Airy limit of the Bessel functions (Abramowitz & Stegun 9.3.23).
int start_of_downward(int terms, double size) {
    const double highest = std::max(static_cast<double>(terms), size);
    const int enough = static_cast<int>(highest + 8.0 * std::cbrt(highest)) + 16;
    if (size > terms) return enough;
    int order = terms;
    for (double error = 1.0; error > 1e-18 && order < enough; ++order) {
        const double ratio = size / (2.0 * order + 3.0 - size);
        error *= ratio * ratio;
    }
    return order;
}

double reciprocal(double w) {
    return 1.0 / (w == 0.0 ? 1e-30 : w);
}
// Keeps the digits of a small imaginary part; std::complex may take a detour for infinities that never come.
Complex reciprocal(Complex w) {
    const double square = w.real() * w.real() + w.imag() * w.imag();
    if (square == 0.0) return 1e30;
    const double by_square = 1.0 / square;
    return {w.real() * by_square, -w.imag() * by_square};
}

// psi_{n+1}(z) / psi_n(z) for n = 0 ... terms; psi_n(z) = z j_n(z). Downward, where psi is the dominant solution.
// Imaginary parts of z and of all ratios are positive, so that small ones keep their digits.
template <class Value>
void riccati_ratios(Value z, int terms, std::vector<Value>& ratios) {
    const Value one_by_z = reciprocal(z);
    ratios.resize(static_cast<std::size_t>(terms) + 1);
    Value ratio{};
    for (int n = start_of_downward(terms, std::abs(z)); n >= 0; --n) {
        ratio = reciprocal((2.0 * n + 3.0) * one_by_z - ratio);
        if (n <= terms) ratios[static_cast<std::size_t>(n)] = ratio;
    }
}

// psi_n(x) = x j_n(x) and chi_n(x) = -x y_n(x) for n = 0 ... terms + 1, so that psi_n chi_{n+1} - psi_{n+1} chi_n = 1.
void riccati_bessel(double x, int terms, MieRoom& room) {
    const auto count = static_cast<std::size_t>(terms) + 2;
    riccati_ratios(x, terms, room.ratios);
    const std::vector<double>& ratios = room.ratios;
    std::vector<double>& psi = room.psi;
    std::vector<double>& chi = room.chi;
    psi.resize(count);
    chi.resize(count);
    psi[0] = std::sin(x);
    chi[0] = std::cos(x);
    chi[1] = std::cos(x) / x + std::sin(x);
    for (std::size_t n = 1; n + 1 < count; ++n)
        chi[n + 1] = (2.0 * static_cast<double>(n) + 1.0) / x * chi[n] - chi[n - 1];
    // Up to n = x psi oscillates: there its upward recurrence is stable, and ratios are not, which pass 0 and infinity.
    for (std::size_t n = 0; n + 1 < count; ++n) {
        const auto order = static_cast<double>(n);
        if (order + 1.0 > x)
            psi[n + 1] = ratios[n] * psi[n];
        else if (n == 0)
            psi[1] = std::sin(x) / x - std::cos(x);
        else
            psi[n + 1] = (2.0 * order + 1.0) / x * psi[n] - psi[n - 1];
    }
}

// A coefficient, and the part of the light in this multipole that is absorbed, Re(a) - |a|^2.
struct Multipole {
    Complex coefficient;
    double scattered;  // |a|^2
    double absorbed;
};
// Bohren & Huffman's 4.88 with D_n = (n + 1) / z - psi_{n+1}(z) / psi_n(z) and recurrences put in:
//
//     a = p / (p - i q),  p = psi_{n+1} + load psi_n,  q = chi_{n+1} + load chi_n
//
// so that what is equal in both terms for small x is not there to cancel. From the Wronskian follows
// Re(a) - |a|^2 = -Im(load) / |p - i q|^2, exactly.
Multipole multipole(const MieRoom& room, std::size_t n, Complex load) {
    const Complex p = room.psi[n + 1] + load * room.psi[n];
    const Complex q = room.chi[n + 1] + load * room.chi[n];
    const Complex whole(p.real() + q.imag(), p.imag() - q.real());
    const double by_size = 1.0 / std::norm(whole);
    const Complex coefficient(p.real() * whole.real() + p.imag() * whole.imag(),
                              p.imag() * whole.real() - p.real() * whole.imag());
    return {coefficient * by_size, std::norm(p) * by_size, std::max(-load.imag(), 0.0) * by_size};
}

// Q_sca g x^2 / 4: Bohren & Huffman, section 4.5.
double directed(const MieSphere& sphere) {
    double sum = 0.0;
    for (std::size_t i = 0; i < sphere.a.size(); ++i) {
        const double n = static_cast<double>(i) + 1.0;
        sum += (2.0 * n + 1.0) / (n * (n + 1.0)) * (sphere.a[i] * std::conj(sphere.b[i])).real();
        if (i + 1 == sphere.a.size()) break;
        sum += n * (n + 2.0) / (n + 1.0) *
               (sphere.a[i] * std::conj(sphere.a[i + 1]) + sphere.b[i] * std::conj(sphere.b[i + 1])).real();
    }
    return sum;
}

}  // namespace

int mie_terms(double x) {
    return static_cast<int>(x + 6.0 * std::cbrt(x)) + 2;
}

double mie_asymmetry(const MieSphere& sphere, double x) {
    return sphere.q_sca > 0.0 ? std::clamp(4.0 * directed(sphere) / (sphere.q_sca * x * x), -1.0, 1.0) : 0.0;
}

MieSphere mie_sphere(double x, Complex m) {
    MieRoom room;
    MieSphere sphere;
    mie_sphere(x, m, room, sphere);
    return sphere;
}

void mie_sphere(double x, Complex m, MieRoom& room, MieSphere& sphere) {
    assert(x > 0.0 && m.real() >= 0.0 && m.imag() >= 0.0 && m != 0.0);
    sphere.a.clear();
    sphere.b.clear();
    sphere.q_sca = sphere.q_abs = sphere.q_ext = 0.0;
    if (m == 1.0) return;
    const int terms = mie_terms(x);
    riccati_bessel(x, terms, room);
    riccati_ratios(m * x, terms, room.inner_ratios);
    const std::vector<Complex>& ratios = room.inner_ratios;
    const Complex one_by_m = reciprocal(m);
    // 1 / m^2 - 1, either part by what keeps its digits: m is nearly 1, or so large that there is next to no imaginary
    // part.
    const Complex contrast(((1.0 - m) * (1.0 + m) * one_by_m * one_by_m).real(),
                           2.0 * one_by_m.real() * one_by_m.imag());
    sphere.a.reserve(static_cast<std::size_t>(terms));
    sphere.b.reserve(static_cast<std::size_t>(terms));
    for (int n = 1; n <= terms; ++n) {
        const auto at = static_cast<std::size_t>(n);
        const Multipole electric = multipole(room, at, (n + 1.0) / x * contrast - ratios[at] * one_by_m);
        const Multipole magnetic = multipole(room, at, -m * ratios[at]);
        sphere.a.push_back(electric.coefficient);
        sphere.b.push_back(magnetic.coefficient);
        sphere.q_sca += (2.0 * n + 1.0) * (electric.scattered + magnetic.scattered);
        sphere.q_abs += (2.0 * n + 1.0) * (electric.absorbed + magnetic.absorbed);
    }
    sphere.q_sca *= 2.0 / x / x;
    sphere.q_abs *= 2.0 / x / x;
    sphere.q_ext = sphere.q_sca + sphere.q_abs;
}

// Upward as in Wiscombe 1980, equations 24: pi_{n+1} = mu pi_n + (n + 1) / n (mu pi_n - pi_{n-1}),
// tau_n = n (mu pi_n - pi_{n-1}) - pi_{n-1}.
AngularFunctions angular_functions(double cos_scatter, int terms) {
    AngularFunctions angles;
    angles.sum.resize(static_cast<std::size_t>(terms));
    angles.difference.resize(static_cast<std::size_t>(terms));
    double before = 0.0;
    double last = 1.0;
    for (std::size_t i = 0; i < angles.sum.size(); ++i) {
        const double n = static_cast<double>(i) + 1.0;
        const double turned = cos_scatter * last;
        const double step = turned - before;
        const double tau = n * step - before;
        const double one_by_n = 1.0 / n;
        const double weight = 0.5 * (one_by_n + 1.0 / (n + 1.0));
        angles.sum[i] = weight * (last + tau);
        angles.difference[i] = weight * (last - tau);
        before = last;
        last = turned + step + step * one_by_n;
    }
    return angles;
}

ScatteringAmplitudes mie_amplitudes(const MieSphere& sphere, const AngularFunctions& angles) {
    assert(angles.sum.size() >= sphere.a.size());
    Complex sum;         // (S1 + S2) / 2
    Complex difference;  // (S1 - S2) / 2
    for (std::size_t i = 0; i < sphere.a.size(); ++i) {
        sum += (sphere.a[i] + sphere.b[i]) * angles.sum[i];
        difference += (sphere.a[i] - sphere.b[i]) * angles.difference[i];
    }
    return {sum + difference, sum - difference};
}

ScatteringAmplitudes mie_amplitudes(const MieSphere& sphere, double cos_scatter) {
    return mie_amplitudes(sphere, angular_functions(cos_scatter, static_cast<int>(sphere.a.size())));
}

}  // namespace nacre
