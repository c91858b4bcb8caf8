#include "nacre/pick/lobe/lobe_finder.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "nacre/colour/xyz_sums.h"
#include "nacre/pick/lobe/nearest_downhill.h"
#include "nacre/pick/lobe/polished_lobe.h"

namespace nacre {
namespace {

// What comes as near as this may be exact after all.
constexpr double is_near = 0.5;

}  // namespace

LobeFinder::LobeFinder(const TristimulusWeights& weights, const LobeMoments& moments, const glm::dmat3& adaptation,
                       LeastSquaresSolver solve)
    : colours_(weights, moments, adaptation), roots_(colours_), nearest_(colours_, solve), solve_(std::move(solve)) {}

LobeMatch LobeFinder::match(const Lab& target, LobePlace place, double height) const {
    const Lab lab = to_lab(scaled(colours_.exact(place), height), d65_white);
    return {place.peak_nm, place.width_nm(), height, ciede2000(target, lab), LobeMiss::none};
}

// The widest lobe of the colour's chromaticity that need not be brighter than a surface, if one is.
bool LobeFinder::has_widest(const Xyz& colour, const Lab& target, LobeRoots::Found& roots, LobeMatch& widest) const {
    const auto end = roots.places.begin() + static_cast<std::ptrdiff_t>(roots.count);
    std::sort(roots.places.begin(), end, [](LobePlace a, LobePlace b) { return a.spread > b.spread; });
    return std::any_of(roots.places.begin(), end, [&](LobePlace place) {
        constexpr double rounding = 1e-6;
        const double height = colour.y / colours_.exact(place).y;
        if (!(height <= 1.0 + rounding)) return false;
        widest = match(target, place, std::min(height, 1.0));
        return widest.de00 <= exact_lobe_de00;
    });
}

// Where all lobes of some widths, or beyond some wavelength, have one chromaticity, it says nothing about either; and
// next to the locus the table's triangles are too thin to find a root in. So whatever is about there is tried.
DimmedLobe LobeFinder::exact_if_any(const Xyz& colour, const Lab& target, const LobeRoots::Found& roots,
                                    const DimmedLobe& nearest) const {
    DimmedLobe best = polished_lobe(colours_, solve_, target, nearest);
    const auto try_from = [&](LobePlace place) {
        if (best.square <= exact_lobe_de00 * exact_lobe_de00) return;
        const DimmedLobe lobe = polished_lobe(colours_, solve_, target, with_lightness(colours_, target, place));
        if (lobe.square < best.square) best = lobe;
    };
    for (std::size_t i = 0; i < roots.count; ++i) try_from(roots.places[i]);
    if (roots.unsolved) try_from(*roots.unsolved);
    try_from(roots_.nearest_node(colour));
    return best;
}

LobeMatch LobeFinder::find(Xyz colour) const {
    assert(std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z));
    constexpr double black = 1e-7;  // has no chromaticity
    const double middle_nm = 0.5 * (colours_.first_nm() + colours_.last_nm());
    if (std::abs(colour.x) + std::abs(colour.y) + std::abs(colour.z) < black) return {middle_nm, 0.0, 0.0, 0.0, {}};

    const Lab target = to_lab(colour, d65_white);
    LobeMatch best;
    LobeRoots::Found roots;
    const bool has_chromaticity = colour.y > 0.0 && colour.x + 15.0 * colour.y + 3.0 * colour.z > 0.0;
    if (has_chromaticity) roots = roots_.find(colour);
    if (has_widest(colour, target, roots, best)) return best;
    DimmedLobe nearest = nearest_.find(target);
    if (nearest.square < is_near * is_near && has_chromaticity && solve_)
        nearest = exact_if_any(colour, target, roots, nearest);
    best = match(target, nearest.place, nearest.height());
    if (best.de00 > exact_lobe_de00) best.miss = roots.count > 0 ? LobeMiss::bright : LobeMiss::saturated;
    return best;
}

}  // namespace nacre
