#include "reference/facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/complex.h"

namespace nacre::reference {

namespace {

// Of normals at an angle of beta around the eye: the mean over those within `steepest` of the surface's.
double density_at(double beta, double theta, double tilt, double steepest) {
    constexpr int around = 120;
    const double reach =
        (std::cos(steepest) - std::cos(theta) * std::cos(beta)) / std::max(std::sin(theta) * std::sin(beta), 1e-300);
    if (reach >= 1.0) return 0.0;
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
    return density;
}

}  // namespace

std::vector<ModelFacet> facets_seen(double tilt_deg, double theta_deg, const std::vector<double>& bends_deg) {
    constexpr int rings = 240;
    constexpr double deviations = 6.0, degree = std::numbers::pi / 180.0;
    const double tilt = tilt_deg * degree, theta = theta_deg * degree;
    const double steepest = std::min(deviations * tilt, 0.5 * std::numbers::pi);
    std::vector<double> ends{std::max(theta - steepest, 0.0)};
    const double last = std::min(theta + steepest, 0.5 * std::numbers::pi);
    for (const double bend : bends_deg)
        if (bend * degree > ends.back() && bend * degree < last) ends.push_back(bend * degree);
    ends.push_back(last);
    std::vector<ModelFacet> facets;
    double whole = 0.0;
    for (std::size_t part = 0; part + 1 < ends.size(); ++part) {
        for (int i = 0; i < rings; ++i) {
            // Crowded at either end, so that a root begins there like a straight line.
            const double s = (i + 0.5) / rings, width = ends[part + 1] - ends[part];
            const double beta = ends[part] + width * s * s * (3.0 - 2.0 * s);
            const double share =
                width * s * (1.0 - s) * density_at(beta, theta, tilt, steepest) * std::sin(beta) * std::cos(beta);
            facets.push_back({std::cos(beta), share});
            whole += share;
        }
    }
    for (ModelFacet& facet : facets) facet.share /= whole;
    return facets;
}

}  // namespace nacre::reference
