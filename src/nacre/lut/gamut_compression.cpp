#include "nacre/lut/gamut_compression.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>

#include "nacre/colour/observer.h"
#include "nacre/colour/oklab.h"
#include "nacre/lut/gamut.h"

namespace nacre {
namespace {

constexpr int hues = 1440;  // 1/4 degree: linear between them, the edge errs by less than `margin`
constexpr double margin = 1e-3;
constexpr double parabola = 0.01 * (360.0 / hues) * (360.0 / hues);  // the edge loses as much within the first degree
constexpr double most_room = 0.2;                                    // the ACES reference begins at 0.8 to 0.88, too
constexpr double most_saturated = 2.0;  // beyond every real colour: those of spectral violets are 1.2

double hue_angle(int index) {
    return 2.0 * std::numbers::pi * index / hues;
}

// In [0, hues].
double hue_index(double a, double b) {
    const double turn = std::atan2(b, a) / (2.0 * std::numbers::pi);
    return hues * (turn < 0.0 ? turn + 1.0 : turn);
}

using Cubic = std::array<double, 4>;  // ascending powers

double value(const Cubic& c, double x) {
    return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
}

// Where a cubic that is positive at 0 first becomes negative; `end` if it does not before.
double first_negative(const Cubic& c, double end) {
    // Between 0, its extrema and the end it is monotone.
    std::array<double, 3> stops{end, end, end};
    const double half = c[2], discriminant = half * half - 3.0 * c[3] * c[1];
    if (discriminant > 0.0) {
        // The form that does not cancel.
        const double q = -(half + std::copysign(std::sqrt(discriminant), half));
        const auto stop = [end](double x) { return x > 0.0 && x < end ? x : end; };
        stops = {stop(q / (3.0 * c[3])), stop(c[1] / q), end};
        std::sort(stops.begin(), stops.end());
    }
    double low = 0.0;
    for (double high : stops) {
        if (value(c, high) >= 0.0) {
            low = high;
            continue;
        }
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (value(c, middle) >= 0.0 ? low : high) = middle;
        }
        return low;
    }
    return end;
}

// The saturation at which the first component of a hue becomes negative.
double hull(const glm::dmat3& rgb_of_cones, double hue) {
    // Of lightness 1 the roots of the cones are 1 + S * slope.
    const glm::dvec3 slope = oklab_roots_of_lab() * glm::dvec3{0.0, std::cos(hue), std::sin(hue)};
    const glm::dvec3 one = oklab_roots_of_lab() * glm::dvec3{1.0, 0.0, 0.0};
    const glm::dvec3 c0 = rgb_of_cones * (one * one * one), c1 = rgb_of_cones * (3.0 * one * one * slope),
                     c2 = rgb_of_cones * (3.0 * one * slope * slope), c3 = rgb_of_cones * (slope * slope * slope);
    double nearest = most_saturated;
    for (int i = 0; i < 3; ++i) nearest = std::min(nearest, first_negative({c0[i], c1[i], c2[i], c3[i]}, nearest));
    return nearest;
}

// The largest curve inside of which every point lies on a parabola inside: corners that stick out become round, and
// where the curve jumps it no longer does. (A morphological opening, in logarithms.)
void round_corners(std::vector<double>& edges) {
    std::vector<double> logs(edges.size());
    std::transform(edges.begin(), edges.end(), logs.begin(), [](double edge) { return std::log(edge); });
    const auto [lowest, highest] = std::minmax_element(logs.begin(), logs.end());
    const auto reach = static_cast<int>(std::sqrt((*highest - *lowest) / parabola)) + 1;
    const auto swept = [&](double sign, const auto& nearest) {
        std::vector<double> result = logs;
        for (int i = 0; i < hues; ++i) {
            for (int offset = -reach; offset <= reach; ++offset) {
                const double other = logs[static_cast<std::size_t>((i + offset + hues) % hues)];
                double& log = result[static_cast<std::size_t>(i)];
                log = nearest(log, other + sign * parabola * offset * offset);
            }
        }
        logs = result;
    };
    swept(1.0, [](double x, double y) { return std::min(x, y); });
    swept(-1.0, [](double x, double y) { return std::max(x, y); });
    std::transform(logs.begin(), logs.end(), edges.begin(), [](double log) { return std::exp(log); });
}

struct Chroma {
    double a, b;  // as fractions of lightness
};

// The outline of real colours: the spectrum from violet to red, and the purples back to violet.
std::vector<Chroma> outline_of_real_colours() {
    constexpr int violet_nm = 400, red_nm = 700, purples = 64;  // beyond, chromaticity hardly moves
    std::vector<Xyz> colours;
    const auto spectral = [](int nm) {
        const auto& [x, y, z] = colour_matching(Observer::cie1931_2deg, nm);
        const double sum = x + y + z;
        return Xyz{x / sum, y / sum, z / sum};
    };
    for (int nm = violet_nm; nm <= red_nm; ++nm) colours.push_back(spectral(nm));
    const Xyz red = spectral(red_nm), violet = spectral(violet_nm);
    for (int i = 1; i <= purples; ++i) {
        const double t = static_cast<double>(i) / purples;
        colours.push_back(
            {std::lerp(red.x, violet.x, t), std::lerp(red.y, violet.y, t), std::lerp(red.z, violet.z, t)});
    }
    std::vector<Chroma> outline;
    for (const Xyz& colour : colours) {
        const Oklab lab = xyz_to_oklab(colour);
        outline.push_back({lab.a / lab.lightness, lab.b / lab.lightness});
    }
    return outline;
}

// Saturation of the most saturated real colour of each hue.
std::vector<double> reaches() {
    std::vector<double> reach(hues, 0.0);
    const std::vector<Chroma> outline = outline_of_real_colours();
    for (std::size_t i = 1; i < outline.size(); ++i) {
        const Chroma p = outline[i - 1], q = outline[i];
        double from = hue_index(p.a, p.b), to = hue_index(q.a, q.b);
        if (from > to) std::swap(from, to);
        if (to - from > 0.5 * hues) {  // through hue 0
            from += hues;
            std::swap(from, to);
        }
        for (int index = static_cast<int>(std::ceil(from)); index <= to; ++index) {
            // S (cos, sin) on the line through p and q.
            const double x = std::cos(hue_angle(index)), y = std::sin(hue_angle(index));
            const double along = x * (q.b - p.b) - y * (q.a - p.a);
            if (along == 0.0) continue;  // the line runs along the hue, and its ends are on others
            double& farthest = reach[static_cast<std::size_t>(index % hues)];
            farthest = std::max(farthest, (p.a * q.b - p.b * q.a) / along);
        }
    }
    return reach;
}

}  // namespace

