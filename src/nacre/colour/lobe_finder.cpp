#include "nacre/colour/lobe_finder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "nacre/colour/adaptation.h"

namespace nacre {
namespace {

constexpr double widest_nm = 1000.0;
constexpr double narrowest_spread = 0.01;  // a tenth of a nanometre: the locus itself
constexpr int peaks = 118;
constexpr int spreads = 48;

// Cells of the CIE 1976 (u', v') plane that the triangles are sorted into.
constexpr int buckets_per_side = 96;
constexpr double uv_side = 0.7;

// Barycentric coordinates may be as negative as this: triangles are only nearly where the lobes between them are.
constexpr double slack = 0.15;
constexpr double most_outside = 20.0;

constexpr double same_peak_nm = 0.05;
constexpr double same_spread = 5e-4;

std::size_t bucket_index(double value) {
    return static_cast<std::size_t>(std::clamp(value / uv_side * buckets_per_side, 0.0, buckets_per_side - 1.0));
}

// Solves a symmetric positive definite 3 x 3 system by elimination.
std::array<double, 3> solve3(std::array<std::array<double, 3>, 3> a, std::array<double, 3> b) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i + 1; j < 3; ++j) {
            const double factor = a[j][i] / a[i][i];
            for (std::size_t k = i; k < 3; ++k) a[j][k] -= factor * a[i][k];
            b[j] -= factor * b[i];
        }
    }
    for (std::size_t i = 3; i-- > 0;) {
        for (std::size_t k = i + 1; k < 3; ++k) b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    return b;
}

double square_sum(const std::array<double, 3>& parts) {
    return parts[0] * parts[0] + parts[1] * parts[1] + parts[2] * parts[2];
}

// Of a lobe that is as light as the target, as far as a surface goes.
double height_for(const Lab& target, double unit_y) {
    constexpr double least = 1e-6;
    const double root = (target.l + 16.0) / 116.0;
    const double y = root > 6.0 / 29.0 ? root * root * root : target.l * 27.0 / 24389.0;
    return std::clamp(unit_y > 0.0 ? y / unit_y : 1.0, least, 1.0);
}

Xyz scaled(const Xyz& colour, double factor) {
    return {factor * colour.x, factor * colour.y, factor * colour.z};
}

}  // namespace

LobeFinder::Uv LobeFinder::uv_of(Xyz colour) {
    const double sum = colour.x + 15.0 * colour.y + 3.0 * colour.z;
    return {4.0 * colour.x / sum, 9.0 * colour.y / sum};
}

double LobeFinder::width_nm(double spread) {
    return widest_nm * spread * spread;
}

