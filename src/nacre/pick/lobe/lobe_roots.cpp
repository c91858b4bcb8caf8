#include "nacre/pick/lobe/lobe_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "nacre/colour/colour_types.h"

namespace nacre {
namespace {

constexpr std::size_t peaks = 118;
constexpr std::size_t spreads = 48;

// Cells of the (u', v') plane that the triangles are sorted into.
constexpr int buckets_per_side = 96;
constexpr double uv_side = 0.7;

// Barycentric coordinates may be as negative as this: triangles are only nearly where the lobes between them are.
constexpr double slack = 0.15;
constexpr double most_outside = 20.0;

// Lobes as near as this are one.
constexpr double same_peak_nm = 0.05;
constexpr double same_spread = 5e-4;

std::size_t bucket_index(double value) {
    return static_cast<std::size_t>(std::clamp(value / uv_side * buckets_per_side, 0.0, buckets_per_side - 1.0));
}

}  // namespace

LobeRoots::Uv LobeRoots::uv_of(const Xyz& colour) {
    const double per_sum = 1.0 / (colour.x + 15.0 * colour.y + 3.0 * colour.z);
    return {4.0 * colour.x * per_sum, 9.0 * colour.y * per_sum};
}

LobeRoots::LobeRoots(const LobeColours& colours) : colours_(colours), buckets_(buckets_per_side * buckets_per_side) {
    for (std::size_t i = 0; i < peaks; ++i) {
        const double along = static_cast<double>(i) / (peaks - 1);
        const double peak_nm = std::lerp(colours.first_nm(), colours.last_nm(), along);
        for (std::size_t j = 0; j < spreads; ++j) {
            const double spread = static_cast<double>(j) / (spreads - 1);
            const LobePlace place{peak_nm, std::max(spread, LobePlace::narrowest_spread)};
            const Xyz colour = colours.exact(place);
            nodes_.push_back({place, uv_of(colour), colour.y});
        }
    }
    for (std::size_t i = 0; i + 1 < peaks; ++i) {
        for (std::size_t j = 0; j + 1 < spreads; ++j) {
            const std::size_t node = i * spreads + j;
            add_triangle(node, node + 1, node + spreads);
            add_triangle(node + 1, node + spreads, node + spreads + 1);
        }
    }
}

void LobeRoots::add_triangle(std::size_t a, std::size_t b, std::size_t c) {
    const std::array<Uv, 3> corners{nodes_[a].uv, nodes_[b].uv, nodes_[c].uv};
    Uv low{1e9, 1e9};
    Uv high{-1e9, -1e9};
    for (const Uv& uv : corners) {
        if (!std::isfinite(uv.u) || !std::isfinite(uv.v)) return;  // no light at all
        low = {std::min(low.u, uv.u), std::min(low.v, uv.v)};
        high = {std::max(high.u, uv.u), std::max(high.v, uv.v)};
    }
    const Uv margin{slack * (high.u - low.u), slack * (high.v - low.v)};
    const auto triangle = static_cast<std::uint32_t>(triangles_.size() / 3);
    for (const std::size_t corner : {a, b, c}) triangles_.push_back(static_cast<std::uint32_t>(corner));
    for (std::size_t row = bucket_index(low.v - margin.v); row <= bucket_index(high.v + margin.v); ++row) {
        for (std::size_t column = bucket_index(low.u - margin.u); column <= bucket_index(high.u + margin.u); ++column)
            buckets_[row * buckets_per_side + column].push_back(triangle);
    }
}

// The lobe that is where the target is, were the triangle flat.
// @param outside  receives how far the target is outside, in heights of the triangle
LobePlace LobeRoots::start_in(std::size_t triangle, Uv target, double& outside) const {
    const Node& a = nodes_[triangles_[3 * triangle]];
    const Node& b = nodes_[triangles_[3 * triangle + 1]];
    const Node& c = nodes_[triangles_[3 * triangle + 2]];
    const double bu = b.uv.u - a.uv.u, bv = b.uv.v - a.uv.v;
    const double cu = c.uv.u - a.uv.u, cv = c.uv.v - a.uv.v;
    const double tu = target.u - a.uv.u, tv = target.v - a.uv.v;
    const double area = bu * cv - bv * cu;
    const double beta = (tu * cv - tv * cu) / area;
    const double gamma = (bu * tv - bv * tu) / area;
    outside = std::numeric_limits<double>::infinity();
    if (!std::isfinite(beta) || !std::isfinite(gamma)) return {};  // its corners lie on a line
    outside = std::max({-beta, -gamma, beta + gamma - 1.0});
    if (!(outside <= most_outside)) return {};
    return colours_.clamped(
        {a.place.peak_nm + beta * (b.place.peak_nm - a.place.peak_nm) + gamma * (c.place.peak_nm - a.place.peak_nm),
         a.place.spread + beta * (b.place.spread - a.place.spread) + gamma * (c.place.spread - a.place.spread)});
}

// Newton's method on the chromaticity, its slopes by differences.
bool LobeRoots::solve(Uv target, LobePlace& place) const {
    constexpr int most_steps = 8;
    constexpr double near_enough = 1e-6;
    constexpr double step_nm = 0.05;
    constexpr double step_spread = 2e-4;
    for (int step = 0; step < most_steps; ++step) {
        const Uv here = uv_of(colours_.fast(place));
        const double u = target.u - here.u, v = target.v - here.v;
        if (!(std::abs(u) + std::abs(v) < 1.0)) return false;
        if (std::abs(u) + std::abs(v) < near_enough) return true;
        const Uv by_peak = uv_of(colours_.fast({place.peak_nm + step_nm, place.spread}));
        const Uv by_spread = uv_of(colours_.fast({place.peak_nm, place.spread + step_spread}));
        const double uu = (by_peak.u - here.u) / step_nm, vu = (by_peak.v - here.v) / step_nm;
        const double us = (by_spread.u - here.u) / step_spread, vs = (by_spread.v - here.v) / step_spread;
        const double area = uu * vs - vu * us;
        const double nm = (u * vs - v * us) / area, spread = (uu * v - vu * u) / area;
        if (!std::isfinite(nm) || !std::isfinite(spread)) return false;
        constexpr double longest_nm = 20.0;
        constexpr double longest_spread = 0.1;
        place = colours_.clamped({place.peak_nm + std::clamp(nm, -longest_nm, longest_nm),
                                  place.spread + std::clamp(spread, -longest_spread, longest_spread)});
    }
    const Uv here = uv_of(colours_.fast(place));
    return std::abs(target.u - here.u) + std::abs(target.v - here.v) < near_enough;
}

void LobeRoots::add_root(Uv target, LobePlace start, Found& found) const {
    const auto is_known = [&](LobePlace place, double nm, double spread) {
        return std::any_of(found.places.begin(), found.places.begin() + found.count, [&](const LobePlace& root) {
            return std::abs(root.peak_nm - place.peak_nm) < nm && std::abs(root.spread - place.spread) < spread;
        });
    };
    // Triangles overlap by their slack: a start beside a root leads to it.
    constexpr double beside_nm = 0.3;
    constexpr double beside_spread = 2e-3;
    if (is_known(start, beside_nm, beside_spread)) return;
    if (!solve(target, start)) {
        found.unsolved = start;
        return;
    }
    if (found.count < found.places.size() && !is_known(start, same_peak_nm, same_spread))
        found.places[found.count++] = start;
}

LobeRoots::Found LobeRoots::find(const Xyz& colour) const {
    Found found;
    const Uv uv = uv_of(colour);
    LobePlace nearest;
    double least_outside = std::numeric_limits<double>::infinity();
    for (const std::uint32_t triangle : buckets_[bucket_index(uv.v) * buckets_per_side + bucket_index(uv.u)]) {
        double outside = 0.0;
        const LobePlace place = start_in(triangle, uv, outside);
        if (!(outside <= most_outside)) continue;
        if (outside < least_outside) {
            least_outside = outside;
            nearest = place;
        }
        if (outside <= slack) add_root(uv, place, found);
    }
    // Next to the locus triangles are thin, and it is their chords that they end at.
    if (found.count == 0 && least_outside > slack && least_outside <= most_outside) add_root(uv, nearest, found);
    return found;
}

LobePlace LobeRoots::nearest_node(const Xyz& colour) const {
    const Uv uv = uv_of(colour);
    const Node* nearest = &nodes_.front();
    double least = std::numeric_limits<double>::infinity();
    for (const Node& node : nodes_) {
        const double u = node.uv.u - uv.u, v = node.uv.v - uv.v;
        const double square = u * u + v * v;
        if (!(square < least) || node.y < colour.y) continue;
        least = square;
        nearest = &node;
    }
    return nearest->place;
}

}  // namespace nacre
