#include "nacre/colour/lamp_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace nacre {
namespace {

// Chosen: of a film of 20 um, whose fringes are 3.5 nm apart, a line's share is then wrong by 1e-3 of itself.
constexpr int fine_cells_per_nm = 8;
// Steps of one nanometre may be a few roundings shorter.
constexpr double least_coarse_nm = 1.0 - 1e-6;

using Triple = std::array<double, 3>;

Triple bars_at(Observer observer, double nm, int last_nm) {
    const int left = std::min(static_cast<int>(nm), last_nm - 1);
    const Triple& a = colour_matching(observer, left);
    const Triple& b = colour_matching(observer, left + 1);
    const double t = nm - left;
    return {std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), std::lerp(a[2], b[2], t)};
}

// Ascending: between neighbours lamp, colour matching functions and hats are straight.
std::vector<double> straight_pieces(const SampledCurve& illuminant, const TristimulusWeights& weights) {
    std::vector<double> borders;
    for (int cell = weights.first_cell(); cell <= weights.last_cell(); ++cell)
        borders.push_back(static_cast<double>(cell) / weights.cells_per_nm);
    for (const double nm : illuminant.wavelength_nm) {
        if (nm > weights.first_nm && nm < weights.last_nm) borders.push_back(nm);
    }
    std::sort(borders.begin(), borders.end());
    return borders;
}

// Integrals, in cells, of lamp times colour matching functions times the hat function at every border of a cell.
// A piece's product is a cubic: Simpson's rule is exact.
std::vector<Triple> hat_integrals(Observer observer, const SampledCurve& illuminant,
                                  const TristimulusWeights& weights) {
    std::vector<Triple> sums(static_cast<std::size_t>(weights.count()));
    const std::vector<double> borders = straight_pieces(illuminant, weights);
    for (std::size_t i = 1; i < borders.size(); ++i) {
        const double from = borders[i - 1], to = borders[i], middle = 0.5 * (from + to);
        const int cell = static_cast<int>(middle * weights.cells_per_nm) - weights.first_cell();
        for (const auto& [nm, share] : {std::pair{from, 1.0 / 6.0}, {middle, 4.0 / 6.0}, {to, 1.0 / 6.0}}) {
            const Triple bars = bars_at(observer, nm, weights.last_nm);
            const double power = share * (to - from) * weights.cells_per_nm * illuminant.at(nm);
            const double t = nm * weights.cells_per_nm - (weights.first_cell() + cell);
            for (std::size_t c = 0; c < 3; ++c) {
                sums[static_cast<std::size_t>(cell)][c] += (1.0 - t) * power * bars[c];
                sums[static_cast<std::size_t>(cell) + 1][c] += t * power * bars[c];
            }
        }
    }
    return sums;
}

// Solves for the weights whose hat integrals these are: 1/6, 2/3, 1/6 of neighbours, and 1/3 at the ends (Thomas'
// elimination of a tridiagonal system that is diagonally dominant).
void solve_hats(std::vector<Triple>& values) {
    constexpr double beside = 1.0 / 6.0;
    const std::size_t count = values.size();
    std::vector<double> factor(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double diagonal = i == 0 || i + 1 == count ? 2.0 * beside : 4.0 * beside;
        const double pivot = diagonal - (i == 0 ? 0.0 : beside * factor[i - 1]);
        factor[i] = beside / pivot;
        for (std::size_t c = 0; c < 3; ++c)
            values[i][c] = (values[i][c] - (i == 0 ? 0.0 : beside * values[i - 1][c])) / pivot;
    }
    for (std::size_t i = count - 1; i > 0; --i) {
        for (std::size_t c = 0; c < 3; ++c) values[i - 1][c] -= factor[i - 1] * values[i][c];
    }
}

void add_fine_weights(Observer observer, const SampledCurve& illuminant, TristimulusWeights& weights) {
    weights.cells_per_nm = fine_cells_per_nm;
    std::vector<Triple> values = hat_integrals(observer, illuminant, weights);
    solve_hats(values);
    for (const Triple& value : values) {
        weights.x.push_back(value[0]);
        weights.y.push_back(value[1]);
        weights.z.push_back(value[2]);
    }
}

// Both are straight between whole nanometres, or nearly so, and so is their product.
void add_weights_per_nm(Observer observer, const SampledCurve& illuminant, TristimulusWeights& weights) {
    for (int nm = weights.first_nm; nm <= weights.last_nm; ++nm) {
        const double power = illuminant.at(nm);
        const auto& [x_bar, y_bar, z_bar] = colour_matching(observer, nm);
        weights.x.push_back(power * x_bar);
        weights.y.push_back(power * y_bar);
        weights.z.push_back(power * z_bar);
    }
}

}  // namespace

bool has_fine_lines(const SampledCurve& illuminant, int first_nm, int last_nm) {
    const std::vector<double>& nm = illuminant.wavelength_nm;
    for (std::size_t i = 1; i < nm.size(); ++i) {
        if (nm[i] > first_nm && nm[i - 1] < last_nm && nm[i] - nm[i - 1] < least_coarse_nm) return true;
    }
    return false;
}

void add_lamp_weights(Observer observer, const SampledCurve& illuminant, TristimulusWeights& weights) {
    if (has_fine_lines(illuminant, weights.first_nm, weights.last_nm)) {
        add_fine_weights(observer, illuminant, weights);
    } else {
        add_weights_per_nm(observer, illuminant, weights);
    }
}

}  // namespace nacre
