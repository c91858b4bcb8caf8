#include "nacre/colour/polished_lobe.h"

#include <algorithm>
#include <array>
#include <span>

namespace nacre {
namespace {

constexpr Xyz white = xyz_from_chromaticity(d65_chromaticity);

Lab lab_of(const LobeColours& colours, const DimmedLobe& lobe) {
    const Xyz unit = colours.exact(lobe.place);
    const double height = lobe.height();
    return to_lab({height * unit.x, height * unit.y, height * unit.z}, white);
}

}  // namespace

DimmedLobe judged_exactly(const LobeColours& colours, const Lab& target, DimmedLobe lobe) {
    const double de00 = ciede2000(target, lab_of(colours, lobe));
    lobe.square = de00 * de00;
    return lobe;
}

DimmedLobe polished_lobe(const LobeColours& colours, const LeastSquaresSolver& solve, const Lab& target,
                         const DimmedLobe& start) {
    constexpr std::array unit{10.0, 0.05, 0.05};  // of peak, spread and root of the height: they count about alike
    const auto lobe_at = [&](std::span<const double> v) {
        return DimmedLobe{colours.clamped({v[0] * unit[0], v[1] * unit[1]}), std::clamp(v[2] * unit[2], 0.0, 1.0)};
    };
    LeastSquares problem;
    problem.parameters = 3;
    problem.residuals = 3;
    problem.evaluate = [&](std::span<const double> v, std::span<double> residuals) {
        const auto parts = ciede2000_parts(target, lab_of(colours, lobe_at(v)));
        std::copy(parts.begin(), parts.end(), residuals.begin());
    };
    constexpr int most_steps = 60;
    std::array v{start.place.peak_nm / unit[0], start.place.spread / unit[1], start.root / unit[2]};
    solve(problem, v, most_steps);
    const DimmedLobe before = judged_exactly(colours, target, start);
    const DimmedLobe found = judged_exactly(colours, target, lobe_at(v));
    return found.square < before.square ? found : before;
}

}  // namespace nacre
