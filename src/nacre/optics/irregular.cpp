#include "nacre/optics/irregular.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

namespace nacre {
namespace {

// A normal variable of variance 1 at every point. Only one of each mirrored pair is kept.
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

// The normal variable above which a share of all lies, share < 1 / 2, by Newton's method on the complementary error
// function.
double normal_above(double share) {
    double z = std::sqrt(-2.0 * std::log(share));
    for (int i = 0; i < 50; ++i) {
        const double excess = 0.5 * std::erfc(z / std::numbers::sqrt2) - share;
        const double density = std::exp(-0.5 * z * z) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
        const double step = excess / density;
        z += std::clamp(step, -0.5, 0.5);
        if (std::abs(step) < 1e-14) break;
    }
    return z;
}

// The middles of equal shares of the positive half of a normal variable, ascending.
std::vector<double> positive_strata(std::size_t count) {
    std::vector<double> middles;
    for (std::size_t i = 0; i < count; ++i)
        middles.push_back(normal_above(0.5 - 0.5 * (static_cast<double>(i) + 0.5) / static_cast<double>(count)));
    return middles;
}

// The sequence decides which point gets which stratum, and on which side. That the strata are all there is more even
// than the sequence by itself, and needs quantiles once instead of once per layer.
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

}  // namespace

std::vector<LayerSystem> irregular_systems(const LayerSystem& regular, double spread_nm, int count) {
    LayerSystem expanded = regular;
    expanded.nodes.clear();
    expand(regular.nodes, 0, regular.nodes.size(), expanded.nodes);
    std::vector<std::size_t> moving;
    for (std::size_t i = 0; i < expanded.nodes.size(); ++i) {
        if (!expanded.nodes[i].is_incoherent) moving.push_back(i);
    }
    const auto pairs = static_cast<std::size_t>(count / 2);
    const std::vector<double> strata = positive_strata(pairs);
    std::vector<Variable> normal;
    for (const double root : roots_of_primes(moving.size())) normal.push_back(stratified(root, strata));
    decorrelate(normal);

    std::vector<LayerSystem> systems;
    systems.reserve(2 * pairs);
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        for (const double side : {1.0, -1.0}) {
            systems.push_back(expanded);
            for (std::size_t layer = 0; layer < moving.size(); ++layer) {
                double& thickness_nm = systems.back().nodes[moving[layer]].thickness_nm;
                thickness_nm = std::max(thickness_nm + side * spread_nm * normal[layer][pair], 0.0);
            }
        }
    }
    return systems;
}

}  // namespace nacre
