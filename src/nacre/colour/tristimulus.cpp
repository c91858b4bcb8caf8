// How a band is integrated without error.
//
// A shoulder is a stretch of a cosine; a plateau is the difference of two running integrals of the weights.
//
// With k = pi / width, over a piece [m - d/2, m + d/2] on which the weight is W_m + s (nm - m),
//
//   integral of (W_m + s t) cos(k t + phi) dt = d [ W_m j0(x) cos(phi) - (s d / 2) j1(x) sin(phi) ],  x = k d / 2,
//
// where j0, j1 are spherical Bessel functions (DLMF 10.49.3) and phi the lobe's phase at the piece's middle. Nothing
// cancels: x lies in (0, pi/2], because a piece is never longer than the lobe.
//
// Summed over whole cells, the hat function about node i contributes W_i cos(phase_i) times its Fourier transform
// sinc^2(k / 2) (Fourier transform of a triangle). So the whole cells together are a plain 1 nm sum times one constant,
// less half a hat at each end; and only the two pieces cut by the lobe's ends need the form above. Three table look-ups
// and a rotation per nanometre is what remains, for an exact integral.
#include "nacre/colour/tristimulus.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/colour/cie_tables.h"
#include "nacre/colour/lamp_weights.h"
#include "nacre/colour/whole_cells.h"

