#pragma once

#include "nacre/optics/incidence.h"

namespace nacre {

/// The geometric quantity that the colour of a mechanism depends on: each mechanism uses one of these.
enum class Quantity {
    incidence,    ///< the angle to the normal
    grating_u,    ///< |sin theta_i + sin theta_o|
    cos_scatter,  ///< the cosine of the angle by which light is turned
};

/// The positions of light and eye. A mechanism reads its own quantity.
struct Geometry {
    Incidence incidence;
    double grating_u = 0.0;    ///< in [0, 2]
    double cos_scatter = 1.0;  ///< in [-1, 1]

    Geometry() = default;
    Geometry(const Incidence& angle) : incidence(angle) {}  // NOLINT: for most mechanisms it is all there is
    static Geometry from_grating_u(double u);
    static Geometry from_cos_scatter(double cos_scatter);
};

inline Geometry Geometry::from_grating_u(double u) {
    Geometry geometry;
    geometry.grating_u = u;
    return geometry;
}

inline Geometry Geometry::from_cos_scatter(double cos_scatter) {
    Geometry geometry;
    geometry.cos_scatter = cos_scatter;
    return geometry;
}

}  // namespace nacre
