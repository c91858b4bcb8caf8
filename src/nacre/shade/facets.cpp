#include "nacre/shade/facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/base/gauss_points.h"
#include "nacre/colour/difference.h"
#include "nacre/shade/spectral_sampling.h"

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

std::vector<Facet> tilted_facets(double tilt_deg, const Incidence& incidence, FacetPoints points) {
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

std::vector<Facet> seen_facets(const Relief& relief, const Incidence& incidence, FacetPoints points) {
    if (relief.roughness == 0.0) return tilted_facets(relief.tilt_deg, incidence, points);
    std::vector<double> angles_rad;
    for (int i = 1; i < points.intervals; ++i) angles_rad.push_back(0.5 * std::numbers::pi * i / points.intervals);
    return RoughFacets().at(relief.roughness, incidence, angles_rad);
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

namespace {

// P_0 ... P_degree at t, one after the other.
template <typename Sink>
void legendre(double t, int degree, const Sink& sink) {
    double before = 0.0;
    double value = 1.0;
    for (int l = 0; l <= degree; ++l) {
        sink(l, value);
        const double next = ((2.0 * l + 1.0) * t * value - l * before) / (l + 1.0);
        before = value;
        value = next;
    }
}

// Gauss-Legendre over an angle, in pieces that are short beside the ripples of the last polynomial of its cosine.
template <typename Sink>
void integrate(const std::vector<double>& borders, int degree, const Sink& sink) {
    constexpr int points_per_piece = 10;
    constexpr double ripple_per_piece = 4.0;  // radians
    const auto rule = unit_gauss_legendre(points_per_piece);
    for (std::size_t i = 1; i < borders.size(); ++i) {
        const double from = borders[i - 1];
        const double length = borders[i] - from;
        const int pieces = std::max(1, static_cast<int>(std::ceil(length * degree / ripple_per_piece)));
        for (int piece = 0; piece < pieces; ++piece) {
            for (const GaussPoint& point : rule)
                sink(from + length * (piece + point.at) / pieces, length * point.weight / pieces);
        }
    }
}

// Where facets at right angles are not rare: so many degrees are left of what their end rings like.
constexpr int degree_of_an_end = 400;

bool has_end(double tilt) {
    return 0.5 * std::numbers::pi < most_deviations * tilt;
}

// Degrees that a blur leaves: of 1e-12 on.
int degree_after(double tilt) {
    constexpr double gone = 7.5;
    const int degree = static_cast<int>(std::ceil(gone / tilt));
    return has_end(tilt) ? degree_of_an_end : degree;
}

double density(double tau, double tilt) {
    return std::exp(-0.5 * (tau / tilt) * (tau / tilt));
}

}  // namespace

void FacetColours::prepare_rough() {
    // What eight points per interval integrate beside the weights of facets (roughness.cpp).
    constexpr std::size_t low_degree = 8;
    short_pieces_ = colour_.in_pieces(low_degree);
    for (const double s : short_pieces_.borders()) angles_rad_.push_back(std::acos(s * s));
}

void FacetColours::expand(int degree) {
    if (static_cast<int>(series_.size()) > degree) return;
    // Others, somewhat less tilted, come next.
    degree = std::max(2 * degree, 64);
    series_.assign(static_cast<std::size_t>(degree) + 1, Term{});
    std::vector<double> angles;
    for (const double s : colour_.borders()) angles.push_back(std::acos(s * s));
    std::reverse(angles.begin(), angles.end());
    integrate(angles, degree, [&](double theta, double weight) {
        const double t = std::cos(theta);
        const Xyz seen = colour_.at(std::sqrt(std::max(t, 0.0)));
        const double visible = t * std::sin(theta) * weight;
        legendre(t, degree, [&](int l, double value) {
            Term& term = series_[static_cast<std::size_t>(l)];
            const double part = (l + 0.5) * value * visible;
            term[0] += part * seen.x;
            term[1] += part * seen.y;
            term[2] += part * seen.z;
            term[3] += part;
        });
    });
}

// What a blur keeps of every degree, times what there are of facets.
std::vector<double> FacetColours::kept_after(double tilt, int degree) {
    std::vector<double> kept(static_cast<std::size_t>(degree) + 1);
    if (!has_end(tilt)) {
        // 49 radians of ripple at most: Gauss's points do in one piece.
        constexpr int points = 56;
        const double steepest = most_deviations * tilt;
        for (const GaussPoint& point : unit_gauss_legendre(points)) {
            const double tau = steepest * point.at;
            const double weight = steepest * point.weight * density(tau, tilt) * std::sin(tau);
            legendre(std::cos(tau), degree,
                     [&](int l, double value) { kept[static_cast<std::size_t>(l)] += weight * value; });
        }
        return kept;
    }
    if (!wide_) {
        constexpr int points = 420;
        Wide wide;
        wide.legendre.resize(points * kept.size());
        for (const GaussPoint& point : unit_gauss_legendre(points)) {
            const std::size_t column = wide.tau.size();
            wide.tau.push_back(0.5 * std::numbers::pi * point.at);
            wide.weight.push_back(0.5 * std::numbers::pi * point.weight * std::sin(wide.tau.back()));
            legendre(std::cos(wide.tau.back()), degree, [&](int l, double value) {
                wide.legendre[static_cast<std::size_t>(l) * points + column] = value;
            });
        }
        wide_ = std::make_shared<const Wide>(std::move(wide));
    }
    std::vector<double> weight = wide_->weight;
    for (std::size_t i = 0; i < weight.size(); ++i) weight[i] *= density(wide_->tau[i], tilt);
    for (std::size_t l = 0; l < kept.size(); ++l) {
        const double* row = &wide_->legendre[l * weight.size()];
        double sums[4] = {};
        for (std::size_t i = 0; i < weight.size(); i += 4) {
            for (std::size_t k = 0; k < 4; ++k) sums[k] += weight[i + k] * row[i + k];
        }
        kept[l] = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    }
    return kept;
}

void FacetColours::blur(double tilt_deg) {
    const double tilt = tilt_deg * rad_per_deg;
    const int degree = degree_after(tilt);
    expand(degree);
    const std::vector<double> kept = kept_after(tilt, degree);
    blurred_.assign(series_.begin(), series_.begin() + degree + 1);
    for (std::size_t l = 0; l < blurred_.size(); ++l) {
        for (double& part : blurred_[l]) part *= kept[l] / kept[0];
    }
    blurred_deg_ = tilt_deg;
}

Xyz FacetColours::mean(const Relief& relief, const Incidence& incidence, std::uint64_t& points) {
    if (relief.roughness == 0.0) return tilted_mean(relief.tilt_deg, incidence, points);
    if (!short_pieces_.is_made()) prepare_rough();
    return mean_over_facets(rough_facets_.at(relief.roughness, incidence, angles_rad_), short_pieces_, points);
}

Xyz FacetColours::tilted_mean(double tilt_deg, const Incidence& incidence, std::uint64_t& points) {
    if (tilt_deg < least_blurred_deg) return mean_over_facets(tilted_facets(tilt_deg, incidence), colour_, points);
    if (blurred_deg_ != tilt_deg) blur(tilt_deg);
    Term sum{};
    legendre(incidence.cos_theta, static_cast<int>(blurred_.size()) - 1, [&](int l, double value) {
        const Term& term = blurred_[static_cast<std::size_t>(l)];
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += value * term[i];
    });
    points += blurred_.size();
    return {sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]};
}

XyzCurve facet_curve(const std::function<Xyz(const Incidence&)>& colour, const std::vector<double>& kinks_deg,
                     const std::function<void()>& after_step) {
    const auto at = [&](double sqrt_cos) { return colour(Incidence::from_sqrt_cos(sqrt_cos)); };
    double brightest = 0.0;
    for (const double sqrt_cos : {1.0, 0.85, 0.7, 0.5, 0.3, 0.0}) brightest = std::max(brightest, at(sqrt_cos).y);
    std::vector<double> borders;
    for (const double bend_deg : kinks_deg)
        borders.push_back(std::clamp(std::sqrt(Incidence::from_degrees(bend_deg).cos_theta), 0.0, 1.0));
    for (const double cos_theta : band_least_cos_theta) borders.push_back(std::sqrt(cos_theta));
    const auto difference = [&](const Xyz& one, const Xyz& other) {
        brightest = std::max(brightest, other.y);
        return difference_at(one, other, display_scale(brightest)) / facet_curve_error;
    };
    return XyzCurve(at, curve_borders(std::move(borders)), difference, after_step);
}

}  // namespace nacre
