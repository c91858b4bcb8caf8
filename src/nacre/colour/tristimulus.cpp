// How a lobe is integrated without error.
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
    int cell;      // index of the whole nanometre to its left
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

struct Interval {
    double from_nm;
    double to_nm;  // <= from_nm when empty
};

Interval support_in_range(const TristimulusWeights& weights, double peak_nm, double width_nm) {
    return {std::max(peak_nm - 0.5 * width_nm, static_cast<double>(weights.first_nm)),
            std::min(peak_nm + 0.5 * width_nm, static_cast<double>(weights.last_nm))};
}

Xyz scaled(Xyz colour, double factor) {
    return {colour.x * factor, colour.y * factor, colour.z * factor};
}

}  // namespace

TristimulusWeights make_tristimulus_weights(Observer observer, const SampledCurve& illuminant, int first_nm,
                                            int last_nm) {
    assert(first_nm >= cie_table_first_nm && first_nm < last_nm && last_nm <= cie_table_last_nm);
    TristimulusWeights weights;
    weights.first_nm = first_nm;
    weights.last_nm = last_nm;
    for (int nm = first_nm; nm <= last_nm; ++nm) {
        const double power = illuminant.at(nm);
        const auto& [x_bar, y_bar, z_bar] = colour_matching(observer, nm);
        weights.x.push_back(power * x_bar);
        weights.y.push_back(power * y_bar);
        weights.z.push_back(power * z_bar);
    }
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
    for (auto* weight : {&weights.x, &weights.y, &weights.z}) {
        weight->insert(weight->end(), TristimulusWeights::padding, 0.0);
    }
    return weights;
}

Xyz lobe_to_xyz_per_cell(const TristimulusWeights& weights, double peak_nm, double width_nm, double height) {
    if (!(width_nm > 0.0)) return {};
    const double per_nm = std::numbers::pi / width_nm;
    const Interval support = support_in_range(weights, peak_nm, width_nm);
    Xyz sum;
    for (double from_nm = support.from_nm; from_nm < support.to_nm;) {
        const double node_nm = std::floor(from_nm);
        const double to_nm = std::min(node_nm + 1.0, support.to_nm);
        const double middle_nm = 0.5 * (from_nm + to_nm);
        const double phase = per_nm * (middle_nm - peak_nm);
        const double x = 0.5 * per_nm * (to_nm - from_nm);
        add_piece(weights,
                  make_piece(static_cast<int>(node_nm) - weights.first_nm, middle_nm - node_nm, to_nm - from_nm, x,
                             {std::cos(x), std::sin(x)}, {std::cos(phase), std::sin(phase)}),
                  sum);
        from_nm = to_nm;
    }
    return scaled(sum, height);
}

Xyz lobe_to_xyz(const TristimulusWeights& weights, double peak_nm, double width_nm, double height) {
    // So that half a cell is a small angle; and a lobe of a few cells has next to no whole ones anyway.
    constexpr double few_cells_nm = 4.0;
    if (!(width_nm > few_cells_nm)) return lobe_to_xyz_per_cell(weights, peak_nm, width_nm, height);
    const Interval support = support_in_range(weights, peak_nm, width_nm);
    if (!(support.from_nm < support.to_nm)) return {};  // also keeps the casts below within int
    const int first = static_cast<int>(std::ceil(support.from_nm));
    const int last = static_cast<int>(std::floor(support.to_nm));
    // The range ends at whole nanometres, so a lobe that shows less than a cell is cut off on one side.
    if (!(first < last)) return lobe_to_xyz_per_cell(weights, peak_nm, width_nm, height);

    const double per_nm = std::numbers::pi / width_nm;
    const double before = first - support.from_nm;  // the cut pieces' lengths, in [0, 1)
    const double after = support.to_nm - last;
    Xyz sum;
    WholeCells cells{first, last, per_nm, {}, {}};
    // At a lobe's own end its phase is -pi/2 (left) or pi/2 (right), so that all phases near it are small angles away.
    if (peak_nm - 0.5 * width_nm >= weights.first_nm) {
        const double x = 0.5 * per_nm * before;
        const Phasor half = small_phasor(x);
        cells.first_phase = {2.0 * half.sine * half.cosine, 2.0 * half.sine * half.sine - 1.0};
        if (before > 0.0) {
            add_piece(weights,
                      make_piece(first - 1 - weights.first_nm, 1.0 - 0.5 * before, before, x, half,
                                 {half.sine, -half.cosine}),
                      sum);
        }
    } else {
        const double phase = per_nm * (first - peak_nm);
        cells.first_phase = {std::cos(phase), std::sin(phase)};
    }
    if (peak_nm + 0.5 * width_nm <= weights.last_nm) {
        const double x = 0.5 * per_nm * after;
        const Phasor half = small_phasor(x);
        cells.last_phase = {2.0 * half.sine * half.cosine, 1.0 - 2.0 * half.sine * half.sine};
        if (after > 0.0) {
            add_piece(weights,
                      make_piece(last - weights.first_nm, 0.5 * after, after, x, half, {half.sine, half.cosine}), sum);
        }
    } else {
        const double phase = per_nm * (last - peak_nm);
        cells.last_phase = {std::cos(phase), std::sin(phase)};
    }
    const Xyz whole = integrate_whole_cells(weights, cells);
    return scaled({sum.x + whole.x, sum.y + whole.y, sum.z + whole.z}, height);
}

GridWeights make_grid_weights(const TristimulusWeights& weights, const WavelengthGrid& grid) {
    GridWeights result;
    const auto at = [&](const std::vector<double>& weight, double nm) {
        const int last_cell = weights.last_nm - weights.first_nm - 1;
        const int cell = std::clamp(static_cast<int>(std::floor(nm)) - weights.first_nm, 0, last_cell);
        const double t = nm - (weights.first_nm + cell);
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
