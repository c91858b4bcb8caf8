#include "nacre/shade/roughness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/base/gauss_points.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "nacre/shade/roughness.cpp"
#include <hwy/foreach_target.h>  // compiles the rest of this file once per instruction set
#include <hwy/highway.h>

#ifndef NACRE_SHADE_ROUGHNESS_VIEW
#define NACRE_SHADE_ROUGHNESS_VIEW
namespace nacre {
namespace {

constexpr std::size_t most_lanes = 8;

// A rough surface, seen from one side.
struct RoughView {
    double alpha;
    double k;          // root of 1 - alpha^2
    double cos_theta;  // of the eye
    double sin_theta;
    double eye;  // cos(theta) 2 (1 + L(v))
};

}  // namespace
}  // namespace nacre
#endif

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// What is seen, but for a factor, of the facets whose angle gamma to the line of sight is theta + offset. With psi the
// direction around that line, cos(h, n) = c = p - q (1 - cos(psi)); psi = 2 atan(g tan(u / 2)) makes 1 / (1 - k c)^2 a
// polynomial in w. The part of G in L(l) is written in cosines instead of tangents: at grazing it stays a number.
// @param half_sine  sin(offset / 2). @param count  a multiple of most_lanes
void seen_facets_at(const RoughView& view, std::span<const RoughFacets::PointAround> around,
                    const double* HWY_RESTRICT half_sine, size_t count, double* HWY_RESTRICT cos_gamma_out,
                    double* HWY_RESTRICT seen_out) {
    const hn::CappedTag<double, most_lanes> d;
    const auto zero = hn::Zero(d);
    const auto one = hn::Set(d, 1.0);
    const auto two = hn::Set(d, 2.0);
    const auto k = hn::Set(d, view.k);
    const auto alpha_squared = hn::Set(d, view.alpha * view.alpha);
    const auto cos_theta = hn::Set(d, view.cos_theta);
    const auto sin_theta = hn::Set(d, view.sin_theta);
    const auto eye = hn::Set(d, view.eye);
    const auto eye_less_cos = hn::Set(d, view.eye - view.cos_theta);
    const auto mirror_a = hn::Set(d, view.alpha * view.alpha / (1.0 + view.k));  // 1 - k
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto half = hn::LoadU(d, half_sine + i);
        const auto one_less_p = two * half * half;
        const auto p = one - one_less_p;
        const auto sin_offset = two * half * hn::Sqrt((one - half) * (one + half));
        const auto sin_gamma = hn::MulAdd(sin_theta, p, cos_theta * sin_offset);
        const auto cos_gamma = hn::MulSub(cos_theta, p, sin_theta * sin_offset);
        const auto q = sin_theta * sin_gamma;
        const auto a = hn::MulAdd(k, one_less_p, mirror_a);  // 1 - k p
        const auto g_squared = a / hn::MulAdd(two * k, q, a);
        // The light that is mirrored to the eye comes from above where along + across cos(psi) > 0.
        const auto along = cos_theta * (cos_gamma - sin_gamma) * (cos_gamma + sin_gamma);
        const auto across = two * q * cos_gamma;
        const auto is_part = along < across;
        const auto above = hn::Max(across + along, zero);
        const auto last_w = hn::Sqrt(above / hn::MulAdd(across - along, g_squared, above));
        auto sum = zero;
        for (const RoughFacets::PointAround& point : around) {
            const auto w = hn::IfThenElse(is_part, last_w * hn::Set(d, point.part_w), hn::Set(d, point.whole_w));
            const auto w_squared = w * w;
            const auto cos_squared = (one - w) * (one + w);
            const auto part_weight = last_w * hn::Set(d, point.part_weight) / hn::Sqrt(cos_squared);
            const auto weight = hn::IfThenElse(is_part, part_weight, hn::Set(d, point.whole_weight));
            const auto m = hn::MulAdd(g_squared, w_squared, cos_squared);
            const auto c = p - two * q * g_squared * w_squared / m;
            const auto light = hn::MulSub(two * cos_gamma, c, cos_theta);
            const auto towards_light =
                hn::Sqrt(hn::MulAdd(light, light, alpha_squared * (one - light) * (one + light)));
            const auto density = hn::MulAdd(k, c, one);
            const auto all = hn::MulAdd(eye_less_cos, light, cos_theta * towards_light) * density * density;
            sum = sum + hn::IfThenElseZero(light > zero, weight * m * eye * light / all);
        }
        hn::StoreU(hn::Min(hn::Max(cos_gamma, zero), one), d, cos_gamma_out + i);
        hn::StoreU(sum * hn::Sqrt(g_squared) / (a * a) * sin_gamma * cos_gamma, d, seen_out + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {
namespace {

HWY_EXPORT(seen_facets_at);

constexpr double half_pi = 0.5 * std::numbers::pi;
constexpr double turn_per_deg = half_pi / 90.0;
// With these and `PointAround`s the means of smooth colours err by 1e-5 at all roughnesses and angles
// (tests/nacre/shade/roughness_test.cpp).
constexpr int points_between_borders = 8;
// Borders lie by such a factor farther and farther from where the integrand is steep, the first at half a width.
constexpr double growth = 4.0;
constexpr double first_border = 0.5;
// Intervals that are shorter, in units of alpha, hold nothing.
constexpr double shortest = 1e-9;
// Facets that lean by 1e-8 are a mirror.
constexpr double least_roughness = 1e-4;

// Crowded at 1, where a square root may begin: x (2 - x) for x.
GaussPoint crowded(const GaussPoint& point) {
    return {point.at * (2.0 - point.at), 2.0 * (1.0 - point.at) * point.weight};
}

// Offsets between which rules begin and end, ascending. @param last  beyond it the light would come from below
std::vector<double> borders_of(double alpha, double theta, double last, std::span<const double> angles_rad) {
    std::vector<double> borders{-theta, last - theta};
    const auto add = [&](double offset) {
        if (offset > borders[0] && offset < borders[1]) borders.push_back(offset);
    };
    for (double width = first_border * alpha; width < half_pi; width *= growth) {
        add(width);
        add(-width);
    }
    // Beyond the first of these, light from one side comes from below. It is as steep there, and before the last.
    for (double width = 0.5 * (half_pi - theta); width > shortest && width < half_pi; width *= growth) {
        add(width - theta);
        add(last - width - theta);
    }
    for (const double angle : angles_rad) add(angle - theta);
    std::sort(borders.begin(), borders.end());
    return borders;
}

}  // namespace

RoughFacets::RoughFacets() : between_borders_(unit_gauss_legendre(points_between_borders)) {
    const std::vector<GaussPoint> rule = unit_gauss_legendre(static_cast<int>(around_.size()));
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const GaussPoint part = crowded(rule[i]);
        around_[i] = {std::sin(half_pi * rule[i].at), 2.0 * half_pi * rule[i].weight, part.at, 2.0 * part.weight};
    }
}

std::vector<Facet> RoughFacets::at(double roughness, const Incidence& incidence,
                                   std::span<const double> angles_rad) const {
    if (roughness < least_roughness) return {{incidence.cos_theta, 1.0}};
    const double alpha = roughness * roughness;
    const double theta = incidence.theta_deg * turn_per_deg;
    const double cos_theta = incidence.cos_theta;
    const double sin_squared = (1.0 - cos_theta) * (1.0 + cos_theta);
    const double eye = cos_theta + std::sqrt(cos_theta * cos_theta + alpha * alpha * sin_squared);
    const RoughView view{alpha, std::sqrt((1.0 - alpha) * (1.0 + alpha)), cos_theta, std::sin(theta), eye};
    std::vector<double> half_sines;
    std::vector<double> weights;
    const std::vector<double> borders = borders_of(alpha, theta, 0.5 * (half_pi + theta), angles_rad);
    for (std::size_t i = 1; i < borders.size(); ++i) {
        const double length = borders[i] - borders[i - 1];
        if (!(length > shortest * alpha)) continue;
        for (const GaussPoint& even : between_borders_) {
            const GaussPoint point = i + 1 == borders.size() ? crowded(even) : even;
            half_sines.push_back(std::sin(0.5 * (borders[i - 1] + length * point.at)));
            weights.push_back(length * point.weight);
        }
    }
    std::vector<double> cosines(half_sines.size());
    std::vector<double> seen(half_sines.size());
    HWY_DYNAMIC_DISPATCH(seen_facets_at)
    (view, around_, half_sines.data(), half_sines.size(), cosines.data(), seen.data());
    std::vector<Facet> facets;
    facets.reserve(weights.size());
    double all = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        facets.push_back({cosines[i], weights[i] * seen[i]});
        all += facets.back().share;
    }
    if (!(all > 0.0)) return {{cos_theta, 1.0}};
    for (Facet& facet : facets) facet.share /= all;
    return facets;
}

}  // namespace nacre
#endif  // HWY_ONCE
