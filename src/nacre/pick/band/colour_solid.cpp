#include "nacre/pick/band/colour_solid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace nacre {
namespace {

// Wavelengths of the jumps of which the first planes consist; a few steps of Newton's method lead from their best on.
constexpr std::size_t first_jumps = 24;

constexpr int most_turns = 60;
constexpr int most_halvings = 40;
constexpr double flat_direction = 1e-11;  // of the curvature: where there is one jump, F is flat in one direction
constexpr double longest_turn = 1.0;      // of the length of n
constexpr double fine_nm = 1e-5;          // CIEDE2000 0.001
constexpr double hardly_doubtful = 1e-5;  // slope for the length of n, relative to the least value

glm::dvec3 vector_of(const Xyz& c) {
    return {c.x, c.y, c.z};
}

}  // namespace

// F at n, with its slope and its second derivatives.
struct ColourSolid::Support {
    double value = 0.0;
    glm::dvec3 slope{0.0};
    glm::dmat3 curvature{0.0};
};

ColourSolid::ColourSolid(const TristimulusWeights& weights) : weights_(weights) {
    std::vector<glm::dvec3> lit;
    for (std::size_t i = 0; i < static_cast<std::size_t>(weights.count()); ++i) {
        if (const glm::dvec3 w = node(i); w.x + w.y + w.z > 0.0) lit.push_back(w);
    }
    const auto jump = [&](std::size_t i) { return lit[i * (lit.size() - 1) / (first_jumps - 1)]; };
    for (std::size_t i = 0; i < first_jumps; ++i) {
        for (std::size_t j = i + 1; j < first_jumps; ++j) {
            const glm::dvec3 n = glm::cross(jump(i), jump(j));
            for (const double sign : {1.0, -1.0}) {
                if (const double value = support(sign * n).value; value > 0.0) touching_.push_back(sign * n / value);
            }
        }
    }
}

// Calls visit(nm, weight, slope of n . w) wherever n . w begins or ends to be positive.
//
// @return whether n . w is positive at the end of the spectrum
template <typename Visit>
bool ColourSolid::visit_jumps(const glm::dvec3& n, const Visit& visit) const {
    const auto count = static_cast<std::size_t>(weights_.count());
    const auto height_of = [&](std::size_t i) {
        return n.x * weights_.x[i] + n.y * weights_.y[i] + n.z * weights_.z[i];
    };
    double height = height_of(0);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double next = height_of(i + 1), slope = next - height;
        if ((height > 0.0) != (next > 0.0)) {
            const double t = -height / slope,
                         nm = weights_.first_nm + (static_cast<double>(i) + t) / weights_.cells_per_nm;
            visit(nm, (1.0 - t) * node(i) + t * node(i + 1), slope);
        }
        height = next;
    }
    return height > 0.0;
}

glm::dvec3 ColourSolid::node(std::size_t i) const {
    return {weights_.x[i], weights_.y[i], weights_.z[i]};
}

glm::dvec3 ColourSolid::integral_to(double nm) const {
    return vector_of(plateau_to_xyz(weights_, weights_.first_nm, nm));
}

ColourSolid::Support ColourSolid::support(const glm::dvec3& n) const {
    Support sum;
    const bool ends_positive = visit_jumps(n, [&](double nm, const glm::dvec3& weight, double slope) {
        sum.slope += (slope > 0.0 ? -1.0 : 1.0) * integral_to(nm);
        sum.curvature += glm::outerProduct(weight, weight) / std::abs(slope);
    });
    if (ends_positive) sum.slope += vector_of(weights_.white);
    sum.value = glm::dot(n, sum.slope);
    return sum;
}

glm::dvec3 ColourSolid::best_touching(const glm::dvec3& colour) const {
    double most = 0.0;
    const glm::dvec3* best = &touching_.front();
    for (const glm::dvec3& n : touching_) {
        const double along = glm::dot(n, colour);
        if (along > most) {
            most = along;
            best = &n;
        }
    }
    return *best / glm::dot(*best, colour);
}

// Of all stretches the one with the greatest integral of n . w: the largest sum of neighbours, over the jumps.
ColourSolid::Stretch ColourSolid::best_stretch(const glm::dvec3& n) const {
    struct Place {
        double nm, integral;
    };
    Place least{static_cast<double>(weights_.first_nm), 0.0}, greatest = least;
    double rise = 0.0, fall = 0.0;
    Stretch band{BandKind::band, least.nm, least.nm}, notch{BandKind::notch, least.nm, least.nm};
    const auto see = [&](const Place& here) {
        if (here.integral - least.integral > rise) {
            rise = here.integral - least.integral;
            band = {BandKind::band, least.nm, here.nm};
        }
        if (greatest.integral - here.integral > fall) {
            fall = greatest.integral - here.integral;
            notch = {BandKind::notch, greatest.nm, here.nm};
        }
        if (here.integral < least.integral) least = here;
        if (here.integral > greatest.integral) greatest = here;
    };
    visit_jumps(n, [&](double nm, const glm::dvec3&, double) { see({nm, glm::dot(n, integral_to(nm))}); });
    const double whole = glm::dot(n, vector_of(weights_.white));
    see({static_cast<double>(weights_.last_nm), whole});
    return rise >= whole + fall ? band : notch;
}