namespace nacre {
namespace {

// sin(x) / x^2 - cos(x) / x. Below 0.5 the difference would cancel; the series' next term is under 1e-17 there.
double spherical_j1(double x, double sin_x, double cos_x) {
    if (x < 0.5) {
        const double q = x * x;
        return x * (1.0 / 3.0 -
                    q * (1.0 / 30.0 -
                         q * (1.0 / 840.0 - q * (1.0 / 45360.0 - q * (1.0 / 3991680.0 - q * (1.0 / 518918400.0))))));
    }
    return (sin_x / x - cos_x) / x;
}

// A stretch within one cell: what the weights at its two ends are multiplied with.
struct Piece {
    int cell;      // index of the border of a cell to its left
    double along;  // its middle, from 0 at the left node to 1 at the right one
    double even;   // integral of the cosine
    double odd;    // integral of the cosine times the distance from the middle
};

// @param x       half the phase that the piece spans
// @param half    cosine and sine of x
// @param middle  of the lobe's phase at the piece's middle
Piece make_piece(int cell, double along, double length, double x, Phasor half, Phasor middle) {
    const double j0 = x > 0.0 ? half.sine / x : 1.0;
    const double j1 = spherical_j1(x, half.sine, half.cosine);
    return {cell, along, length * j0 * middle.cosine, -0.5 * length * length * j1 * middle.sine};
}

void add_piece(const TristimulusWeights& weights, const Piece& piece, Xyz& sum) {
    const auto add = [&](const std::vector<double>& weight, double& component) {
        const double left = weight[static_cast<std::size_t>(piece.cell)];
        const double right = weight[static_cast<std::size_t>(piece.cell) + 1];
        component += ((1.0 - piece.along) * left + piece.along * right) * piece.even + (right - left) * piece.odd;
    };
    add(weights.x, sum.x);
    add(weights.y, sum.y);
    add(weights.z, sum.z);
}

Xyz plus(const Xyz& a, const Xyz& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

// b after a.
Phasor turned(const Phasor& a, const Phasor& b) {
    return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

Phasor doubled(const Phasor& a) {
    return {1.0 - 2.0 * a.sine * a.sine, 2.0 * a.sine * a.cosine};
}

// A stretch of cos(per_nm * (nm - peak)) within the range of the weights. From here on `nm` counts cells.
struct Arc {
    double peak_nm;
    double per_nm;  // of the phase
    double from_nm;
    double to_nm;    // <= from_nm when empty
    Phasor at_from;  // of the phase
    Phasor at_to;
};

// Where the arc is cut off by the range, the phase there is computed; its own ends have an exact one.
Arc cropped(const TristimulusWeights& weights, Arc arc) {
    const auto phase_at = [&](double nm) -> Phasor {
        const double phase = arc.per_nm * (nm - arc.peak_nm);
        return {std::cos(phase), std::sin(phase)};
    };
    if (arc.from_nm < weights.first_cell()) {
        arc.from_nm = weights.first_cell();
        if (arc.from_nm < arc.to_nm) arc.at_from = phase_at(arc.from_nm);
    }
    if (arc.to_nm > weights.last_cell()) {
        arc.to_nm = weights.last_cell();
        if (arc.from_nm < arc.to_nm) arc.at_to = phase_at(arc.to_nm);
    }
    return arc;
}

constexpr Phasor rising_end{0.0, -1.0};
constexpr Phasor top{1.0, 0.0};
constexpr Phasor falling_end{0.0, 1.0};

// What a band consists of: one whole half cosine, or two shoulders (between which a plateau lies).
struct Arcs {
    std::array<Arc, 2> arc;
    std::size_t count;
};

Arcs arcs_of(const TristimulusWeights& weights, const BandShape& band) {
    const double from_nm = band.peak_nm - 0.5 * band.width_nm;
    const double to_nm = band.peak_nm + 0.5 * band.width_nm;
    if (band.flatness == 0.0) {
        const double per_nm = std::numbers::pi / band.width_nm;
        return {{cropped(weights, {band.peak_nm, per_nm, from_nm, to_nm, rising_end, falling_end})}, 1};
    }
    const double per_nm = std::numbers::pi / (band.width_nm - band.plateau_nm());
    const double left_nm = band.peak_nm - 0.5 * band.plateau_nm();
    const double right_nm = band.peak_nm + 0.5 * band.plateau_nm();
    return {{cropped(weights, {left_nm, per_nm, from_nm, left_nm, rising_end, top}),
             cropped(weights, {right_nm, per_nm, right_nm, to_nm, top, falling_end})},
            2};
}

Xyz arc_to_xyz_per_cell(const TristimulusWeights& weights, const Arc& arc) {
    Xyz sum;
    for (double from_nm = arc.from_nm; from_nm < arc.to_nm;) {
        const double node_nm = std::floor(from_nm);
        const double to_nm = std::min(node_nm + 1.0, arc.to_nm);
        const double middle_nm = 0.5 * (from_nm + to_nm);
        const double phase = arc.per_nm * (middle_nm - arc.peak_nm);
        const double x = 0.5 * arc.per_nm * (to_nm - from_nm);
        add_piece(weights,
                  make_piece(static_cast<int>(node_nm) - weights.first_cell(), middle_nm - node_nm, to_nm - from_nm, x,
                             {std::cos(x), std::sin(x)}, {std::cos(phase), std::sin(phase)}),
                  sum);
        from_nm = to_nm;
    }
    return sum;
}

Xyz arc_to_xyz(const TristimulusWeights& weights, const Arc& arc) {
    // So that half a cell is a small angle; and an arc of a few cells has next to no whole ones anyway.
    constexpr double steepest_per_nm = std::numbers::pi / 4.0;
    if (!(arc.per_nm < steepest_per_nm)) return arc_to_xyz_per_cell(weights, arc);
    if (!(arc.from_nm < arc.to_nm)) return {};  // also keeps the casts below within int
    const int first = static_cast<int>(std::ceil(arc.from_nm));
    const int last = static_cast<int>(std::floor(arc.to_nm));
    if (!(first < last)) return arc_to_xyz_per_cell(weights, arc);

    // The cells that the ends cut: their phases are small angles away from those of the ends.
    const double before = first - arc.from_nm;  // lengths, in [0, 1)
    const double after = arc.to_nm - last;
    const double x_before = 0.5 * arc.per_nm * before;
    const double x_after = 0.5 * arc.per_nm * after;
    const Phasor half_before = small_phasor(x_before);
    const Phasor half_after = small_phasor(x_after);
    const auto back = [](const Phasor& turn) -> Phasor { return {turn.cosine, -turn.sine}; };
    Xyz sum;
    if (before > 0.0) {
        add_piece(weights,
                  make_piece(first - 1 - weights.first_cell(), 1.0 - 0.5 * before, before, x_before, half_before,
                             turned(arc.at_from, half_before)),
                  sum);
    }
    if (after > 0.0) {
        add_piece(weights,
                  make_piece(last - weights.first_cell(), 0.5 * after, after, x_after, half_after,
                             turned(arc.at_to, back(half_after))),
                  sum);
    }
    return plus(sum, integrate_whole_cells(weights, {first, last, arc.per_nm, turned(arc.at_from, doubled(half_before)),
                                                     turned(arc.at_to, back(doubled(half_after)))}));
}

// Integral of the weights over a range in cells.
Xyz plateau_of_cells(const TristimulusWeights& weights, double from_cell, double to_cell) {
    const double from = std::max(from_cell - weights.first_cell(), 0.0);
    const double to = std::min(to_cell - weights.first_cell(), static_cast<double>(weights.count() - 1));
    if (!(from < to)) return {};
    // From the beginning to somewhere in a cell.
    const auto add_up_to = [&](double position, double sign, Xyz& sum) {
        const auto cell = std::min(static_cast<std::size_t>(position), weights.cumulative.size() - 2);
        const double t = position - static_cast<double>(cell);
        const double right = 0.5 * t * t;  // of the weight at the cell's right end
        const double left = t - right;
        const Xyz& whole = weights.cumulative[cell];
        sum.x += sign * (whole.x + left * weights.x[cell] + right * weights.x[cell + 1]);
        sum.y += sign * (whole.y + left * weights.y[cell] + right * weights.y[cell + 1]);
        sum.z += sign * (whole.z + left * weights.z[cell] + right * weights.z[cell + 1]);
    };
    Xyz sum;
    add_up_to(to, 1.0, sum);
    add_up_to(from, -1.0, sum);
    return sum;
}

template <typename ArcToXyz>
Xyz sum_of_arcs(const TristimulusWeights& weights, BandShape band, ArcToXyz to_xyz) {
    if (!(band.width_nm > 0.0)) return {};
    band.peak_nm *= weights.cells_per_nm;
    band.width_nm *= weights.cells_per_nm;
    const Arcs arcs = arcs_of(weights, band);
    Xyz sum = to_xyz(weights, arcs.arc[0]);
    if (arcs.count == 1) return sum;
    sum = plus(sum, to_xyz(weights, arcs.arc[1]));
    return plus(sum, plateau_of_cells(weights, arcs.arc[0].peak_nm, arcs.arc[1].peak_nm));
}

}  // namespace

TristimulusWeights make_tristimulus_weights(Observer observer, const SampledCurve& illuminant, int first_nm,
                                            int last_nm) {
    assert(first_nm >= cie_table_first_nm && first_nm < last_nm && last_nm <= cie_table_last_nm);
    TristimulusWeights weights;
    weights.first_nm = first_nm;
    weights.last_nm = last_nm;
    add_lamp_weights(observer, illuminant, weights);
    // Trapezia are exact for what is linear between the nodes.
    const auto integral = [](const std::vector<double>& weight) {
        double sum = 0.5 * (weight.front() + weight.back());
        for (std::size_t i = 1; i + 1 < weight.size(); ++i) sum += weight[i];
        return sum;
    };
    const double luminance = integral(weights.y);
    assert(luminance > 0.0);
    for (auto* weight : {&weights.x, &weights.y, &weights.z}) {
        for (double& value : *weight) value /= luminance;
    }
    weights.white = {integral(weights.x), 1.0, integral(weights.z)};
    weights.cumulative.push_back({});
    for (std::size_t i = 1; i < weights.x.size(); ++i) {
        const Xyz& before = weights.cumulative.back();
        weights.cumulative.push_back({before.x + 0.5 * (weights.x[i - 1] + weights.x[i]),
                                      before.y + 0.5 * (weights.y[i - 1] + weights.y[i]),
                                      before.z + 0.5 * (weights.z[i - 1] + weights.z[i])});
    }
    for (auto* weight : {&weights.x, &weights.y, &weights.z}) {
        weight->insert(weight->end(), TristimulusWeights::padding, 0.0);
    }
    return weights;
}

Xyz plateau_to_xyz(const TristimulusWeights& weights, double from_nm, double to_nm) {
    return plateau_of_cells(weights, from_nm * weights.cells_per_nm, to_nm * weights.cells_per_nm);
}

Xyz band_to_xyz(const TristimulusWeights& weights, const BandShape& band) {
    return sum_of_arcs(weights, band, arc_to_xyz);
}

Xyz band_to_xyz_per_cell(const TristimulusWeights& weights, const BandShape& band) {
    return sum_of_arcs(weights, band, arc_to_xyz_per_cell);
}

GridWeights make_grid_weights(const TristimulusWeights& weights, const WavelengthGrid& grid) {
    GridWeights result;
    const auto at = [&](const std::vector<double>& weight, double nm) {
        const double position = nm * weights.cells_per_nm;
        const int cell =
            std::clamp(static_cast<int>(std::floor(position)) - weights.first_cell(), 0, weights.count() - 2);
        const double t = position - (weights.first_cell() + cell);
        return (1.0 - t) * weight[static_cast<std::size_t>(cell)] + t * weight[static_cast<std::size_t>(cell) + 1];
    };
    double luminance = 0.0;
    for (int node = 0; node < grid.count; ++node) {
        const double nm = grid.wavelength_nm(node);
        const double share = node == 0 || node == grid.count - 1 ? 0.5 : 1.0;
        result.x.push_back(share * at(weights.x, nm));
        result.y.push_back(share * at(weights.y, nm));
        result.z.push_back(share * at(weights.z, nm));
        luminance += result.y.back();
    }
    for (std::size_t i = 0; i < result.x.size(); ++i) {
        result.x[i] /= luminance;
        result.y[i] /= luminance;
        result.z[i] /= luminance;
        result.white.x += result.x[i];
        result.white.y += result.y[i];
        result.white.z += result.z[i];
    }
    return result;
}

Xyz to_xyz(const GridWeights& weights, const Spectrum& spectrum) {
    assert(spectrum.value.size() == weights.x.size());
    Xyz sum;
    for (std::size_t i = 0; i < spectrum.value.size(); ++i) {
        sum.x += spectrum.value[i] * weights.x[i];
        sum.y += spectrum.value[i] * weights.y[i];
        sum.z += spectrum.value[i] * weights.z[i];
    }
    return sum;
}

}  // namespace nacre
