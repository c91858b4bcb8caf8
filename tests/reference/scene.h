#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "nacre/material/mechanism.h"

namespace nacre::reference {

enum class ModelAxis { sqrt_cos_theta, cos_theta, theta_deg, of_mechanism };

/// The second axis. Of a palette: `shape`, or `peak_nm`, `width_nm`, `height` of every pick; of layers a thickness.
struct ModelParameter {
    std::string name;  ///< as a scene says it
    double from = 0.0, to = 0.0;
    std::size_t layer = 0;  ///< of layers: which of those that are written down, groups not expanded
};

/// A material under a light, and the LUT that is asked for. Typed in as the core's plain structs and never read from a
/// scene file. Light from 360 to 830 nm, Bradford to D65.
struct ModelScene {
    std::string name;
    Mechanism mechanism;
    std::string illuminant = "D65";         ///< a column of illuminants_5nm.csv
    int observer_deg = 2;                   ///< 2 or 10
    ModelAxis x = ModelAxis::of_mechanism;  ///< of_mechanism: sqrt(cos(theta)), u / 2, (1 + cos_scatter) / 2
    std::optional<ModelParameter> y{};
    double max_de00 = 0.1;  ///< what it is baked for
};

/// Cosine of the angle at x in [0, 1] of an axis over the angle.
template <typename T>
T cosine_at(ModelAxis axis, const T& x, const T& pi_number) {
    using std::cos;
    if (axis == ModelAxis::theta_deg) return T(cos(x * pi_number / 2));
    return axis == ModelAxis::cos_theta ? x : T(x * x);
}

}  // namespace nacre::reference
