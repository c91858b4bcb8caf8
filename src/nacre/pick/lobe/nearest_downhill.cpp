#include "nacre/pick/lobe/nearest_downhill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "nacre/colour/colour_types.h"
#include "nacre/pick/lobe/many_differences.h"
#include "nacre/pick/lobe/quadratic.h"

namespace nacre {
namespace {

using Vector = Quadratic::Vector;

// Variables are peak, width and root of the height, in steps of these sizes, of which all three count about alike. The
// width itself rather than its root: valleys along which the visible end of a lobe stays where it is are straight.
constexpr Vector unit{10.0, 30.0, 0.05};
constexpr double least_root = DimmedLobe::least_root;

// How far beside its middle a model looks. The fast integral's error is rough from one nanometre to the next.
constexpr double reach = 0.2;

// Hues as opposite as this may change sides, where CIEDE2000 jumps by up to half of itself.
constexpr double opposite_cosine = -0.8;

// Squared difference about a place. Where hues are nearly opposite it is that of one side, continued beyond.
struct Model {
    Vector middle{};
    Quadratic square;   // of what is added to the middle
    double lean = 0.0;  // of the stencil, see there
    double side = 0.0;  // 1 or -1 where hues are nearly opposite
    double sine = 1.0;  // of the hue difference, positive on our side
    double least_sine = 0.0;
    std::array<double, 2> slope{};  // of the sine

    // By how much a valley's floor narrows lobes from peak to peak, in units of both.
    double floor_lean() const {
        constexpr double most = 1.5;
        const auto& curvature = square.curvature;
        return curvature[1][1] > 0.0 ? std::clamp(curvature[0][1] / curvature[1][1], -most, most) : 0.0;
    }
    double sine_at(const Vector& v) const { return sine + slope[0] * v[0] + slope[1] * v[1]; }
    // The spring gives a little.
    bool is_held_at(const Vector& v) const { return sine_at(v) >= 0.5 * least_sine; }
    Vector from_middle(const Vector& place) const {
        return {place[0] - middle[0], place[1] - middle[1], place[2] - middle[2]};
    }
    Vector at(const Vector& v) const { return {middle[0] + v[0], middle[1] + v[1], middle[2] + v[2]}; }
};

// The lobes beside a model's middle, and the places of its stencil: which lobe, and how much higher. In narrow valleys
// steps of the peak lean along the floor: they are narrower by `lean` units of the width, and what the walls' steepness
// leaves of the floor's own bend is not the small difference of large ones.
constexpr std::size_t lobe_count = 7;
constexpr std::array<std::array<double, 2>, lobe_count> beside{
    {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}}};
constexpr std::size_t places = 13;
constexpr std::array<std::size_t, places> lobe_of_place{0, 1, 2, 3, 4, 0, 0, 5, 6, 1, 2, 3, 4};
constexpr std::array<double, places> higher{0, 0, 0, 0, 0, 1, -1, 0, 0, 1, -1, 1, -1};

// @param lean  of the stencil; the result is upright
Quadratic through(const float* square, double lean) {
    const auto at = [&](std::size_t i) { return static_cast<double>(square[i]); };
    constexpr double per_step = 1.0 / reach, per_square = per_step * per_step;
    Quadratic result;
    result.constant = at(0);
    auto& gradient = result.gradient;
    auto& curvature = result.curvature;
    std::array<double, 3> bend{};  // up + down - 2 middle
    for (std::size_t i = 0; i < 3; ++i) {
        const double up = at(1 + 2 * i), down = at(2 + 2 * i);
        bend[i] = up + down - 2.0 * at(0);
        gradient[i] = (up - down) * (0.5 * per_step);
        curvature[i][i] = bend[i] * per_square;
    }
    const auto mixed = [&](std::size_t i, std::size_t j, std::size_t both) {
        const double corners = at(both) + at(both + 1) - 2.0 * at(0);
        return 0.5 * (corners - bend[i] - bend[j]) * per_square;
    };
    const double peak_width = mixed(0, 1, 7), peak_root = mixed(0, 2, 9), width_root = mixed(1, 2, 11);
    gradient[0] += lean * gradient[1];
    curvature[0][0] += lean * (2.0 * peak_width + lean * curvature[1][1]);
    curvature[0][1] = curvature[1][0] = peak_width + lean * curvature[1][1];
    curvature[0][2] = curvature[2][0] = peak_root + lean * width_root;
    curvature[1][2] = curvature[2][1] = width_root;
    return result;
}

class Walk {
public:
    Walk(const LobeColours& colours, const Lab& target, double margin)
        : colours_(colours),
          target_(target),
          margin_(margin),
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
    DimmedLobe on_one_side(Step here, double least) const;
    Model model_at(const Vector& place, double side, double lean) const;
    void look_around(double side, double lean, Step& step) const {
        step.model = model_at(step.place, side, lean);
        step.square = step.model.square.at(step.model.from_middle(step.place));
    }
    void look_across(const float* ratios, double side, Model& model) const;
    Vector next(const Model& model, const Vector& here, double radius) const;