GamutCompression::GamutCompression(const glm::dmat3& rgb_of_xyz) : rgb_of_xyz_(rgb_of_xyz) {
    const glm::dmat3 rgb_of_cones = rgb_of_xyz * xyz_of_oklab_cones();
    std::vector<double> edges;
    for (int index = 0; index < hues; ++index) edges.push_back((1.0 - margin) * hull(rgb_of_cones, hue_angle(index)));
    round_corners(edges);
    const std::vector<double> reach = reaches();
    for (std::size_t i = 0; i < edges.size(); ++i)
        bounds_.push_back({edges[i], std::clamp(reach[i] / edges[i] - 1.0, 0.0, most_room)});
    bounds_.push_back(bounds_.front());
}

double GamutCompression::nearer(double distance, double room) {
    if (distance <= 1.0 - room) return distance;
    if (room == 0.0) return 1.0;
    const double x = (distance - (1.0 - room)) / room;
    // x / sqrt(1 + x²), which is 1 and not NaN at infinity.
    return 1.0 - room + room / std::sqrt(1.0 + 1.0 / (x * x));
}

GamutCompression::Bound GamutCompression::bound(double a, double b) const {
    const double at = hue_index(a, b);
    const auto low = std::min(static_cast<std::size_t>(at), bounds_.size() - 2);
    const double share = at - static_cast<double>(low);
    const Bound &p = bounds_[low], &q = bounds_[low + 1];
    return {std::lerp(p.edge, q.edge, share), std::lerp(p.room, q.room, share)};
}

Rgb GamutCompression::operator()(Rgb rgb, Xyz colour) const {
    const Oklab lab = xyz_to_oklab(colour);
    if (!(lab.lightness > 0.0)) return {};
    const auto [edge, room] = bound(lab.a, lab.b);
    const double distance = std::hypot(lab.a, lab.b) / (lab.lightness * edge);
    const double fitted = nearer(distance, room);
    if (fitted == distance) return clip_to_gamut(rgb);
    const double share = fitted / distance;
    const Xyz xyz = oklab_to_xyz({lab.lightness, lab.a * share, lab.b * share});
    const glm::dvec3 inside = rgb_of_xyz_ * glm::dvec3{xyz.x, xyz.y, xyz.z};
    return clip_to_gamut({inside.x, inside.y, inside.z});
}

}  // namespace nacre