LobeFinder::LobeFinder(const TristimulusWeights& weights, const LobeMoments& moments, const glm::dmat3& adaptation)
    : weights_(weights),
      moments_(moments),
      adaptation_(adaptation),
      white_(xyz_from_chromaticity(d65_chromaticity)),
      buckets_(buckets_per_side * buckets_per_side) {
    for (int i = 0; i < peaks; ++i) {
        const double along = static_cast<double>(i) / (peaks - 1);
        const double peak_nm = std::lerp(weights.first_nm, weights.last_nm, along);
        for (int j = 0; j < spreads; ++j) {
            const Place place{peak_nm, std::max(static_cast<double>(j) / (spreads - 1), narrowest_spread)};
            const Xyz colour = exact_colour_of(place);
            nodes_.push_back({place, colour, uv_of(colour)});
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

void LobeFinder::add_triangle(std::size_t a, std::size_t b, std::size_t c) {
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

// The fast integral's error is that of white's parts: too much of a narrow lobe's dark colour, and slopes are
// differences.
Xyz LobeFinder::colour_of(Place place) const {
    constexpr double narrow = 0.3;  // 90 nm
    if (place.spread < narrow) return exact_colour_of(place);
    return adapt(adaptation_, lobe_to_xyz_fast(weights_, moments_, place.peak_nm, width_nm(place.spread), 1.0));
}

Xyz LobeFinder::exact_colour_of(Place place) const {
    return adapt(adaptation_, lobe_to_xyz(weights_, place.peak_nm, width_nm(place.spread), 1.0));
}

LobeFinder::Place LobeFinder::clamped(Place place) const {
    const auto first = static_cast<double>(weights_.first_nm);
    const auto last = static_cast<double>(weights_.last_nm);
    return {std::clamp(place.peak_nm, first, last), std::clamp(place.spread, narrowest_spread, 1.0)};
}

// The lobe that is where the target is, were the triangle flat.
// @param outside  receives how far the target is outside, in heights of the triangle
LobeFinder::Place LobeFinder::start_in(std::uint32_t triangle, Uv target, double& outside) const {
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
    return clamped(
        {a.place.peak_nm + beta * (b.place.peak_nm - a.place.peak_nm) + gamma * (c.place.peak_nm - a.place.peak_nm),
         a.place.spread + beta * (b.place.spread - a.place.spread) + gamma * (c.place.spread - a.place.spread)});
}

// Newton's method on the chromaticity, its slopes by differences.
bool LobeFinder::solve(Uv target, Place& place) const {
    constexpr int most_steps = 8;
    constexpr double near_enough = 1e-6;
    constexpr double step_nm = 0.05;
    constexpr double step_spread = 2e-4;
    for (int step = 0; step < most_steps; ++step) {
        const Uv here = uv_of(colour_of(place));
        const double u = target.u - here.u, v = target.v - here.v;
        if (!(std::abs(u) + std::abs(v) < 1.0)) return false;
        if (std::abs(u) + std::abs(v) < near_enough) return true;
        const Place beside{place.peak_nm + step_nm, place.spread};
        const Place wider{place.peak_nm, place.spread + step_spread};
        const Uv by_peak = uv_of(colour_of(beside)), by_spread = uv_of(colour_of(wider));
        const double uu = (by_peak.u - here.u) / step_nm, vu = (by_peak.v - here.v) / step_nm;
        const double us = (by_spread.u - here.u) / step_spread, vs = (by_spread.v - here.v) / step_spread;
        const double area = uu * vs - vu * us;
        const double nm = (u * vs - v * us) / area, spread = (uu * v - vu * u) / area;
        if (!std::isfinite(nm) || !std::isfinite(spread)) return false;
        constexpr double longest_nm = 20.0;
        constexpr double longest_spread = 0.1;
        place = clamped({place.peak_nm + std::clamp(nm, -longest_nm, longest_nm),
                         place.spread + std::clamp(spread, -longest_spread, longest_spread)});
    }
    const Uv here = uv_of(colour_of(place));
    return std::abs(target.u - here.u) + std::abs(target.v - here.v) < near_enough;
}

LobeMatch LobeFinder::match(const Lab& target, Place place, double height) const {
    const double de00 = ciede2000(target, to_lab(scaled(exact_colour_of(place), height), white_));
    return {place.peak_nm, width_nm(place.spread), height, de00, LobeMiss::none};
}

// The best of a part of the table. CIEDE2000 itself has to say so, because it is no simple bowl: a purple may have its
// nearest among reds, among violets, and next to grey where the hue is opposite, its rotation being largest there.
std::vector<LobeFinder::Place> LobeFinder::seeds_for(const Lab& target) const {
    constexpr std::size_t peak_step = 3;
    constexpr std::size_t spread_step = 3;
    std::vector<std::pair<double, std::size_t>> seeds;
    for (std::size_t i = 0; i < peaks; i += peak_step) {
        for (std::size_t j = spreads - 1; j > 0; j -= std::min(j, spread_step)) {
            const std::size_t node = i * spreads + j;
            const double height = height_for(target, nodes_[node].colour.y);
            seeds.emplace_back(ciede2000(target, to_lab(scaled(nodes_[node].colour, height), white_)), node);
        }
    }
    std::sort(seeds.begin(), seeds.end());
    constexpr std::size_t most = 5;
    constexpr double apart_nm = 30.0;
    constexpr double apart_spread = 0.2;
    std::vector<Place> places;
    for (const auto& [error, node] : seeds) {
        if (places.size() == most) break;
        const Place& place = nodes_[node].place;
        const bool is_near = std::any_of(places.begin(), places.end(), [&](const Place& other) {
            return std::abs(place.peak_nm - other.peak_nm) < apart_nm &&
                   std::abs(place.spread - other.spread) < apart_spread;
        });
        if (!is_near) places.push_back(place);
    }
    return places;
}

// Levenberg and Marquardt's method in peak, spread and the cube root of the height, within their bounds.
LobeMatch LobeFinder::refined(const Lab& target, Place start) const {
    struct Point {
        Place place;
        double root;
    };
    const auto parts_at = [&](const Xyz& unit, double root) {
        return ciede2000_parts(target, to_lab(scaled(unit, root * root * root), white_));
    };
    // Beside dark colours the fast integral's error counts, and so it does at the end.
    constexpr double dark = 15.0;
    constexpr double is_near = 0.25;
    bool is_precise = target.l < dark;
    const auto colour_at = [&](Place place) { return is_precise ? exact_colour_of(place) : colour_of(place); };
    Xyz unit = colour_at(start);
    Point point{start, std::cbrt(height_for(target, unit.y))};
    std::array<double, 3> parts = parts_at(unit, point.root);
    double error = square_sum(parts);
    // In steps of these sizes all three count about alike.
    constexpr std::array unit_step{10.0, 0.05, 0.05};
    constexpr double difference = 1e-3;
    const std::array low{static_cast<double>(weights_.first_nm), narrowest_spread, 0.0};
    const std::array high{static_cast<double>(weights_.last_nm), 1.0, 1.0};
    double damping = 1e-3;
    constexpr int most_steps = 60;
    for (int step = 0; step < most_steps; ++step) {
        std::array<std::array<double, 3>, 3> slopes{};  // of each part, per unit step of each variable
        const std::array here{point.place.peak_nm, point.place.spread, point.root};
        for (std::size_t i = 0; i < 3; ++i) {
            // Inwards, where there is a bound.
            const double side = here[i] + difference * unit_step[i] > high[i] ? -difference : difference;
            std::array there = here;
            there[i] += side * unit_step[i];
            const Xyz beside = i == 2 ? unit : colour_at({there[0], there[1]});
            const auto moved = parts_at(beside, there[2]);
            for (std::size_t k = 0; k < 3; ++k) slopes[k][i] = (moved[k] - parts[k]) / side;
        }
        std::array<double, 3> gradient{};
        std::array<std::array<double, 3>, 3> normal{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) gradient[i] += slopes[k][i] * parts[k];
            for (std::size_t j = 0; j < 3; ++j) {
                for (std::size_t k = 0; k < 3; ++k) normal[i][j] += slopes[k][i] * slopes[k][j];
            }
        }
        // What stands at a bound and would go beyond it stays.
        for (std::size_t i = 0; i < 3; ++i) {
            const bool is_stuck = (here[i] <= low[i] && gradient[i] > 0.0) || (here[i] >= high[i] && gradient[i] < 0.0);
            if (!is_stuck) continue;
            gradient[i] = 0.0;
            for (std::size_t j = 0; j < 3; ++j) normal[i][j] = normal[j][i] = 0.0;
            normal[i][i] = 1.0;
        }
        bool has_moved = false;
        double gain = 0.0;
        for (int attempt = 0; attempt < 6 && !has_moved; ++attempt) {
            auto damped = normal;
            for (std::size_t i = 0; i < 3; ++i) damped[i][i] += damping * (normal[i][i] + 1e-3);
            const auto move = solve3(damped, gradient);
            const bool is_usable =
                std::all_of(move.begin(), move.end(), [](double value) { return std::isfinite(value); });
            if (!is_usable) {  // nothing changes with any of them
                damping *= 8.0;
                continue;
            }
            std::array there = here;
            for (std::size_t i = 0; i < 3; ++i)
                there[i] = std::clamp(here[i] - std::clamp(move[i], -3.0, 3.0) * unit_step[i], low[i], high[i]);
            const Point next{{there[0], there[1]}, there[2]};
            const Xyz next_unit = colour_at(next.place);
            const auto next_parts = parts_at(next_unit, next.root);
            const double next_error = square_sum(next_parts);
            if (next_error < error) {
                gain = error - next_error;
                point = next;
                unit = next_unit;
                parts = next_parts;
                error = next_error;
                damping = std::max(0.2 * damping, 1e-9);
                has_moved = true;
            } else {
                damping *= 8.0;
            }
        }
        if (!is_precise && error < is_near) {
            is_precise = true;
            unit = colour_at(point.place);
            parts = parts_at(unit, point.root);
            error = square_sum(parts);
            continue;
        }
        if (!has_moved || error < 1e-6 || gain < 1e-4 * error * std::min(1.0, error)) break;
    }
    return match(target, point.place, point.root * point.root * point.root);
}

LobeMatch LobeFinder::find(Xyz colour) const {
    assert(std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z));
    const Lab target = to_lab(colour, white_);
    // Black has no chromaticity.
    constexpr double black = 1e-7;
    const auto middle_nm = 0.5 * (weights_.first_nm + weights_.last_nm);
    const double sum = colour.x + 15.0 * colour.y + 3.0 * colour.z;
    if (std::abs(colour.x) + std::abs(colour.y) + std::abs(colour.z) < black) return {middle_nm, 0.0, 0.0, 0.0, {}};

    bool has_chromaticity = false;
    LobeMatch widest;
    bool is_found = false;
    std::optional<Place> unsolved;
    std::array<Place, 16> roots{};
    std::size_t count = 0;
    if (sum > 0.0 && colour.y > 0.0) {
        const Uv uv = uv_of(colour);
        const std::size_t bucket = bucket_index(uv.v) * buckets_per_side + bucket_index(uv.u);
        const auto try_root = [&](Place place) {
            if (!solve(uv, place)) {
                unsolved = place;
                return false;
            }
            const bool is_known = std::any_of(roots.begin(), roots.begin() + count, [&](const Place& root) {
                return std::abs(root.peak_nm - place.peak_nm) < same_peak_nm &&
                       std::abs(root.spread - place.spread) < same_spread;
            });
            if (is_known || count == roots.size()) return true;
            roots[count++] = place;
            const double height = colour.y / exact_colour_of(place).y;
            constexpr double rounding = 1e-6;
            if (!(height <= 1.0 + rounding)) return true;
            const LobeMatch candidate = match(target, place, std::min(height, 1.0));
            if (candidate.de00 > exact_lobe_de00) return true;
            if (!is_found || candidate.width_nm > widest.width_nm) widest = candidate;
            is_found = true;
            return true;
        };
        Place nearest;
        double least_outside = std::numeric_limits<double>::infinity();
        for (const std::uint32_t triangle : buckets_[bucket]) {
            double outside = 0.0;
            const Place place = start_in(triangle, uv, outside);
            if (!(outside <= most_outside)) continue;
            if (outside < least_outside) {
                least_outside = outside;
                nearest = place;
            }
            if (outside <= slack) try_root(place);
        }
        // Next to the locus triangles are thin, and it is their chords that they end at.
        if (count == 0 && least_outside > slack && least_outside <= most_outside) try_root(nearest);
        has_chromaticity = count > 0;
    }
    if (is_found) return widest;
    // Where all lobes of some widths, or beyond some wavelength, have one chromaticity, it says nothing about either.
    LobeMatch best;
    best.de00 = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count && best.de00 > exact_lobe_de00; ++i) {
        const LobeMatch candidate = refined(target, roots[i]);
        if (candidate.de00 < best.de00) best = candidate;
    }
    if (unsolved && best.de00 > exact_lobe_de00) {
        const LobeMatch candidate = refined(target, *unsolved);
        if (candidate.de00 < best.de00) best = candidate;
    }
    if (best.de00 <= exact_lobe_de00) return best;

    for (const Place& seed : seeds_for(target)) {
        const LobeMatch candidate = refined(target, seed);
        if (candidate.de00 < best.de00) best = candidate;
    }
    if (best.de00 > exact_lobe_de00) best.miss = has_chromaticity ? LobeMiss::bright : LobeMiss::saturated;
    return best;
}

}  // namespace nacre
