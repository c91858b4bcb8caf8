#pragma once

namespace nacre {

/// The angle between the light (or the view, or the half vector) and the normal, in air.
///
/// Kept twice, because neither number follows from the other without loss: near the normal the cosine of 1e-6 degrees
/// rounds to 1, and near grazing 90 - theta has fewer digits than cos(theta).
struct Incidence {
    double theta_deg = 0.0;  ///< in [0, 90]
    double cos_theta = 1.0;  ///< in [0, 1]

    /// cos(theta) is computed as sin(90 - theta), so 90 degrees gives exactly 0.
    static Incidence from_degrees(double theta_deg);
    static Incidence from_cos(double cos_theta);
    /// From the axis sqrt(cos(theta)): 1 - cos(theta) = (1 - s)(1 + s) keeps its digits near the normal.
    static Incidence from_sqrt_cos(double sqrt_cos_theta);
};

}  // namespace nacre
