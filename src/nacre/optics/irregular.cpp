#include "nacre/optics/irregular.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "nacre/base/gauss_points.h"

namespace nacre {
namespace {

// Beyond, a grid has too many points.
constexpr std::size_t most_grid_layers = 3;
constexpr int least_grid_points = 4;

// A normal variable of variance 1 at every point.
using Variable = std::vector<double>;

void expand(const std::vector<LayerNode>& nodes, std::size_t begin, std::size_t end, std::vector<LayerNode>& layers) {
    for (std::size_t i = begin; i < end; ++i) {
        if (nodes[i].repeat == 0) {
            layers.push_back(nodes[i]);
            continue;
        }
        const auto members = static_cast<std::size_t>(nodes[i].count);
        for (int time = 0; time < nodes[i].repeat; ++time) expand(nodes, i + 1, i + 1 + members, layers);
        i += members;
    }
}

std::vector<double> roots_of_primes(std::size_t count) {
    std::vector<double> roots;
    for (int candidate = 2; roots.size() < count; ++candidate) {
        bool is_prime = true;
        for (int divisor = 2; divisor * divisor <= candidate && is_prime; ++divisor)
            is_prime = candidate % divisor != 0;
        if (is_prime) roots.push_back(std::sqrt(candidate));
    }
    return roots;
}

// The middles of equal shares of the positive half of a normal variable, ascending.
std::vector<double> positive_strata(std::size_t count) {
    std::vector<double> middles;
    for (std::size_t i = 0; i < count; ++i)
        middles.push_back(normal_above(0.5 - 0.5 * (static_cast<double>(i) + 0.5) / static_cast<double>(count)));
    return middles;
}

// Of each mirrored pair of points one. The sequence decides which point gets which stratum, and on which side. That the
// strata are all there is more even than the sequence by itself, and needs quantiles once instead of once per layer.
Variable stratified(double root, const std::vector<double>& strata) {
    std::vector<double> from_middle;
    for (std::size_t i = 0; i < strata.size(); ++i) {
        const double at = (static_cast<double>(i) + 0.5) * root;
        from_middle.push_back(at - std::floor(at) - 0.5);
    }
    std::vector<std::size_t> order(strata.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t left, std::size_t right) {
        return std::abs(from_middle[left]) < std::abs(from_middle[right]);
    });
    Variable variable(strata.size());
    for (std::size_t rank = 0; rank < order.size(); ++rank)
        variable[order[rank]] = std::copysign(strata[rank], from_middle[order[rank]]);
    return variable;
}

double mean_product(const Variable& left, const Variable& right) {
    return std::inner_product(left.begin(), left.end(), right.begin(), 0.0) / static_cast<double>(left.size());
}

// Mean square 1.
void normalise(Variable& variable) {
    const double scale = 1.0 / std::sqrt(mean_product(variable, variable));
    for (double& value : variable) value *= scale;
}

// Takes out of each variable what it has in common with those before it (modified Gram-Schmidt). No more than as many
// as there are pairs of points can be uncorrelated: one that has next to nothing of its own left stays as it is and
// starts a new block. Within a block neighbours, which interfere most, stay uncorrelated.
void decorrelate(std::vector<Variable>& variables) {
    constexpr double least_own_share = 1e-3;
    std::size_t first = 0;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        normalise(variables[i]);
        Variable own = variables[i];
        for (std::size_t before = first; before < i; ++before) {
            const double common = mean_product(own, variables[before]);
            for (std::size_t point = 0; point < own.size(); ++point) own[point] -= common * variables[before][point];
        }
        if (mean_product(own, own) < least_own_share) {
            first = i;
            continue;
        }
        normalise(own);
        variables[i] = std::move(own);
    }
}

// Where the moving layers have their points: one variable per layer, and a point's share.
struct Points {
    std::vector<Variable> variables;
    std::vector<double> shares;
};

// The largest n with n^power <= count.
int root_of(int count, std::size_t power) {
    int root = static_cast<int>(std::lround(std::pow(count, 1.0 / static_cast<double>(power))));
    while (std::pow(root, power) > count) --root;
    return root;
}

// @pre layers in [1, 3]
Points grid_points(std::size_t layers, int per_layer) {
    // Corners that hardly anything is at.
    constexpr double negligible_share = 1e-10;
    const std::vector<GaussPoint> rule = normal_points(per_layer);
    Points points;
    points.variables.resize(layers);
    double total = 0.0;
    std::size_t count = 1;
    for (std::size_t layer = 0; layer < layers; ++layer) count *= rule.size();
    for (std::size_t i = 0; i < count; ++i) {
        double share = 1.0;
        std::array<double, most_grid_layers> at{};
        std::size_t rest = i;
        for (std::size_t layer = 0; layer < layers; ++layer, rest /= rule.size()) {
            const GaussPoint& point = rule[rest % rule.size()];
            at[layer] = point.at;
            share *= point.weight;
        }
        if (share < negligible_share) continue;
        for (std::size_t layer = 0; layer < layers; ++layer) points.variables[layer].push_back(at[layer]);
        points.shares.push_back(share);
        total += share;
    }
    for (double& share : points.shares) share /= total;
    return points;
}

Points sequence_points(std::size_t layers, int count) {
    const auto pairs = static_cast<std::size_t>(count / 2);
    const std::vector<double> strata = positive_strata(pairs);
    std::vector<Variable> half;
    for (const double root : roots_of_primes(layers)) half.push_back(stratified(root, strata));
    decorrelate(half);
    Points points;
    for (const Variable& variable : half) {
        Variable& both = points.variables.emplace_back();
        for (const double value : variable) both.insert(both.end(), {value, -value});
    }
    points.shares.assign(2 * pairs, 1.0 / (2.0 * static_cast<double>(pairs)));
    return points;
}

}  // namespace

ThicknessSampleCounts thickness_sample_counts(std::size_t layers) {
    switch (layers) {
        case 0:
        case 1:
            return {{4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512}, true};
        case 2:
            return {{16, 36, 64, 100, 144, 256, 400, 576, 1024}, true};
        case 3:
            return {{64, 216, 512, 1000, 1728}, true};
        default:
            return {{16, 32, 64, 128, 256, 512, 1024, 2048, 4096}, false};
    }
}

LayerEnsemble irregular_systems(const LayerSystem& regular, double spread_nm, int count) {
    LayerSystem expanded = regular;
    expanded.nodes.clear();
    expand(regular.nodes, 0, regular.nodes.size(), expanded.nodes);
    std::vector<std::size_t> moving;
    for (std::size_t i = 0; i < expanded.nodes.size(); ++i) {
        if (!expanded.nodes[i].is_incoherent) moving.push_back(i);
    }
    const bool has_grid = !moving.empty() && moving.size() <= most_grid_layers &&
                          (moving.size() == 1 || root_of(count, moving.size()) >= least_grid_points);
    const Points points =
        has_grid ? grid_points(moving.size(), root_of(count, moving.size())) : sequence_points(moving.size(), count);

    LayerEnsemble ensemble;
    ensemble.shares = points.shares;
    ensemble.systems.reserve(points.shares.size());
    for (std::size_t point = 0; point < points.shares.size(); ++point) {
        LayerSystem& system = ensemble.systems.emplace_back(expanded);
        for (std::size_t layer = 0; layer < moving.size(); ++layer) {
            double& thickness_nm = system.nodes[moving[layer]].thickness_nm;
            thickness_nm = std::max(thickness_nm + spread_nm * points.variables[layer][point], 0.0);
        }
    }
    return ensemble;
}

}  // namespace nacre
