#include "nacre/colour/nearest_downhill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "nacre/colour/many_differences.h"
#include "nacre/colour/quadratic.h"

namespace nacre {
namespace {

using Vector = Quadratic::Vector;

constexpr Xyz white = xyz_from_chromaticity(d65_chromaticity);

// Variables are peak, width and root of the height, in steps of these sizes, of which all three count about alike. The
// width itself rather than its root: valleys along which the visible end of a lobe stays where it is are straight.
constexpr Vector unit{10.0, 30.0, 0.05};
constexpr double least_root = DimmedLobe::least_root;

// How far beside its middle a model looks. The fast integral's error is rough from one nanometre to the next.
constexpr double reach = 0.2;

// Hues as opposite as this may change sides, where CIEDE2000 jumps by up to half of itself.
constexpr double opposite_cosine = -0.8;
// Sine that is kept from the opposite hue.
constexpr double margin = 2e-3;

// Squared difference about a place. Where hues are nearly opposite it is that of one side, continued beyond.
struct Model {
    Vector middle{};
    Quadratic square;               // of what is added to the middle
    double side = 0.0;              // 1 or -1 where hues are nearly opposite
    double sine = 1.0;              // of the hue difference, positive on our side
    std::array<double, 2> slope{};  // of the sine

    double sine_at(const Vector& v) const { return sine + slope[0] * v[0] + slope[1] * v[1]; }
    Vector from_middle(const Vector& place) const {
        return {place[0] - middle[0], place[1] - middle[1], place[2] - middle[2]};
    }
    Vector at(const Vector& v) const { return {middle[0] + v[0], middle[1] + v[1], middle[2] + v[2]}; }
};

// The lobes beside a model's middle, and the ten places of its stencil: which lobe, and how much higher.
constexpr std::size_t lobe_count = 6;
constexpr std::array<std::array<double, 2>, lobe_count> beside{{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}}};
constexpr std::size_t places = 10;
constexpr std::array<std::size_t, places> lobe_of_place{0, 1, 2, 3, 4, 5, 0, 0, 1, 3};
constexpr std::array<double, places> higher{0, 0, 0, 0, 0, 0, 1, -1, 1, 1};

Quadratic through(const float* square) {
    const auto at = [&](std::size_t i) { return static_cast<double>(square[i]); };
    constexpr std::array<std::size_t, 3> up{1, 3, 6}, down{2, 4, 7};
    constexpr double per_step = 1.0 / reach, per_square = per_step * per_step;
    Quadratic result;
    result.constant = at(0);
    for (std::size_t i = 0; i < 3; ++i) {
        result.gradient[i] = (at(up[i]) - at(down[i])) * (0.5 * per_step);
        result.curvature[i][i] = (at(up[i]) - 2.0 * at(0) + at(down[i])) * per_square;
    }
    const auto mix = [&](std::size_t i, std::size_t j, std::size_t both) {
        result.curvature[i][j] = result.curvature[j][i] = (at(both) - at(up[i]) - at(up[j]) + at(0)) * per_square;
    };
    mix(0, 1, 5);
    mix(0, 2, 8);
    mix(1, 2, 9);
    return result;
}

class Walk {
public:
    Walk(const LobeColours& colours, const Lab& target)
        : colours_(colours),
          target_(target),
          chroma_(std::sqrt(target.a * target.a + target.b * target.b)),
          low_{colours.first_nm() / unit[0], narrowest_nm / unit[1], least_root / unit[2]},
          high_{colours.last_nm() / unit[0], LobePlace::widest_nm / unit[1], 1.0 / unit[2]} {}

    DimmedLobe from(const DimmedLobe& start, double least) const;

private:
    static constexpr double narrowest_nm =
        LobePlace::widest_nm * LobePlace::narrowest_spread * LobePlace::narrowest_spread;
    static LobePlace lobe(double peak, double width) {
        return {peak * unit[0], std::sqrt(width * (unit[1] / LobePlace::widest_nm))};
    }
    // A place, the model about it, and what that says of the place.
    struct Step {
        Vector place{};
        Model model;
        double square = 0.0;
    };
    static double distance(const Vector& a, const Vector& b) {
        return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
    }
    Model model_at(const Vector& place, double side) const;
    void look_around(double side, Step& step) const {
        step.model = model_at(step.place, side);
        step.square = step.model.square.at(step.model.from_middle(step.place));
    }
    void look_across(const float* ratios, double side, Model& model) const;
    Vector next(const Model& model, const Vector& here, double radius) const;

