#include "nacre/pick/lobe/nearest_lobe_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>

#include "nacre/colour/rgb_space.h"
#include "nacre/pick/lobe/many_differences.h"
#include "nacre/pick/lobe/polished_lobe.h"

namespace nacre {
namespace {

// Nodes along L*, a* and b*: all that is within Rec. 2020, and a node around it.
constexpr double step = 8.0;
constexpr std::array<std::size_t, 3> counts{15, 42, 41};
constexpr std::array<double, 3> first{0.0, -168.0, -152.0};

std::size_t index_of(const std::array<std::size_t, 3>& position) {
    return (position[0] * counts[1] + position[1]) * counts[2] + position[2];
}

// Calls f(position) for every node.
template <typename F>
void for_each_node(const F& f) {
    for (std::size_t i = 0; i < counts[0]; ++i)
        for (std::size_t j = 0; j < counts[1]; ++j)
            for (std::size_t k = 0; k < counts[2]; ++k) f(std::array{i, j, k});
}

// Widest apart of what a cell's corners have.
struct Spread {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    double size() const { return most - least; }
};

bool is_about(const DimmedLobe& a, const DimmedLobe& b) {
    return std::abs(a.place.peak_nm - b.place.peak_nm) < 25.0 &&
           std::abs(a.place.width_nm() - b.place.width_nm()) < 60.0;
}

// Next to the opposite hue, where CIEDE2000 jumps and corners are a poor guide.
bool is_opposite(const Lab& target, const std::array<float, 3>& roots) {
    constexpr double cosine = -0.7;
    const double a = 500.0 * (roots[0] - roots[1]), b = 200.0 * (roots[1] - roots[2]);
    const double product = target.a * a + target.b * b;
    return product < 0.0 &&
           product * product > cosine * cosine * (a * a + b * b) * (target.a * target.a + target.b * target.b);
}

}  // namespace

Lab NearestLobeGrid::lab_at(const Position& position) {
    const auto along = [&](std::size_t i) { return first[i] + step * static_cast<double>(position[i]); };
    return {along(0), along(1), along(2)};
}

NearestLobeGrid::NearestLobeGrid(const LobeColours& colours, const NearestLobe& nearest)
    : colours_(colours), nodes_(counts[0] * counts[1] * counts[2]) {
    const glm::dmat3 to_rgb = xyz_to_rgb_matrix(*primaries_by_interop_id("lin_rec2020_scene"));
    for_each_node([&](const Position& position) {
        const Xyz colour = from_lab(lab_at(position), d65_white);
        const glm::dvec3 rgb = to_rgb * glm::dvec3(colour.x, colour.y, colour.z);
        if (std::min({rgb.r, rgb.g, rgb.b}) < 0.0 || std::max({rgb.r, rgb.g, rgb.b}) > 1.0) return;
        for (std::size_t neighbour = 0; neighbour < 27; ++neighbour) {
            const Position at{position[0] + neighbour / 9, position[1] + neighbour / 3 % 3,
                              position[2] + neighbour % 3};
            const bool is_inside =
                at[0] > 0 && at[1] > 0 && at[2] > 0 && at[0] <= counts[0] && at[1] <= counts[1] && at[2] <= counts[2];
            if (is_inside) nodes_[index_of({at[0] - 1, at[1] - 1, at[2] - 1})].is_made = true;
        }
    });
    for_each_node([&](const Position& position) {
        Node& node = nodes_[index_of(position)];
        if (!node.is_made) return;
        node.lobe = nearest.find(lab_at(position));
        const Xyz unit = colours_.exact(node.lobe.place);
        const auto root = [&](double ratio) { return static_cast<float>(node.lobe.root * std::cbrt(ratio)); };
        node.roots = {root(unit.x / d65_white.x), root(unit.y), root(unit.z / d65_white.z)};
    });
}

std::optional<NearestLobeGrid::Cell> NearestLobeGrid::cell_of(const Lab& target) const {
    const std::array values{target.l, target.a, target.b};
    Position lower;
    std::array<double, 3> along;
    for (std::size_t i = 0; i < 3; ++i) {
        const double place = (values[i] - first[i]) / step;
        if (!(place >= 0.0 && place < static_cast<double>(counts[i] - 1))) return std::nullopt;
        lower[i] = static_cast<std::size_t>(place);
        along[i] = place - static_cast<double>(lower[i]);
    }
    Cell cell;
    for (std::size_t corner = 0; corner < corner_count; ++corner) {
        const Position up{corner & 1U, corner >> 1U & 1U, corner >> 2U};
        const Node& node = nodes_[index_of({lower[0] + up[0], lower[1] + up[1], lower[2] + up[2]})];
        if (!node.is_made) return std::nullopt;
        cell.corners[corner] = &node;
        cell.shares[corner] = 1.0;
        for (std::size_t i = 0; i < 3; ++i) cell.shares[corner] *= up[i] == 1 ? along[i] : 1.0 - along[i];
    }
    return cell;
}

// What is about as near by exact colours as the walk said.
std::optional<DimmedLobe> NearestLobeGrid::kept(const Lab& target, const DimmedLobe& end) const {
    const DimmedLobe lobe = judged_exactly(colours_, target, end);
    if (is_kept(end, lobe)) return lobe;
    return std::nullopt;
}

// By walks from the corners' lobes, the nearest first, one of those that are about alike.
std::optional<DimmedLobe> NearestLobeGrid::nearest_from(const Lab& target, const Cell& cell, bool is_hard) const {
    std::array<std::array<float, corner_count + RootColours::padding>, 4> rows;
    for (auto& row : rows) row.fill(1.0F);
    for (std::size_t i = 0; i < corner_count; ++i)
        for (std::size_t part = 0; part < 3; ++part) rows[part][i] = cell.corners[i]->roots[part];
    std::array<float, corner_count + RootColours::padding> squares;
    many_differences(target, {rows[0].data(), rows[1].data(), rows[2].data(), rows[3].data(), corner_count},
                     squares.data());
    std::array<std::size_t, corner_count> order;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return squares[a] < squares[b]; });

    constexpr double any = std::numeric_limits<double>::infinity();
    const std::size_t most_walks = is_hard ? 4 : 2;
    const double hopeless = is_hard ? 9.0 : 1.3;  // times the best square
    std::array<const DimmedLobe*, 4> starts{};
    std::size_t walks = 0;
    DimmedLobe best;
    best.square = any;
    double least_broken = any;
    for (const std::size_t corner : order) {
        if (walks == most_walks || squares[corner] > hopeless * best.square) break;
        const DimmedLobe& start = cell.corners[corner]->lobe;
        const auto end = starts.begin() + static_cast<std::ptrdiff_t>(walks);
        if (std::any_of(starts.begin(), end, [&](const DimmedLobe* known) { return is_about(*known, start); }))
            continue;
        starts[walks++] = &start;
        const DimmedLobe promised = nearest_downhill(colours_, target, start, is_hard ? any : best.square);
        if (const std::optional<DimmedLobe> lobe = kept(target, promised)) {
            if (lobe->square < best.square) best = *lobe;
        } else {
            least_broken = std::min(least_broken, promised.square);
        }
    }
    if (least_broken < best.square) return std::nullopt;
    return best;
}

