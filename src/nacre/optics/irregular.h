#pragma once

#include <cstddef>
#include <vector>

#include "nacre/optics/layer_system.h"

namespace nacre {

/// Layer systems whose mean is the reflectance of an irregular stack: every layer's thickness is a normal variable of
/// its own, with the standard deviation `spread_nm` around its nominal value, and never below 0.
///
/// An integral over as many variables as there are layers. It uses a fixed set of points, so there is no noise.
/// Up to three layers have a grid of normal_points(), if `count` affords four along each: then more points help as they
/// do in any smooth integral. More layers have Richtmyer's sequence (multiples of the roots of primes), one variable
/// per layer, stratified so that every layer by itself is spread evenly; every point with its mirror image, so that odd
/// orders cancel; and layers made uncorrelated, so that second orders are exact too, as long as there are not more
/// layers than count / 2. Whatever is a polynomial of third degree in the thicknesses is then integrated exactly
/// (moment matching: Barraquand 1995, Management Science 41, 1882-1891). What is left falls as 1 / sqrt(count), or
/// faster for a few layers, and is small to begin with.
///
/// Repeats are written out. Incoherent layers stay as they are.
/// @param count  at most so many systems (a grid takes the largest power that fits); even, >= 2
LayerEnsemble irregular_systems(const LayerSystem& regular, double spread_nm, int count);

/// Useful sample counts.
struct ThicknessSampleCounts {
    std::vector<int> list;       ///< ascending, at least three
    bool converge_fast = false;  ///< whether they make grids
};
/// @param layers  that are uneven, each on its own
ThicknessSampleCounts thickness_sample_counts(std::size_t layers);

}  // namespace nacre
