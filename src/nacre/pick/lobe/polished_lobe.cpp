#include "nacre/pick/lobe/polished_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/xyz_sums.h"

namespace nacre {
namespace {

Lab lab_of(const LobeColours& colours, const DimmedLobe& lobe) {
    return to_lab(scaled(colours.exact(lobe.place), lobe.height()), d65_white);
}

// Where a colour lies beside the hue that is opposite to the target's.
struct Opposite {
    double distance;  // from it, in units of CIELAB; of a side, as in ciede2000_parts()
    bool is_near;     // and not that from the target's own hue

    double side() const { return std::copysign(1.0, distance); }
};

Opposite opposite_of(const Lab& target, const Lab& lab) {
    const double chroma = std::hypot(target.a, target.b);
    if (chroma == 0.0) return {0.0, false};
    const double across = (target.a * lab.b - target.b * lab.a) / chroma;
    const double along = (target.a * lab.a + target.b * lab.b) / chroma;
    return {across, along < -std::abs(across)};
}

double square_of(const std::array<double, 3>& parts) {
    return parts[0] * parts[0] + parts[1] * parts[1] + parts[2] * parts[2];
}

}  // namespace

DimmedLobe judged_exactly(const LobeColours& colours, const Lab& target, DimmedLobe lobe) {
    const Lab lab = lab_of(colours, lobe);
    lobe.square = square_of(ciede2000_parts(target, lab));
    const Opposite opposite = opposite_of(target, lab);
    constexpr double least_distance = 0.25 * opposite_hue_margin;
    if (opposite.is_near && std::abs(opposite.distance) < least_distance) {
        const double beyond = square_of(ciede2000_parts(target, lab, -opposite.side()));
        lobe.square = std::max(lobe.square, beyond);
    }
    return lobe;
}

DimmedLobe polished_lobe(const LobeColours& colours, const LeastSquaresSolver& solve, const Lab& target,
                         const DimmedLobe& start) {
    constexpr std::array unit{10.0, 0.05, 0.05};  // of peak, spread and root of the height: they count about alike
    const auto lobe_at = [&](std::span<const double> v) {
        return DimmedLobe{colours.clamped({v[0] * unit[0], v[1] * unit[1]}), std::clamp(v[2] * unit[2], 0.0, 1.0)};
    };
    const Opposite opposite = opposite_of(target, lab_of(colours, start));
    const double side = opposite.is_near ? opposite.side() : 0.0;
    LeastSquares problem;
    problem.parameters = 3;
    problem.residuals = 4;
    problem.evaluate = [&](std::span<const double> v, std::span<double> residuals) {
        const Lab lab = lab_of(colours, lobe_at(v));
        const auto parts = ciede2000_parts(target, lab, side);
        std::copy(parts.begin(), parts.end(), residuals.begin());
        // A spring that keeps it on its side.
        constexpr double stiffness = 100.0;
        const double distance = side * opposite_of(target, lab).distance;
        residuals[3] = side == 0.0 ? 0.0 : stiffness * std::max(0.0, opposite_hue_margin - distance);
    };
    constexpr int most_steps = 60;
    std::array v{start.place.peak_nm / unit[0], start.place.spread / unit[1], start.root / unit[2]};
    solve(problem, v, most_steps);
    const DimmedLobe before = judged_exactly(colours, target, start);
    const DimmedLobe found = judged_exactly(colours, target, lobe_at(v));
    return found.square < before.square ? found : before;
}

}  // namespace nacre