    const LobeColours& colours_;
    const Lab& target_;
    double chroma_;
    Vector low_;
    Vector high_;
};

// Whether hues are nearly opposite, and on which side.
// @param side  0 where there was none yet
void Walk::look_across(const float* ratios, double side, Model& model) const {
    const auto part = [&](std::size_t i) { return static_cast<double>(ratios[i]); };
    const auto sine_and_cosine = [&](std::size_t i) {
        const double a = 500.0 * (part(i) - part(lobe_count + i));
        const double b = 200.0 * (part(lobe_count + i) - part(2 * lobe_count + i));
        const double per_length = 1.0 / (std::sqrt(a * a + b * b) * chroma_ + 1e-9);
        return std::array{(target_.a * b - target_.b * a) * per_length, (target_.a * a + target_.b * b) * per_length};
    };
    const auto [sine, cosine] = sine_and_cosine(0);
    if (cosine > opposite_cosine) return;
    model.side = side != 0.0 ? side : std::copysign(1.0, sine);
    model.sine = model.side * sine;
    for (std::size_t i = 0; i < 2; ++i)
        model.slope[i] = model.side * (sine_and_cosine(1 + 2 * i)[0] - sine_and_cosine(2 + 2 * i)[0]) / (2.0 * reach);
}

Model Walk::model_at(const Vector& place, double side) const {
    Model model;
    for (std::size_t i = 0; i < 3; ++i) model.middle[i] = std::clamp(place[i], low_[i] + reach, high_[i] - reach);
    const auto [peak, width, root] = model.middle;
    std::array<float, 3 * lobe_count + RootColours::padding> ratios{};
    for (std::size_t i = 0; i < lobe_count; ++i) {
        const Xyz colour = colours_.fast(lobe(peak + reach * beside[i][0], width + reach * beside[i][1]));
        ratios[i] = static_cast<float>(colour.x / white.x);
        ratios[lobe_count + i] = static_cast<float>(colour.y);
        ratios[2 * lobe_count + i] = static_cast<float>(colour.z / white.z);
    }
    cube_roots(ratios.data(), 3 * lobe_count);
    look_across(ratios.data(), side, model);
    std::array<float, places + RootColours::padding> x{}, y{}, z{}, factor{}, square{};
    for (std::size_t i = 0; i < places; ++i) {
        x[i] = ratios[lobe_of_place[i]];
        y[i] = ratios[lobe_count + lobe_of_place[i]];
        z[i] = ratios[2 * lobe_count + lobe_of_place[i]];
        factor[i] = static_cast<float>((root + reach * higher[i]) * unit[2]);
    }
    many_differences(target_, {x.data(), y.data(), z.data(), factor.data(), places}, square.data(), model.side);
    model.square = through(square.data());
    return model;
}

// Where the model is least within the radius, and on its side of the opposite hue: a stiff spring holds it there.
// Counted from the model's middle.
Vector Walk::next(const Model& model, const Vector& here, double radius) const {
    Vector low{}, high{};
    for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::max(low_[i], here[i] - radius) - model.middle[i];
        high[i] = std::min(high_[i], here[i] + radius) - model.middle[i];
    }
    const Vector start = model.from_middle(here);
    const Vector move = least_in_box(model.square, start, low, high);
    if (model.side == 0.0 || model.sine_at(move) >= margin) return move;
    constexpr double stiffness = 2e6;
    Quadratic held = model.square;
    for (std::size_t i = 0; i < 2; ++i) {
        held.gradient[i] += stiffness * (model.sine - margin) * model.slope[i];
        for (std::size_t j = 0; j < 2; ++j) held.curvature[i][j] += stiffness * model.slope[i] * model.slope[j];
    }
    return least_in_box(held, start, low, high);
}

DimmedLobe Walk::from(const DimmedLobe& start, double least) const {
    Step here;
    here.place = {start.place.peak_nm / unit[0], start.place.width_nm() / unit[1], start.root / unit[2]};
    look_around(0.0, here);
    Vector best = here.place;  // on the right side
    double best_square = here.square;
    double radius = 2.0;
    constexpr double largest_radius = 8.0, least_radius = 0.01;
    constexpr int most_steps = 16;
    for (int step = 0; step < most_steps && radius > least_radius; ++step) {
        const bool is_legal = here.model.sine_at(here.model.from_middle(here.place)) >= 0.0;
        if (is_legal && here.square < best_square) {
            best = here.place;
            best_square = here.square;
        }
        const Vector move = next(here.model, here.place, radius);
        const double promised = here.square - here.model.square.at(move);
        Step there;
        there.place = here.model.at(move);
        // A thousandth of the difference, or 0.001; and what will not win.
        if (is_legal && (promised < 2e-3 * here.square + 1e-6 || here.square - 1.5 * promised > least)) {
            if (promised > 0.0 && here.model.sine_at(move) >= 0.0) {
                best = there.place;
                best_square = here.square - promised;
            }
            break;
        }
        const double length = distance(here.place, there.place);
        look_around(here.model.side, there);
        const double kept = (here.square - there.square) / promised;
        if (is_legal && !(kept > 0.0)) {
            radius = 0.3 * length;
            continue;
        }
        here = there;
        if (kept > 0.7) radius = std::min(2.0 * radius, largest_radius);
        if (kept < 0.3) radius = 0.4 * length;
    }
    return {lobe(best[0], best[1]), best[2] * unit[2], std::max(best_square, 0.0)};
}

}  // namespace

double root_of_lightness(double lightness) {
    const double root = (lightness + 16.0) / 116.0;
    return root > 6.0 / 29.0 ? root : std::cbrt(std::max(0.0, lightness * 27.0 / 24389.0));
}

DimmedLobe with_lightness(const LobeColours& colours, const Lab& target, LobePlace place) {
    const double unit_root = std::cbrt(std::max(colours.fast(place).y, 1e-12));
    return {place, std::clamp(root_of_lightness(target.l) / unit_root, least_root, 1.0), 0.0};
}

DimmedLobe nearest_downhill(const LobeColours& colours, const Lab& target, DimmedLobe start, double least) {
    return Walk(colours, target).from(start, least);
}

}  // namespace nacre
