#include "nacre/pick/lobe/nearest_lobe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "nacre/colour/colour_types.h"
#include "nacre/pick/lobe/many_differences.h"
#include "nacre/pick/lobe/polished_lobe.h"

namespace nacre {
namespace {

constexpr double narrowest_spread = 0.1;
constexpr auto least_single_root = static_cast<float>(DimmedLobe::least_root);

double spread_at(double index, std::size_t count) {
    return std::lerp(narrowest_spread, 1.0, index / static_cast<double>(count - 1));
}

bool is_nearer(const DimmedLobe& a, const DimmedLobe& b) {
    return a.square < b.square;
}

bool is_same(const DimmedLobe& a, const DimmedLobe& b) {
    constexpr double nm = 2.0, root = 0.01;
    return std::abs(a.place.peak_nm - b.place.peak_nm) < nm && std::abs(a.place.width_nm() - b.place.width_nm()) < nm &&
           std::abs(a.root - b.root) < root;
}

}  // namespace

NearestLobe::NearestLobe(const LobeColours& colours, LeastSquaresSolver solve)
    : colours_(colours), solve_(std::move(solve)) {
    for (std::vector<float>* ratios : {&x_, &y_, &z_, &per_y_}) ratios->assign(table_size, 1.0F);
    for (std::size_t i = 0; i < peaks; ++i) {
        const double along = static_cast<double>(i) / (peaks - 1);
        const double peak_nm = std::lerp(colours.first_nm(), colours.last_nm(), along);
        for (std::size_t j = 0; j < spreads; ++j) {
            const Xyz colour = colours.exact({peak_nm, spread_at(static_cast<double>(j), spreads)});
            x_[i * spreads + j] = static_cast<float>(colour.x / d65_white.x);
            y_[i * spreads + j] = static_cast<float>(colour.y);
            z_[i * spreads + j] = static_cast<float>(colour.z / d65_white.z);
        }
    }
    for (std::vector<float>* ratios : {&x_, &y_, &z_}) cube_roots(ratios->data(), count);
    for (std::size_t i = 0; i < count; ++i) per_y_[i] = 1.0F / std::max(y_[i], 1e-6F);
}

// By the parabola through three widths.
std::size_t NearestLobe::find_floors(const float* square, Floors& floors) const {
    std::size_t found = 0;
    for (std::size_t i = 0; i < peaks; ++i) {
        const float* row = square + i * spreads;
        for (std::size_t j = 0; j < spreads; ++j) {
            const bool is_first = j == 0, is_last = j + 1 == spreads;
            if ((!is_first && row[j - 1] < row[j]) || (!is_last && row[j + 1] <= row[j])) continue;
            Floor floor{row[j], static_cast<double>(j), i};
            if (!is_first && !is_last) {
                const double slope = 0.5 * (static_cast<double>(row[j + 1]) - row[j - 1]);
                const double bend = static_cast<double>(row[j + 1]) - 2.0 * row[j] + row[j - 1];
                floor.square = std::max(0.0, floor.square - 0.5 * slope * slope / bend);
                floor.spread_index -= slope / bend;
            }
            floors[found++] = floor;
        }
    }
    return found;
}

// A valley's deepest floor is below those of the peaks beside it.
bool NearestLobe::is_deepest(const Floors& floors, std::size_t found, std::size_t k) {
    const Floor& floor = floors[k];
    const auto is_below = [&](const Floor& other) {
        constexpr double same_spread = 0.08;
        constexpr double same_valley = same_spread * (spreads - 1) / (1.0 - narrowest_spread);
        return other.square < floor.square && std::abs(other.spread_index - floor.spread_index) < same_valley;
    };
    for (std::size_t i = k; i-- > 0 && floors[i].peak_index + 1 >= floor.peak_index;)
        if (is_below(floors[i])) return false;
    for (std::size_t i = k + 1; i < found && floors[i].peak_index <= floor.peak_index + 1; ++i)
        if (is_below(floors[i])) return false;
    return true;
}

// The deepest floors as lobes, the deepest first.
std::size_t NearestLobe::seeds_in(const Lab& target, const TableView& view, const Floors& floors, std::size_t found,
                                  Seeds& seeds) const {
    std::array<std::size_t, count> valleys;
    std::size_t valley_count = 0;
    for (std::size_t i = 0; i < found; ++i)
        if (is_deepest(floors, found, i)) valleys[valley_count++] = i;
    const std::size_t taken = std::min(valley_count, seeds.size());
    std::partial_sort(valleys.begin(), valleys.begin() + static_cast<std::ptrdiff_t>(taken),
                      valleys.begin() + static_cast<std::ptrdiff_t>(valley_count),
                      [&](std::size_t a, std::size_t b) { return floors[a].square < floors[b].square; });
    for (std::size_t i = 0; i < taken; ++i) {
        const Floor& floor = floors[valleys[i]];
        const double along = static_cast<double>(floor.peak_index) / (peaks - 1);
        const LobePlace place{std::lerp(colours_.first_nm(), colours_.last_nm(), along),
                              spread_at(floor.spread_index, spreads)};
        seeds[i] = with_lightness(colours_, target, place);
        const auto node = floor.peak_index * spreads + static_cast<std::size_t>(std::lround(floor.spread_index));
        seeds[i].root = std::max(seeds[i].root * view.share[node], DimmedLobe::least_root);
        seeds[i].square = floor.square;
    }
    return taken;
}

// Squares of the differences to the table's lobes as light as the target; to dark ones, or to darker lobes if those are
// nearer.
void NearestLobe::look_over_table(const Lab& target, TableView& view) const {
    const auto target_root = static_cast<float>(root_of_lightness(target.l));
    std::array<float, table_size> even, factor, square;
    for (std::size_t i = 0; i < even.size(); ++i)
        even[i] = std::clamp(target_root * per_y_[i], least_single_root, 1.0F);
    const RootColours lobes{x_.data(), y_.data(), z_.data(), even.data(), count};
    many_differences(target, lobes, view.square.data());
    view.share.fill(1.0F);
    // There CIEDE2000 counts lightness little, and what is as light as a greyish colour is far too colourful.
    constexpr double dark = 35.0;
    if (target.l >= dark) return;
    for (const float share : {0.75F, 0.5F}) {
        for (std::size_t i = 0; i < factor.size(); ++i) factor[i] = std::max(share * even[i], least_single_root);
        many_differences(target, {x_.data(), y_.data(), z_.data(), factor.data(), count}, square.data());
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_nearer = square[i] < view.square[i];
            view.square[i] = is_nearer ? square[i] : view.square[i];
            view.share[i] = is_nearer ? share : view.share[i];
        }
    }
}