// The step of Newton's method in the plane n . colour = 1, and how much of the least value is doubtful without it.
//
// @param target  the colour
ColourSolid::Step ColourSolid::newton_step(const glm::dvec3& target, const glm::dvec3& n, const Support& here) const {
    const glm::dvec3 across =
        glm::normalize(glm::cross(target, target.y > target.x ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 other = glm::normalize(glm::cross(target, across));
    const double slope_a = glm::dot(here.slope, across), slope_b = glm::dot(here.slope, other);
    const glm::dvec3 curve_a = here.curvature * across, curve_b = here.curvature * other;
    const double damped = flat_direction * (glm::dot(curve_a, across) + glm::dot(curve_b, other)) + 1e-100;
    const double aa = glm::dot(curve_a, across) + damped, bb = glm::dot(curve_b, other) + damped;
    const double ab = glm::dot(curve_a, other), area = aa * bb - ab * ab;
    const glm::dvec3 step =
        ((ab * slope_b - bb * slope_a) / area) * across + ((ab * slope_a - aa * slope_b) / area) * other;
    const double shortening = std::min(1.0, longest_turn * glm::length(n) / glm::length(step));
    return {shortening * step, std::hypot(slope_a, slope_b) * glm::length(n) / here.value};
}

ColourSolid::Boundary ColourSolid::along(const Xyz& colour) const {
    const glm::dvec3 target = vector_of(colour);
    glm::dvec3 n = best_touching(target);
    Support here = support(n);
    bool has_crossed = false;
    for (int i = 0; i < most_turns && here.value > least_share; ++i) {
        auto [step, doubt] = newton_step(target, n, here);
        if (doubt < hardly_doubtful) break;
        Support next;
        for (int halvings = 0; halvings < most_halvings; ++halvings, step *= 0.5) {
            next = support(n + step);
            if (next.value < here.value) break;
        }
        // Beyond 700 nm all weights point one way: n . w may be 0 there at once, and the slope is then that of one
        // side.
        const bool is_lower = next.value < here.value;
        if (!is_lower && has_crossed) break;
        has_crossed = !is_lower;
        n += step;
        here = next;
    }
    return here.value > least_share ? Boundary{here.value, best_stretch(n)} : Boundary{};
}

double ColourSolid::nm_of_luminance(double luminance) const {
    const std::vector<Xyz>& running = weights_.cumulative;
    const auto after = std::upper_bound(running.begin() + 1, running.end() - 1, luminance,
                                        [](double value, const Xyz& here) { return value < here.y; });
    const auto cell = static_cast<std::size_t>(after - running.begin()) - 1;
    // The weight is linear in the cell: a quadratic equation.
    const double left = weights_.y[cell], rest = luminance - running[cell].y;
    const double root = left * left + 2.0 * (weights_.y[cell + 1] - left) * rest;
    const double t = 2.0 * rest / (left + std::sqrt(std::max(root, 0.0)));
    return weights_.first_nm + static_cast<double>(cell) + (t > 0.0 ? std::min(t, 1.0) : 0.0);
}

// The stretch that begins or ends at a wavelength and has a luminance, if need be across the ends of the spectrum.
ColourSolid::Stretch ColourSolid::stretch_at(double nm, bool is_end, double luminance) const {
    const double here = plateau_to_xyz(weights_, weights_.first_nm, nm).y;
    if (is_end) {
        if (here >= luminance) return {BandKind::band, nm_of_luminance(here - luminance), nm};
        return {BandKind::notch, nm, nm_of_luminance(here - luminance + 1.0)};
    }
    if (here + luminance <= 1.0) return {BandKind::band, nm, nm_of_luminance(here + luminance)};
    return {BandKind::notch, nm_of_luminance(here + luminance - 1.0), nm};
}

Xyz ColourSolid::colour_of(const Stretch& stretch) const {
    const Xyz up = plateau_to_xyz(weights_, stretch.from_nm, stretch.to_nm);
    if (stretch.kind == BandKind::band) return up;
    return {weights_.white.x - up.x, weights_.white.y - up.y, weights_.white.z - up.z};
}

// All stretches of one luminance are a closed curve around white (MacAdam's limits). Where it runs fast along one of
// their ends, it is slow along the other.
ColourSolid::Stretch ColourSolid::nearest(const Xyz& colour) const {
    const double luminance = std::min(colour.y, 1.0);
    Stretch best;
    double least = std::numeric_limits<double>::infinity();
    const auto comes_nearer = [&](double nm, bool is_end) {
        if (nm < weights_.first_nm || nm > weights_.last_nm) return false;
        const Stretch stretch = stretch_at(nm, is_end, luminance);
        const Xyz here = colour_of(stretch);
        const double distance = std::hypot(here.x - colour.x, here.z - colour.z);
        if (!(distance < least)) return false;
        least = distance;
        best = stretch;
        return true;
    };
    for (int nm = weights_.first_nm; nm <= weights_.last_nm; ++nm) {
        for (const bool is_end : {false, true}) comes_nearer(nm, is_end);
    }
    for (double step_nm = 0.5; step_nm > fine_nm;) {
        const Stretch centre = best;
        bool is_nearer = false;
        for (const double step : {-step_nm, step_nm}) {
            is_nearer |= comes_nearer(centre.from_nm + step, centre.kind == BandKind::notch);
            is_nearer |= comes_nearer(centre.to_nm + step, centre.kind == BandKind::band);
        }
        if (!is_nearer) step_nm *= 0.5;
    }
    return best;
}

}  // namespace nacre
