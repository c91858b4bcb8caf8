#include "nacre/bake/tilt.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bake/colour_distance.h"
#include "nacre/bake/spectral_sampling.h"
#include "nacre/optics/gauss_points.h"

namespace nacre {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;
// Beyond so many standard deviations there are 1e-9 of all facets.
constexpr double most_deviations = 6.5;

// Where a ring around the surface's normal turns away from the eye: half its visible arc, in (0, pi].
double visible_arc(double along, double across) {
    if (along >= across) return std::numbers::pi;
    if (along <= -across) return 0.0;
    return std::acos(-along / across);
}

}  // namespace

std::vector<Facet> visible_facets(double tilt_deg, TiltPoints points, const Incidence& incidence) {
    const double tilt = tilt_deg * rad_per_deg;
    const double steepest = std::min(most_deviations * tilt, 0.5 * std::numbers::pi);
    const double first_hidden = (90.0 - incidence.theta_deg) * rad_per_deg;
    const double cos_theta = incidence.cos_theta;
    const double sin_theta = std::sin(incidence.theta_deg * rad_per_deg);
    const auto rings = unit_gauss_legendre(points.rings);
    const auto spokes = unit_gauss_legendre(points.spokes);
    std::vector<Facet> facets;
    double visible = 0.0;
    const auto add_rings = [&](double from, double to) {
        if (!(to > from)) return;
        for (const GaussPoint& ring : rings) {
            const double tau = std::lerp(from, to, ring.at);
            const double density = std::exp(-0.5 * (tau / tilt) * (tau / tilt)) * std::sin(tau);
            const double along = cos_theta * std::cos(tau);
            const double across = sin_theta * std::sin(tau);
            const double arc = visible_arc(along, across);
            for (const GaussPoint& spoke : spokes) {
                const double cos_facet = std::clamp(along + across * std::cos(arc * spoke.at), 0.0, 1.0);
                const double weight = (to - from) * ring.weight * density * arc * spoke.weight * cos_facet;
                facets.push_back({cos_facet, weight});
                visible += weight;
            }
        }
    };
    add_rings(0.0, std::min(first_hidden, steepest));
    add_rings(first_hidden, steepest);
    if (!(visible > 0.0)) return {{cos_theta, 1.0}};
    for (Facet& facet : facets) facet.share /= visible;
    return facets;
}

Xyz mean_over_facets(const std::vector<Facet>& facets, const XyzCurve& colour, std::uint64_t& points) {
    Xyz sum;
    for (const Facet& facet : facets) {
        const Xyz seen = colour.at(std::sqrt(facet.cos_theta));
        sum = {sum.x + facet.share * seen.x, sum.y + facet.share * seen.y, sum.z + facet.share * seen.z};
    }
    points += facets.size();
    return sum;
}

XyzCurve facet_curve(const std::function<Xyz(const Incidence&)>& colour, const std::vector<double>& bends_deg,
                     const std::function<void()>& after_step) {
    const auto at = [&](double sqrt_cos) { return colour(Incidence::from_sqrt_cos(sqrt_cos)); };
    double brightest = 0.0;
    for (const double sqrt_cos : {1.0, 0.85, 0.7, 0.5, 0.3, 0.0}) brightest = std::max(brightest, at(sqrt_cos).y);
    std::vector<double> borders;
    for (const double bend_deg : bends_deg)
        borders.push_back(std::clamp(std::sqrt(Incidence::from_degrees(bend_deg).cos_theta), 0.0, 1.0));
    for (const double cos_theta : band_least_cos_theta) borders.push_back(std::sqrt(cos_theta));
    const auto agrees = [&](const Xyz& one, const Xyz& other) {
        brightest = std::max(brightest, other.y);
        return distance_at(one, other, brightest) <= facet_curve_error;
    };
    return XyzCurve(at, curve_borders(std::move(borders)), agrees, after_step);
}

}  // namespace nacre
