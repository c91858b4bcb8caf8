#pragma once

#include <vector>

namespace nacre {

/// A point of a quadrature and the weight of the integrand there.
struct GaussPoint {
    double at = 0.0;
    double weight = 0.0;
};

/// Gauss and Legendre: the integral over [-1, 1], exact for polynomials up to degree 2 count - 1. Ascending; the
/// weights sum to 2. The time is proportional to count^2.
/// @param count  >= 1
std::vector<GaussPoint> gauss_legendre(int count);

/// The same over [0, 1]; the weights sum to 1.
std::vector<GaussPoint> unit_gauss_legendre(int count);

/// Gauss and Hermite: the mean over a normal variable of mean 0 and variance 1, exact for polynomials up to degree
/// 2 count - 1. Ascending; the weights sum to 1, and those far out may be 0. The time is proportional to count^2.
/// @param count  >= 1
std::vector<GaussPoint> gauss_normal(int count);

/// The mean over such a variable of an oscillating function: up to 16 points are Gauss's; more are even steps over six
/// standard deviations on both sides. Ascending; the weights sum to 1.
///
/// Even steps are exact except for the tail beyond, exp(-18), and for what varies faster than 2 pi over a step. Many of
/// Gauss's points are far out, where nothing counts, and the spacing of the others only falls as 1 / sqrt(count).
/// @param count  >= 1
std::vector<GaussPoint> normal_points(int count);

/// The normal variable of mean 0 and variance 1 above which a share of all lies, by Newton's method on the
/// complementary error function.
/// @param share  0 < share <= 1 / 2
double normal_above(double share);

}  // namespace nacre
