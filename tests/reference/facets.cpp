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

std::vector<ModelFacet> rough_facets_seen(double roughness, double theta_deg, int side) {
    const double alpha = roughness * roughness;
    const double theta = theta_deg * std::numbers::pi / 180.0;
    const double eye_x = std::sin(theta), eye_z = theta_deg == 90.0 ? 0.0 : std::cos(theta);
    const auto lambda = [&](double cosine) {
        return 0.5 * (std::sqrt(1.0 + square(alpha) * (1.0 / square(cosine) - 1.0)) - 1.0);
    };
    // The eye in the space where the surface is a half sphere of radius 1, and two directions across it.
    const double length = std::hypot(alpha * eye_x, eye_z);
    const double x = alpha * eye_x / length, z = eye_z / length;
    const double half_seen = 0.5 * (1.0 + z);
    std::vector<ModelFacet> facets;
    double whole = 0.0;
    for (int i = 0; i < side * side; ++i) {
        // Crowded at the rim, where the steepest facets are.
        const int ring = i / side;
        const double from_rim = 1.0 - (ring + 0.5) / side;
        const double radius = std::sqrt((1.0 - square(from_rim)) * (1.0 + square(from_rim)));
        const double turn = 2.0 * std::numbers::pi * (i % side + 0.5) / side;
        const double across = radius * std::cos(turn);
        const double up = (1.0 - half_seen) * std::sqrt(1.0 - square(across)) + half_seen * radius * std::sin(turn);
        const double towards = std::sqrt(std::max(1.0 - square(across) - square(up), 0.0));
        const double h_x = alpha * (towards * x - up * z), h_y = alpha * across;
        const double h_z = std::max(towards * z + up * x, 0.0);
        const double norm = std::sqrt(square(h_x) + square(h_y) + square(h_z));
        const double cos_beta = (eye_x * h_x + eye_z * h_z) / norm;
        const double light_z = 2.0 * cos_beta * h_z / norm - eye_z;
        if (!(light_z > 0.0) || !(cos_beta > 0.0)) continue;
        const double lit =
            eye_z > 0.0 ? (1.0 + lambda(eye_z)) / (1.0 + lambda(eye_z) + lambda(std::min(light_z, 1.0))) : 1.0;
        const double share = lit * from_rim * square(from_rim);
        facets.push_back({std::min(cos_beta, 1.0), share});
        whole += share;
    }
    for (ModelFacet& facet : facets) facet.share /= whole;
    return facets;
}

std::vector<ModelFacet> facets_seen(const Relief& relief, double theta_deg, const std::vector<double>& bends_deg) {
    constexpr int side = 384;
    return relief.roughness > 0.0 ? rough_facets_seen(relief.roughness, theta_deg, side)
                                  : facets_seen(relief.tilt_deg, theta_deg, bends_deg);
}

}  // namespace nacre::reference
