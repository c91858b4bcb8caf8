#include "reference/facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/complex.h"

namespace nacre::reference {

std::vector<ModelFacet> facets_seen(double tilt_deg, double theta_deg) {
    constexpr int rings = 240;
    constexpr int around = 120;
    constexpr double deviations = 6.0;
    const double tilt = tilt_deg * std::numbers::pi / 180.0, theta = theta_deg * std::numbers::pi / 180.0;
    const double steepest = std::min(deviations * tilt, 0.5 * std::numbers::pi);
    const double from = std::max(theta - steepest, 0.0), to = std::min(theta + steepest, 0.5 * std::numbers::pi);
    std::vector<ModelFacet> facets;
    double whole = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double beta = from + (to - from) * (i + 0.5) / rings;
        // The arc around the eye on which normals are within `steepest` of the surface's.
        const double reach = (std::cos(steepest) - std::cos(theta) * std::cos(beta)) /
                             std::max(std::sin(theta) * std::sin(beta), 1e-300);
        if (reach >= 1.0) continue;
        const double arc = reach <= -1.0 ? std::numbers::pi : std::acos(reach);
        double density = 0.0;
        for (int j = 0; j < around; ++j) {
            const double phi = arc * (j + 0.5) / around;
            // cos(tau) by half angles: near the normal its arc cosine would lose digits.
            const double haversine =
                square(std::sin(0.5 * (theta - beta))) + std::sin(theta) * std::sin(beta) * square(std::sin(0.5 * phi));
            const double tau = 2.0 * std::asin(std::min(std::sqrt(haversine), 1.0));
            density += arc / around * std::exp(-0.5 * square(tau / tilt));
        }
        facets.push_back({std::cos(beta), density * std::sin(beta) * std::cos(beta)});
        whole += facets.back().share;
    }
    for (ModelFacet& facet : facets) facet.share /= whole;
    return facets;
}

}  // namespace nacre::reference
