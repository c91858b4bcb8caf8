#include "reference/curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "reference/facets.h"
#include "reference/model.h"

namespace nacre::reference {
namespace {

constexpr double pi_number = std::numbers::pi;

// Of reflectance times nanometres; Y of a mirror takes about a hundred nanometres.
constexpr double resolved_to = 3e-6;

double x_of(double from, double to, double t) {
    return from + (to - from) * t * t * (3.0 - 2.0 * t);
}

double t_of(double from, double to, double x) {
    const double share = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return 0.5 - std::sin(std::asin(1.0 - 2.0 * share) / 3.0);
}

// Where Chebyshev's polynomial of an order has its extremes, in [0, 1]; every other of twice the order.
double node(std::size_t i, std::size_t order) {
    return 0.5 - 0.5 * std::cos(pi_number * static_cast<double>(i) / static_cast<double>(order));
}

// Barycentric interpolation (Salzer 1972) through every `stride`-th of the nodes of an order.
template <std::size_t count>
ModelXyz through(const std::array<ModelXyz, count>& colours, std::size_t stride, double t) {
    static const std::array<double, count> nodes = [] {
        std::array<double, count> all{};
        for (std::size_t i = 0; i < count; ++i) all[i] = node(i, count - 1);
        return all;
    }();
    ModelXyz sum;
    double whole = 0.0;
    for (std::size_t i = 0, sign = 0; i < count; i += stride, ++sign) {
        if (t == nodes[i]) return colours[i];
        const double half = i == 0 || i == count - 1 ? 0.5 : 1.0;
        const double share = (sign % 2 == 0 ? half : -half) / (t - nodes[i]);
        sum = plus(sum, share, colours[i]);
        whole += share;
    }
    return {sum.x / whole, sum.y / whole, sum.z / whole};
}

}  // namespace

ModelCurve::ModelCurve(Exact exact, const std::vector<double>& bends, double tolerance) : exact_(std::move(exact)) {
    std::vector<double> ends{0.0};
    for (const double bend : bends)
        if (bend > ends.back() + 1e-9 && bend < 1.0 - 1e-9) ends.push_back(bend);
    ends.push_back(1.0);
    double brightest = 0.0;
    for (int i = 0; i <= 16; ++i) brightest = std::max(brightest, ask(i / 16.0).y);
    scale_ = scale_of_brightest(brightest);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const int panels = std::max(1, static_cast<int>(std::ceil(6.0 * (ends[i + 1] - ends[i]))));
        for (int k = 0; k < panels; ++k)
            add_panels({ends[i], ends[i + 1]}, static_cast<double>(k) / panels, (k + 1.0) / panels, tolerance);
    }
}

ModelXyz ModelCurve::ask(double x) {
    ++points_;
    return exact_(x);
}

void ModelCurve::add_panels(const Part& part, double from_t, double to_t, double tolerance) {
    constexpr double narrowest = 1.0 / (1 << 14);
    Panel panel{part, from_t, to_t, {}};
    const auto ask_node = [&](std::size_t i) {
        panel.colour[i] = ask(x_of(part.from, part.to, from_t + (to_t - from_t) * node(i, count - 1)));
    };
    for (std::size_t i = 0; i < count; i += 2) ask_node(i);
    bool is_smooth = true;
    for (std::size_t i = 1; i < count && (is_smooth || to_t - from_t < narrowest); i += 2) {
        ask_node(i);
        is_smooth =
            is_smooth && difference(panel.colour[i], through(panel.colour, 2, node(i, count - 1)), scale_) <= tolerance;
    }
    if (is_smooth || to_t - from_t < narrowest) {
        panels_.push_back(panel);
        return;
    }
    const double middle = 0.5 * (from_t + to_t);
    add_panels(part, from_t, middle, tolerance);
    add_panels(part, middle, to_t, tolerance);
}

