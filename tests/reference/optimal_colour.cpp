#include "reference/optimal_colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nacre::reference {
namespace {

double dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triple times(double factor, const Triple& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

// In the plane n . colour = 1.
struct Point {
    double u = 0.0, v = 0.0;
};
using Polygon = std::vector<Point>;

// Relative to a corner, because thin polygons far from the origin have little area.
Point centre_of(const Polygon& polygon, double& area) {
    const Point& origin = polygon.front();
    Point sum;
    area = 0.0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const double u1 = polygon[i].u - origin.u, v1 = polygon[i].v - origin.v;
        const double u2 = polygon[i + 1].u - origin.u, v2 = polygon[i + 1].v - origin.v;
        const double twice = u1 * v2 - u2 * v1;
        area += twice;
        sum = {sum.u + twice * (u1 + u2), sum.v + twice * (v1 + v2)};
    }
    return {origin.u + sum.u / (3.0 * area), origin.v + sum.v / (3.0 * area)};
}

// What of a polygon lies on the side of a point that a slope points away from.
Polygon cut(const Polygon& polygon, const Point& at, const Point& slope) {
    const auto height = [&](const Point& p) { return slope.u * (p.u - at.u) + slope.v * (p.v - at.v); };
    Polygon rest;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double ha = height(a), hb = height(b);
        if (ha <= 0.0) rest.push_back(a);
        if ((ha < 0.0 && hb > 0.0) || (ha > 0.0 && hb < 0.0)) {
            const double t = ha / (ha - hb);
            rest.push_back({a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)});
        }
    }
    return rest;
}

}  // namespace

OptimalColours::OptimalColours(const ModelLight& light) : weights_(light.weights()) {
    for (std::size_t i = 0; i + 1 < weights_.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) white_[c] += 0.5 * (weights_[i][c] + weights_[i + 1][c]);
    for (Triple& weight : weights_)
        for (std::size_t c = 0; c < 3; ++c) weight[c] /= white_[c];
}

OptimalColours::Value OptimalColours::integral_of_positive_part(const Triple& n) const {
    Value sum;
    double left = dot(n, weights_[0]);
    for (std::size_t i = 0; i + 1 < weights_.size(); ++i) {
        const double right = dot(n, weights_[i + 1]);
        if (left > 0.0 || right > 0.0) {
            // The part [from, to] of the nanometre where the linear function is positive.
            const double from = left < 0.0 ? left / (left - right) : 0.0;
            const double to = right < 0.0 ? left / (left - right) : 1.0;
            const double share_of_right = 0.5 * (to - from) * (to + from);
            const double share_of_left = (to - from) - share_of_right;
            for (std::size_t c = 0; c < 3; ++c)
                sum.slope[c] += share_of_left * weights_[i][c] + share_of_right * weights_[i + 1][c];
        }
        left = right;
    }
    sum.value = dot(n, sum.slope);
    return sum;
}

double OptimalColours::brightest_share(const Triple& colour) const {
    Triple target{};
    for (std::size_t c = 0; c < 3; ++c) target[c] = colour[c] / white_[c];
    const double length = std::sqrt(dot(target, target));
    if (!(length > 0.0)) return 0.0;
    const Triple along = times(1.0 / length, target);
    const Triple other = std::abs(along[0]) < 0.6 ? Triple{1.0, 0.0, 0.0} : Triple{0.0, 1.0, 0.0};
    Triple first = cross(along, other);
    first = times(1.0 / std::sqrt(dot(first, first)), first);
    const Triple second = cross(along, first);

    // In units of 1 / length. Next to the spectral locus n becomes long: 4e6 was seen.
    constexpr double far = 1e9;
    constexpr int most_cuts = 400;
    constexpr double tolerance = 1e-7;
    Polygon polygon{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
    double least = std::numeric_limits<double>::infinity(), lower_bound = 0.0;
    for (int i = 0; i < most_cuts && polygon.size() > 2; ++i) {
        double area = 0.0;
        const Point at = centre_of(polygon, area);
        if (!(area > 0.0) || !std::isfinite(at.u + at.v)) break;
        Triple n{};
        for (std::size_t c = 0; c < 3; ++c) n[c] = along[c] + at.u * first[c] + at.v * second[c];
        const Value here = integral_of_positive_part(n);
        const Point slope{dot(here.slope, first), dot(here.slope, second)};
        least = std::min(least, here.value);
        double lowest = here.value;
        for (const Point& corner : polygon)
            lowest = std::min(lowest, here.value + slope.u * (corner.u - at.u) + slope.v * (corner.v - at.v));
        lower_bound = std::max(lower_bound, lowest);
        if (least - lower_bound <= tolerance * least) break;
        polygon = cut(polygon, at, slope);
    }
    return std::max(least, 0.0) / length;
}

}  // namespace nacre::reference
