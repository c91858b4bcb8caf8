#pragma once

#include <vector>

namespace nacre {

/// A point of a quadrature and the weight of the integrand there.
struct GaussPoint {
    double at = 0.0;
    double weight = 0.0;
};

/// Gauss and Legendre: the integral over [-1, 1], exact for polynomials up to degree 2 count - 1. Ascending; the
/// weights sum to 2. Takes a time of count^2.
/// @param count  >= 1
std::vector<GaussPoint> gauss_legendre(int count);

/// The same over [0, 1]; the weights sum to 1.
std::vector<GaussPoint> unit_gauss_legendre(int count);

/// Gauss and Hermite: the mean over a normal variable of mean 0 and variance 1, exact for polynomials up to degree
/// 2 count - 1. Ascending; the weights sum to 1, and those far out may be 0. Takes a time of count^2.
/// @param count  >= 1
std::vector<GaussPoint> gauss_normal(int count);

/// The mean over such a variable of a function that ripples: up to 16 points are Gauss's, more are even steps over six
/// standard deviations to both sides. Ascending; the weights sum to 1.
///
/// Even steps are exact but for exp(-18) that is cut off, and what varies faster than 2 pi over a step. Of Gauss's
/// points many are far out, where nothing counts, and the rest only come closer as 1 / sqrt(count).
/// @param count  >= 1
std::vector<GaussPoint> normal_points(int count);

}  // namespace nacre