ModelXyz ModelCurve::at(double x) const {
    const auto begins_after = [](double of_x, const Panel& panel) {
        return of_x < x_of(panel.part.from, panel.part.to, panel.from_t);
    };
    auto found = std::upper_bound(panels_.begin(), panels_.end(), x, begins_after);
    const Panel& panel = found == panels_.begin() ? *found : *--found;
    const double t = t_of(panel.part.from, panel.part.to, x);
    return through(panel.colour, 1, (t - panel.from_t) / (panel.to_t - panel.from_t));
}

ModelCurve curve_of_layers(const ModelScene& scene, double tolerance) {
    ModelScene flat = scene;
    flat.mechanism.effects.relief = {};
    const auto model = std::make_shared<Model>(flat);
    double brightest = 0.0;
    for (const double own_x : {0.02, 0.3, 0.5, 0.7, 1.0})
        brightest = std::max(brightest, model->resolved(own_x, 0.0, resolved_to).y);
    const auto own = [axis = scene.x](double x) {
        const bool is_own = axis == ModelAxis::of_mechanism || axis == ModelAxis::sqrt_cos_theta;
        return is_own ? x : std::sqrt(cosine_at(axis, x, pi_number));
    };
    const auto exact = [=](double own_x) { return model->resolved(own_x, 0.0, resolved_to * brightest); };
    const Relief relief = scene.mechanism.effects.relief;
    if (relief.is_plane())
        return ModelCurve([=](double x) { return exact(own(x)); }, critical_coordinates(scene), tolerance);
    flat.x = ModelAxis::sqrt_cos_theta;
    const auto even = std::make_shared<ModelCurve>(exact, critical_coordinates(flat), tolerance);
    std::vector<double> bends_deg;
    for (const double bend : critical_coordinates(flat))
        bends_deg.push_back(std::acos(bend * bend) * 180.0 / pi_number);
    std::reverse(bends_deg.begin(), bends_deg.end());
    const auto facets = [=](double x) {
        const double own_x = own(x);
        const double theta_deg = 2.0 * std::asin(std::sqrt(0.5 * (1.0 - own_x) * (1.0 + own_x))) * 180.0 / pi_number;
        ModelXyz sum;
        for (const ModelFacet& facet : facets_seen(relief, theta_deg, bends_deg))
            sum = plus(sum, facet.share, even->at(std::sqrt(facet.cos_beta)));
        return sum;
    };
    return ModelCurve(facets, {}, tolerance);
}

Worst worst_of(const Pixels& lut, const ModelCurve& curve) {
    constexpr std::size_t closely = 6;
    constexpr int fine = 512;
    const double scale = scale_of(lut);
    const int cells = std::max(lut.width - 1, 1);
    const auto look = [&](int cell, int step, int steps) {
        const double x = std::min((cell + static_cast<double>(step) / steps) / cells, 1.0);
        return Worst{0.0, x, error_at(lut, scale, x, 0.0, curve.at(x))};
    };
    const int coarse = std::clamp(16384 / cells, 8, 512);
    const auto more = [](const Worst& a, const Worst& b) { return a.by_curve > b.by_curve; };
    std::vector<std::pair<double, int>> of_cells;
    for (int cell = 0; cell < cells; ++cell) {
        double largest = 0.0;
        for (int step = 0; step <= coarse; ++step) largest = std::max(largest, look(cell, step, coarse).by_curve);
        of_cells.emplace_back(largest, cell);
    }
    std::sort(of_cells.rbegin(), of_cells.rend());
    Worst worst;
    for (std::size_t i = 0; i < std::min(closely, of_cells.size()); ++i) {
        Worst here;
        for (int step = 0; step <= fine; ++step) {
            const Worst one = look(of_cells[i].second, step, fine);
            if (more(one, here)) here = one;
        }
        here.error = error_at(lut, scale, here.x, 0.0, curve.exactly_at(here.x));
        if (here.error > worst.error || i == 0) worst = here;
    }
    return worst;
}

}  // namespace nacre::reference