    const LobeColours& colours_;
    const Lab& target_;
    double margin_;
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
        return std::array{(target_.a * b - target_.b * a) * per_length, (target_.a * a + target_.b * b) * per_length,
                          chroma_ * per_length};
    };
    const auto [sine, cosine, per_chroma] = sine_and_cosine(0);
    if (cosine > opposite_cosine) return;
    model.side = side != 0.0 ? side : std::copysign(1.0, sine);
    model.sine = model.side * sine;
    model.least_sine = std::min(margin_ * per_chroma / (model.middle[2] * unit[2]), 0.5);
    for (std::size_t i = 0; i < 2; ++i)
        model.slope[i] = model.side * (sine_and_cosine(1 + 2 * i)[0] - sine_and_cosine(2 + 2 * i)[0]) / (2.0 * reach);
    model.slope[0] += model.lean * model.slope[1];
}

Model Walk::model_at(const Vector& place, double side, double lean) const {
    Model model;
    model.lean = lean;
    // What is no lobe of ours beyond the other bounds has a colour all the same.
    model.middle = {place[0], std::max(place[1], low_[1] + (1.0 + std::abs(lean)) * reach),
                    std::max(place[2], low_[2] + reach)};
    const auto [peak, width, root] = model.middle;
    std::array<float, 3 * lobe_count + RootColours::padding> ratios{};
    for (std::size_t i = 0; i < lobe_count; ++i) {
        const auto [later, wider] = beside[i];
        const Xyz colour = colours_.fast(lobe(peak + reach * later, width + reach * (wider - lean * later)));
        ratios[i] = static_cast<float>(colour.x / d65_white.x);
        ratios[lobe_count + i] = static_cast<float>(colour.y);
        ratios[2 * lobe_count + i] = static_cast<float>(colour.z / d65_white.z);
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
    model.square = through(square.data(), lean);
    return model;
}

// Along the floor of a lobe with one end out of sight the other stays where it is.
double lean_of_hidden_end(const LobePlace& place) {
    constexpr double first_seen_nm = 400.0, last_seen_nm = 700.0;
    constexpr double lean = 2.0 * unit[0] / unit[1];
    const double half_nm = 0.5 * place.width_nm();
    const bool hides_short = place.peak_nm - half_nm < first_seen_nm;
    const bool hides_long = place.peak_nm + half_nm > last_seen_nm;
    if (hides_short == hides_long) return 0.0;
    return hides_short ? lean : -lean;
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
    if (model.side == 0.0 || model.sine_at(move) >= model.least_sine) return move;
    constexpr double stiffness = 2e6;
    Quadratic held = model.square;
    for (std::size_t i = 0; i < 2; ++i) {
        held.gradient[i] += stiffness * (model.sine - model.least_sine) * model.slope[i];
        for (std::size_t j = 0; j < 2; ++j) held.curvature[i][j] += stiffness * model.slope[i] * model.slope[j];
    }
    return least_in_box(held, start, low, high);
}

DimmedLobe Walk::from(const DimmedLobe& start, double least) const {
    Step here;
    here.place = {start.place.peak_nm / unit[0], start.place.width_nm() / unit[1], start.root / unit[2]};
    const double lean = lean_of_hidden_end(start.place);
    look_around(0.0, lean, here);
    const DimmedLobe nearest = on_one_side(here, least);
    if (here.model.side == 0.0) return nearest;
    look_around(-here.model.side, lean, here);
    const DimmedLobe beyond = on_one_side(here, std::min(least, nearest.square));
    return beyond.square < nearest.square ? beyond : nearest;
}

// Where hues are nearly opposite the walk stays on the model's side, or goes there.
DimmedLobe Walk::on_one_side(Step here, double least) const {
    const auto is_on_its_side = [](const Step& step) {
        return step.model.is_held_at(step.model.from_middle(step.place));
    };
    Vector best = here.place;
    double best_square = is_on_its_side(here) ? here.square : std::numeric_limits<double>::max();
    double radius = 2.0;
    constexpr double largest_radius = 8.0, least_radius = 0.01;
    constexpr int most_steps = 16;
    for (int step = 0; step < most_steps && radius > least_radius; ++step) {
        const bool is_legal = is_on_its_side(here);
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
            if (promised > 0.0 && here.model.is_held_at(move)) {
                best = there.place;
                best_square = here.square - promised;
            }
            break;
        }
        const double length = distance(here.place, there.place);
        look_around(here.model.side, here.model.floor_lean(), there);
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

DimmedLobe nearest_downhill(const LobeColours& colours, const Lab& target, DimmedLobe start, double least,
                            double margin) {
    return Walk(colours, target, margin).from(start, least);
}

}  // namespace nacre
