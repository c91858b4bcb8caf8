#pragma once

#include <array>

namespace nacre {

/// Si(x) = integral of sin(t) / t and Cin(x) = integral of (1 - cos(t)) / t, t from 0 to x (DLMF 6.2.9 and 6.2.12).
struct SineCosineIntegrals {
    double si = 0.0;   ///< tends to pi / 2
    double cin = 0.0;  ///< grows like ln(x) + 0.5772
};

/// Accuracy: 2e-15 relative for x in [0, 1e12].
/// @pre x >= 0
SineCosineIntegrals sine_cosine_integrals(double x);

/// Integrals over s in [-1, 1] of 1, s and s^2 times a function of t = middle + half s.
struct Moments {
    double zeroth = 0.0;
    double first = 0.0;
    double second = 0.0;
};

/// Moments of a spectral line of N grooves, sinc^2(t), sinc(t) = sin(pi t) / (pi t): the whole line, however narrow it
/// is.
///
/// Made for pieces near the line: k lengths away from it the second moment has lost a factor k^3 of its digits.
/// Accuracy, relative to 2 min(1, 1 / t^2): 1e-9 in the zeroth moment, 2e-8 in the others.
/// @param from,to  t at s = -1 and at s = 1, in either order, at most 1e12
Moments line_moments(double from, double to);

/// Moments of sin^2(pi t), the oscillation that all orders of a grating share. Relative accuracy 1e-14, next to its
/// zeros too.
/// @param middle  t at s = 0; whole numbers may be left out of it
/// @param half    of either sign
Moments ripple_moments(double middle, double half);

/// Product integration: w such that w[0] f(-1) + w[1] f(0) + w[2] f(1) is the integral of f times the function that has
/// these moments, for every parabola f.
std::array<double, 3> parabola_weights(const Moments& moments);

}  // namespace nacre
