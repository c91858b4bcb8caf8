#include "reference/lobe_integral.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace nacre::reference {
namespace {

constexpr std::size_t cells = light_ends_nm - light_begins_nm;

// Abscissae and weights on [0, 1].
template <std::size_t points>
struct GaussRule {
    std::array<double, points> node{}, weight{};
    GaussRule() {
        using Rule = boost::math::quadrature::gauss<double, points>;  // holds the half that is not negative
        const auto& abscissa = Rule::abscissa();
        const auto& weights = Rule::weights();
        std::size_t next = 0;
        for (std::size_t i = 0; i < abscissa.size(); ++i) {
            for (const double sign : {1.0, -1.0}) {
                if (sign < 0.0 && abscissa[i] == 0.0) continue;
                node.at(next) = 0.5 + 0.5 * sign * abscissa[i];
                weight.at(next++) = 0.5 * weights[i];
            }
        }
    }
};

template <std::size_t points>
const GaussRule<points>& gauss_rule() {
    static const GaussRule<points> rule;
    return rule;
}

using NodeWeights = std::vector<Triple>;

Triple weight_at(const NodeWeights& weights, std::size_t cell, double t) {
    Triple weight{};
    for (std::size_t c = 0; c < 3; ++c) weight[c] = weights[cell][c] + t * (weights[cell + 1][c] - weights[cell][c]);
    return weight;
}

// Quadrature weight times colour weight at the Gauss points of every whole nanometre.
template <std::size_t points>
struct WholeCells {
    std::vector<std::array<Triple, points>> cell;

    explicit WholeCells(const NodeWeights& weights) : cell(cells) {
        const auto& rule = gauss_rule<points>();
        for (std::size_t k = 0; k < cells; ++k) {
            for (std::size_t g = 0; g < points; ++g) {
                cell[k][g] = weight_at(weights, k, rule.node[g]);
                for (double& component : cell[k][g]) component *= rule.weight[g];
            }
        }
    }

    // Adds cells [from, to) of the lobe. The cosine is turned from cell to cell: 470 turns lose 1e-13.
    void add(double peak_nm, double width_nm, int from_nm, int to_nm, Triple& sum) const {
        const double per_nm = std::numbers::pi / width_nm;
        const double turn_cos = std::cos(per_nm), turn_sin = std::sin(per_nm);
        std::array<double, points> cosine{}, sine{};
        for (std::size_t g = 0; g < points; ++g) {
            const double phase = per_nm * (from_nm - peak_nm + gauss_rule<points>().node[g]);
            cosine[g] = std::cos(phase);
            sine[g] = std::sin(phase);
        }
        double x = 0.0, y = 0.0, z = 0.0;
        for (int nm = from_nm; nm < to_nm; ++nm) {
            const auto& at_points = cell[static_cast<std::size_t>(nm - light_begins_nm)];
            for (std::size_t g = 0; g < points; ++g) {
                x += cosine[g] * at_points[g][0];
                y += cosine[g] * at_points[g][1];
                z += cosine[g] * at_points[g][2];
                const double turned = cosine[g] * turn_cos - sine[g] * turn_sin;
                sine[g] = sine[g] * turn_cos + cosine[g] * turn_sin;
                cosine[g] = turned;
            }
        }
        sum = {sum[0] + x, sum[1] + y, sum[2] + z};
    }
};

// A piece that crosses no whole nanometre. Eight points integrate half a turn of the cosine to 1e-15.
void add_piece(const NodeWeights& weights, double peak_nm, double width_nm, double from_nm, double to_nm, Triple& sum) {
    if (!(from_nm < to_nm)) return;
    const auto& rule = gauss_rule<8>();
    const double cell_nm = std::min(std::floor(from_nm), light_ends_nm - 1.0);
    const auto cell = static_cast<std::size_t>(cell_nm - light_begins_nm);
    for (std::size_t g = 0; g < 8; ++g) {
        const double nm = from_nm + rule.node[g] * (to_nm - from_nm);
        const double lobe = std::cos(std::numbers::pi * (nm - peak_nm) / width_nm);
        const Triple weight = weight_at(weights, cell, nm - cell_nm);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += rule.weight[g] * (to_nm - from_nm) * lobe * weight[c];
    }
}

}  // namespace

struct LobeIntegral::Cells {
    explicit Cells(const NodeWeights& of_light) : weights(of_light), coarse(weights), fine(weights) {}

    NodeWeights weights;
    WholeCells<3> coarse;
    WholeCells<5> fine;
};

namespace {

// The part of cos(pi (nm - peak) / width) between two wavelengths.
void add_cosine(const NodeWeights& weights, const WholeCells<3>& coarse, const WholeCells<5>& fine, double peak_nm,
                double width_nm, double begin_nm, double end_nm, Triple& sum) {
    const double from = std::max<double>(light_begins_nm, begin_nm);
    const double to = std::min<double>(light_ends_nm, end_nm);
    if (!(width_nm > 0.0) || !(from < to)) return;
    const int first_whole = static_cast<int>(std::ceil(from)), last_whole = static_cast<int>(std::floor(to));
    if (first_whole > last_whole) {
        add_piece(weights, peak_nm, width_nm, from, to, sum);
        return;
    }
    add_piece(weights, peak_nm, width_nm, from, first_whole, sum);
    add_piece(weights, peak_nm, width_nm, last_whole, to, sum);
    // Gauss-Legendre over 1 nm errs by 5e-7 (pi / w)^6 with 3 points, by 4e-13 (pi / w)^10 with 5.
    if (width_nm >= 40.0) {
        coarse.add(peak_nm, width_nm, first_whole, last_whole, sum);
    } else if (width_nm >= 4.0) {
        fine.add(peak_nm, width_nm, first_whole, last_whole, sum);
    } else {
        for (int nm = first_whole; nm < last_whole; ++nm) add_piece(weights, peak_nm, width_nm, nm, nm + 1, sum);
    }
}

// Where the band is 1: what is linear between two wavelengths is its middle times their distance.
void add_plateau(const NodeWeights& weights, double begin_nm, double end_nm, Triple& sum) {
    const double last = std::min<double>(light_ends_nm, end_nm);
    for (double from = std::max<double>(light_begins_nm, begin_nm); from < last;) {
        const double cell_nm = std::floor(from);
        const double to = std::min(cell_nm + 1.0, last);
        const Triple middle =
            weight_at(weights, static_cast<std::size_t>(cell_nm - light_begins_nm), 0.5 * (from + to) - cell_nm);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += (to - from) * middle[c];
        from = to;
    }
}

}  // namespace

LobeIntegral::LobeIntegral(const ModelLight& light) : cells_(std::make_unique<const Cells>(light.weights())) {
    add_plateau(cells_->weights, light_begins_nm, light_ends_nm, white_);
}

LobeIntegral::~LobeIntegral() = default;

Triple LobeIntegral::operator()(double peak_nm, double width_nm, double flatness) const {
    const auto& [weights, coarse, fine] = *cells_;
    const double plateau = flatness * width_nm;
    const double begins = peak_nm - width_nm / 2, ends = peak_nm + width_nm / 2;
    Triple sum{};
    if (plateau == 0.0) {
        add_cosine(weights, coarse, fine, peak_nm, width_nm, begins, ends, sum);
        return sum;
    }
    const double left = peak_nm - plateau / 2, right = peak_nm + plateau / 2;
    add_cosine(weights, coarse, fine, left, width_nm - plateau, begins, left, sum);
    add_plateau(weights, left, right, sum);
    add_cosine(weights, coarse, fine, right, width_nm - plateau, right, ends, sum);
    return sum;
}

}  // namespace nacre::reference
