#pragma once

#include <complex>
#include <vector>

namespace nacre {

/// Scattering of a plane wave by a homogeneous sphere in a lossless medium: Mie 1908, Annalen der Physik 330, 377-445;
/// in the notation of Bohren & Huffman 1983, Absorption and Scattering of Light by Small Particles, chapter 4, whose
/// fields go as exp(-i omega t), too.
struct MieSphere {
    /// Coefficients a_n (electric) and b_n (magnetic); [0] is n = 1. As many of one as of the other; none if m = 1.
    std::vector<std::complex<double>> a, b;
    double q_sca = 0.0;  ///< efficiency: cross-section over pi radius^2, >= 0
    double q_abs = 0.0;  ///< >= 0; 0 without absorption
    double q_ext = 0.0;  ///< their sum
};

/// The mean cosine of the scattering angle, in [-1, 1]; 0 where nothing is scattered. @param x  the sphere's size
double mie_asymmetry(const MieSphere& sphere, double x);

/// Where a sphere's functions are written down. Whoever computes many lends them the same.
struct MieRoom {
    std::vector<double> ratios, psi, chi;
    std::vector<std::complex<double>> inner_ratios;
};

/// @param x  size parameter: 2 pi radius * index of the medium / vacuum wavelength, > 0
/// @param m  index of the sphere over that of the medium, n + ik with n >= 0, k >= 0, not 0
///
/// There is no cancellation for small spheres, neither in q_sca nor in q_abs. Accuracy for x in [1e-6, 1e4]: 1e-12 of
/// q_sca and q_abs, except 1e-14 / |m - 1| where m is nearly 1, and what a change of x by its last bit makes of a sharp
/// resonance (tests/nacre/optics/mie_test.cpp, in 50 digits). The time is proportional to x + |m| x: 1 us at x = 1, 1
/// ms at 1e4.
MieSphere mie_sphere(double x, std::complex<double> m);
/// Into a sphere that was another one before.
void mie_sphere(double x, std::complex<double> m, MieRoom& room, MieSphere& sphere);

/// The number of coefficients of a sphere. Beyond it, |a_n| and |b_n| are about 1e-12: not only their squares,
/// which Wiscombe 1980 (Applied Optics 19, 1505-1509) goes by with 4 cube roots of x instead of 6.
int mie_terms(double x);

/// What of the amplitudes depends on the angle alone: (2 n + 1) / (n (n + 1)) times half of pi_n + tau_n, and of
/// pi_n - tau_n; [0] is n = 1.
struct AngularFunctions {
    std::vector<double> sum, difference;
};
/// @param cos_scatter  cosine of the angle between the light's old and new direction, in [-1, 1]
AngularFunctions angular_functions(double cos_scatter, int terms);

/// Of the scattered far field: of light with the electric field across the scattering plane (S1), and in it (S2). The
/// differential cross-section is |S|^2 / k^2, k being the wave number in the medium.
struct ScatteringAmplitudes {
    std::complex<double> s1, s2;
};
/// @param angles  of at least as many terms as the sphere has coefficients
ScatteringAmplitudes mie_amplitudes(const MieSphere& sphere, const AngularFunctions& angles);
ScatteringAmplitudes mie_amplitudes(const MieSphere& sphere, double cos_scatter);

}  // namespace nacre