// Of a lobe one of whose ends is out of sight only the other is seen: all that end there are almost alike, and walks
// come to rest anywhere along that valley. So it is looked at from its ends, too. The widest lobes are nearly grey:
// their hues change sides at once, which walks do not.
void NearestLobe::add_along_valley(const Lab& target, const DimmedLobe& from, Candidates& candidates) const {
    constexpr double first_seen_nm = 400.0, last_seen_nm = 700.0, nearly_grey_nm = 950.0;
    const double peak_nm = from.place.peak_nm, half_nm = 0.5 * from.place.width_nm();
    const double short_end_nm = peak_nm - half_nm, long_end_nm = peak_nm + half_nm;
    const auto add = [&](double start_peak_nm, double width_nm, double root_share) {
        const double spread = std::sqrt(std::max(width_nm, 0.0) / LobePlace::widest_nm);
        DimmedLobe lobe = with_lightness(colours_, target, colours_.clamped({start_peak_nm, spread}));
        lobe.root = std::max(lobe.root * root_share, DimmedLobe::least_root);
        candidates.lobes[candidates.count++] = nearest_downhill(colours_, target, lobe);
    };
    const double first_nm = colours_.first_nm(), last_nm = colours_.last_nm();
    constexpr double darker = 0.88;  // a third less
    if (2.0 * half_nm > nearly_grey_nm) {
        for (const double other_nm : {480.0, 520.0, 600.0}) add(other_nm, LobePlace::widest_nm, 1.0);
    } else if (short_end_nm < first_seen_nm && peak_nm < 450.0) {
        for (const double other_nm : {first_nm, 430.0}) add(other_nm, 2.0 * (long_end_nm - other_nm), 1.0);
        add(first_nm, 2.0 * (long_end_nm - first_nm) + 120.0, darker);
    } else if (long_end_nm > last_seen_nm && peak_nm > 650.0) {
        for (const double other_nm : {last_nm, 720.0}) add(other_nm, 2.0 * (other_nm - short_end_nm), 1.0);
        add(last_nm, 2.0 * (last_nm - short_end_nm) + 150.0, darker);
    }
}

// Walks look at fast colours, next to opposite hues from the side that they are on, and come to rest where a valley is
// nearly flat: of those that ended about as near as the nearest, any may be it.
DimmedLobe NearestLobe::nearest_of(const Lab& target, const Candidates& candidates) const {
    Candidates ends;
    for (std::size_t i = 0; i < candidates.count; ++i) {
        DimmedLobe lobe = judged_exactly(colours_, target, candidates.lobes[i]);
        if (!is_kept(candidates.lobes[i], lobe)) {
            constexpr double any = std::numeric_limits<double>::infinity(), margin = 0.05;
            lobe =
                judged_exactly(colours_, target, nearest_downhill(colours_, target, candidates.lobes[i], any, margin));
        }
        const auto known = ends.lobes.begin() + static_cast<std::ptrdiff_t>(ends.count);
        if (std::none_of(ends.lobes.begin(), known, [&](const DimmedLobe& end) { return is_same(end, lobe); }))
            ends.lobes[ends.count++] = lobe;
    }
    const auto begin = ends.lobes.begin(), end = begin + static_cast<std::ptrdiff_t>(ends.count);
    const DimmedLobe nearest = *std::min_element(begin, end, is_nearer);
    DimmedLobe best = nearest;
    constexpr double about = 1.5;  // times the square: a fifth of the difference
    for (auto lobe = begin; solve_ && lobe != end; ++lobe) {
        if (lobe->square <= about * nearest.square)
            best = std::min(best, polished_lobe(colours_, solve_, target, *lobe), is_nearer);
    }
    return best;
}

DimmedLobe NearestLobe::find(const Lab& target) const {
    TableView view;
    look_over_table(target, view);
    Floors floors;
    const std::size_t floor_count = find_floors(view.square.data(), floors);
    Seeds seeds;
    const std::size_t seed_count = seeds_in(target, view, floors, floor_count, seeds);

    Candidates candidates;
    DimmedLobe best;
    best.square = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < seed_count; ++i) {
        constexpr double hopeless = 4.0;  // twice the difference
        if (seeds[i].square > hopeless * best.square) break;
        const DimmedLobe candidate = nearest_downhill(colours_, target, seeds[i]);
        candidates.lobes[candidates.count++] = candidate;
        if (candidate.square < best.square) best = candidate;
    }
    if (candidates.count == 0) return best;
    add_along_valley(target, best, candidates);
    return nearest_of(target, candidates);
}

}  // namespace nacre
