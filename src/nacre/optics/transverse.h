#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/optics/incidence.h"

namespace nacre {

/// How the normal component q of the wave vector (in units of 2 pi / wavelength) follows from an index n:
/// q^2 = n^2 - (n0 sin theta)^2, written as (n - u)(n + u) + v so that nothing cancels.
///
/// Near the normal u = n0 sin theta and v = 0; near grazing u = n0 and v = (n0 cos theta)^2, because there the sine has
/// lost what the cosine still knows. Exact where n = n0; errs by a rounding of n where q goes through 0.
struct Transverse {
    double u_per_n0 = 0.0;
    double v_per_n0_squared = 0.0;
    double cos_theta = 1.0;  ///< > 0: at 90 degrees so small that results are the limit from below

    explicit Transverse(const Incidence& incidence) {
        constexpr double vanishing = 1e-30;
        cos_theta = std::max(incidence.cos_theta, vanishing);
        if (cos_theta * cos_theta > 0.5) {
            u_per_n0 = std::sin(incidence.theta_deg * std::numbers::pi / 180.0);
        } else {
            u_per_n0 = 1.0;
            v_per_n0_squared = cos_theta * cos_theta;
        }
    }
};

}  // namespace nacre