std::optional<DimmedLobe> NearestLobeGrid::find(const Lab& target) const {
    const std::optional<Cell> cell = cell_of(target);
    if (!cell) return std::nullopt;
    Spread peaks, widths;
    DimmedLobe between{{0.0, 0.0}, 0.0, 0.0};
    double width_nm = 0.0;
    bool is_hard = target.l < 20.0;
    for (std::size_t i = 0; i < corner_count; ++i) {
        const auto& [lobe, roots, is_made] = *cell->corners[i];
        peaks.add(lobe.place.peak_nm);
        widths.add(lobe.place.width_nm());
        between.place.peak_nm += cell->shares[i] * lobe.place.peak_nm;
        width_nm += cell->shares[i] * lobe.place.width_nm();
        between.root += cell->shares[i] * lobe.root;
        is_hard = is_hard || is_opposite(target, roots);
    }
    constexpr double one_valley_peaks_nm = 80.0, one_valley_widths_nm = 150.0;
    if (is_hard || peaks.size() > one_valley_peaks_nm || widths.size() > one_valley_widths_nm)
        return nearest_from(target, *cell, is_hard);
    between.place.spread = std::sqrt(width_nm / LobePlace::widest_nm);
    return kept(target, nearest_downhill(colours_, target, between));
}

}  // namespace nacre
