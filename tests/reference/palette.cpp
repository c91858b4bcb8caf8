#include "reference/palette.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>

#include "reference/lobe_quadrature.h"

namespace nacre::reference {
namespace {

// One text for double and for 50 digits.

constexpr std::size_t most_picks = 8;
enum LobeMember : std::size_t { peak, width, height, floor, flatness, lobe_members };

template <typename T>
using LobeOf = std::array<T, lobe_members>;

template <typename T>
struct Node {
    T abscissa{};  // Y(theta), equation (3.2.5) of Park & Tsuruno
    LobeOf<T> value{}, slope{};
};

template <typename T>
struct Nodes {
    std::array<Node<T>, most_picks> node{};
    std::size_t count = 0;
};

template <typename T>
T abscissa_of(const T& shape, const T& cosine) {
    return cosine * (shape * cosine + (1 - shape));
}

template <typename T>
T secant(const Node<T>& a, const Node<T>& b, std::size_t member) {
    return (b.value[member] - a.value[member]) / (b.abscissa - a.abscissa);
}

// Fritsch & Butland 1984, SIAM J. Sci. Stat. Comput. 5(2): with alpha = (h1 + 2 h2) / (3 (h1 + h2)) the slope is
// S1 S2 / (alpha S2 + (1 - alpha) S1) where the secants agree in sign, else 0. At the ends: the secant.
template <typename T>
void set_slopes(Nodes<T>& nodes) {
    for (std::size_t m = 0; m < lobe_members; ++m) {
        const std::size_t last = nodes.count - 1;
        nodes.node[0].slope[m] = secant(nodes.node[0], nodes.node[1], m);
        nodes.node[last].slope[m] = secant(nodes.node[last - 1], nodes.node[last], m);
        for (std::size_t i = 1; i < last; ++i) {
            const T s1 = secant(nodes.node[i - 1], nodes.node[i], m), s2 = secant(nodes.node[i], nodes.node[i + 1], m);
            const T h1 = nodes.node[i].abscissa - nodes.node[i - 1].abscissa;
            const T h2 = nodes.node[i + 1].abscissa - nodes.node[i].abscissa;
            const T alpha = (h1 + 2 * h2) / (3 * (h1 + h2));
            const bool same_sign = (s1 > 0 && s2 > 0) || (s1 < 0 && s2 < 0);
            nodes.node[i].slope[m] = same_sign ? T(s1 * s2 / (alpha * s2 + (1 - alpha) * s1)) : T(0);
        }
    }
}

// The picks as the second axis leaves them, by ascending Y(theta), which is by descending angle.
template <typename T>
Nodes<T> nodes_of(const Palette& palette, const std::optional<ModelParameter>& parameter, const T* pick_cosines,
                  const T& y, T& shape) {
    shape = T(palette.shape);
    const T value = parameter ? T(T(parameter->from) + (T(parameter->to) - T(parameter->from)) * y) : T(0);
    const auto set = [&](const char* name, T& number) {
        if (parameter && parameter->name == name) number = value;
    };
    set("shape", shape);
    Nodes<T> nodes;
    for (const Pick& pick : palette.picks) {
        Node<T>& node = nodes.node[nodes.count];
        node.abscissa = abscissa_of(shape, pick_cosines[nodes.count++]);
        node.value = {T(pick.lobe.peak_nm), T(pick.lobe.width_nm), T(pick.lobe.height), T(pick.lobe.floor),
                      T(pick.lobe.flatness)};
        set("peak_nm", node.value[peak]);
        set("width_nm", node.value[width]);
        set("height", node.value[height]);
        set("floor", node.value[floor]);
        set("flatness", node.value[flatness]);
    }
    std::sort(nodes.node.begin(), nodes.node.begin() + static_cast<std::ptrdiff_t>(nodes.count),
              [](const Node<T>& a, const Node<T>& b) { return a.abscissa < b.abscissa; });
    set_slopes(nodes);
    return nodes;
}

// Cubic Hermite inside (of two picks: a straight line), straight lines outside; then what no surface can do is clamped.
template <typename T>
LobeOf<T> lobe_at(const Nodes<T>& nodes, const T& abscissa) {
    std::size_t right = 1;
    while (right + 1 < nodes.count && abscissa > nodes.node[right].abscissa) ++right;
    const Node<T>&a = nodes.node[right - 1], &b = nodes.node[right];
    const T step = b.abscissa - a.abscissa;
    const T t = (abscissa - a.abscissa) / step;
    LobeOf<T> lobe{};
    for (std::size_t m = 0; m < lobe_members; ++m) {
        if (t < 0) {
            lobe[m] = a.value[m] + a.slope[m] * (abscissa - a.abscissa);
        } else if (t > 1) {
            lobe[m] = b.value[m] + b.slope[m] * (abscissa - b.abscissa);
        } else {
            const T t2 = t * t, t3 = t2 * t;
            lobe[m] = (2 * t3 - 3 * t2 + 1) * a.value[m] + (t3 - 2 * t2 + t) * step * a.slope[m] +
                      (3 * t2 - 2 * t3) * b.value[m] + (t3 - t2) * step * b.slope[m];
        }
    }
    for (const LobeMember share : {height, floor, flatness}) {
        if (lobe[share] < 0) lobe[share] = 0;
        if (lobe[share] > 1) lobe[share] = 1;
    }
    // The model's own limit: with 1 the sides would be jumps.
    if (lobe[flatness] > T(T(999) / 1000)) lobe[flatness] = T(T(999) / 1000);
    if (lobe[width] < 0) lobe[width] = 0;
    return lobe;
}

}  // namespace

PaletteModel::PaletteModel(const Palette& palette, const std::optional<ModelParameter>& y, const ModelLight& light)
    : palette_(palette), y_(y), light_(&light) {
    if (palette.picks.size() < 2 || palette.picks.size() > most_picks) throw std::runtime_error("2 to 8 picks");
    for (const Pick& pick : palette.picks) pick_cosines_.push_back(static_cast<double>(cos_of_degrees(pick.angle_deg)));
    static std::map<const ModelLight*, std::shared_ptr<const LobeIntegral>> known;
    auto& integral = known[&light];
    if (!integral) integral = std::make_shared<const LobeIntegral>(light);
    integral_ = integral;
}

ModelXyz PaletteModel::at(double cosine, double y) const {
    double shape = 0.0;
    const Nodes<double> nodes = nodes_of(palette_, y_, pick_cosines_.data(), y, shape);
    const LobeOf<double> lobe = lobe_at(nodes, abscissa_of(shape, cosine));
    const Triple band = (*integral_)(lobe[peak], lobe[width], lobe[flatness]), white = integral_->white();
    Triple seen{};
    for (std::size_t c = 0; c < 3; ++c) seen[c] = lobe[floor] * white[c] + (lobe[height] - lobe[floor]) * band[c];
    return light_->adapted(seen);
}

XyzNumbers palette_in_50_digits(const ModelScene& scene, double x, double y) {
    const auto& palette = std::get<Palette>(scene.mechanism);
    std::vector<Number> cosines;
    for (const Pick& pick : palette.picks) cosines.push_back(cos_of_degrees(pick.angle_deg));
    Number shape;
    const Nodes<Number> nodes = nodes_of(palette, scene.y, cosines.data(), Number(y), shape);
    const LobeOf<Number> lobe = lobe_at(nodes, abscissa_of(shape, cosine_at(scene.x, Number(x), pi())));
    const Weights weights = weights_of(scene.illuminant, scene.observer_deg);
    // The quadrature takes doubles: what rounding moves the lobe by, 1e-13 nm, moves the colour by less than 1e-14.
    const auto peak_nm = static_cast<double>(lobe[peak]), width_nm = static_cast<double>(lobe[width]);
    const auto cells = lobe[flatness] > 0
                           ? FlatBandMoments(peak_nm, width_nm, static_cast<double>(lobe[flatness])).cells()
                           : lobe_moments(peak_nm, width_nm);
    const XyzNumbers white = white_of(weights), band = reference_lobe_to_xyz(weights, cells, 1.0);
    const Number rise = lobe[height] - lobe[floor];
    const XyzNumbers seen{lobe[floor] * white.x + rise * band.x, lobe[floor] * white.y + rise * band.y,
                          lobe[floor] * white.z + rise * band.z};
    const Vector<Number> colour =
        bradford_to_d65<Number>({white.x, white.y, white.z}) * Vector<Number>{seen.x, seen.y, seen.z};
    return {colour[0], colour[1], colour[2]};
}

}  // namespace nacre::reference
