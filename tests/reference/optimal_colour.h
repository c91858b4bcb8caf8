#pragma once

#include <vector>

#include "reference/light.h"
#include "reference/matrix.h"

namespace nacre::reference {

/// How bright a reflectance in [0, 1] can make a chromaticity: a linear program over all reflectances.
///
/// The largest t with t * colour = integral of R(nm) w(nm), 0 <= R <= 1, is by duality the least of
/// F(n) = integral of max(0, n . w(nm)) over all n with n . colour = 1. F is convex, and its slope is the colour of the
/// reflectance that is 1 where n . w > 0. Weights are linear between whole nanometres, so F is a sum of closed forms;
/// reflectances that are given at whole nanometres come 1e-4 less far.
///
/// The least is found by the method of centres of gravity (Levin 1965) in the plane n . colour = 1: a polygon that
/// holds it is cut through its centre until the tangents' lower bound is within 1e-7 of the least value seen.
class OptimalColours {
public:
    explicit OptimalColours(const ModelLight& light);

    /// @param colour  as seen under the light, before adaptation
    /// @return the largest t; 0 outside the spectral locus and for black
    double brightest_share(const Triple& colour) const;

private:
    struct Value {
        double value = 0.0;
        Triple slope{};
    };
    Value integral_of_positive_part(const Triple& n) const;

    std::vector<Triple> weights_;  // of white (1, 1, 1)
    Triple white_{};
};

}  // namespace nacre::reference
