#include "nacre/colour/nearest_lobe.h"

#include <algorithm>
#include <cmath>

#include "nacre/colour/many_differences.h"

namespace nacre {
namespace {

constexpr Xyz white = xyz_from_chromaticity(d65_chromaticity);

constexpr double narrowest_spread = 0.1;
constexpr auto least_root = static_cast<float>(DimmedLobe::least_root);

double spread_at(double index, std::size_t count) {
    return std::lerp(narrowest_spread, 1.0, index / static_cast<double>(count - 1));
}

}  // namespace

NearestLobe::NearestLobe(const LobeColours& colours) : colours_(colours) {
    constexpr std::size_t count = peaks * spreads;
    for (std::vector<float>* ratios : {&x_, &y_, &z_, &per_y_}) ratios->assign(count + RootColours::padding, 1.0F);
    for (std::size_t i = 0; i < peaks; ++i) {
        const double along = static_cast<double>(i) / (peaks - 1);
        const double peak_nm = std::lerp(colours.first_nm(), colours.last_nm(), along);
        for (std::size_t j = 0; j < spreads; ++j) {
            const Xyz colour = colours.exact({peak_nm, spread_at(static_cast<double>(j), spreads)});
            x_[i * spreads + j] = static_cast<float>(colour.x / white.x);
            y_[i * spreads + j] = static_cast<float>(colour.y);
            z_[i * spreads + j] = static_cast<float>(colour.z / white.z);
        }
    }
    for (std::vector<float>* ratios : {&x_, &y_, &z_}) cube_roots(ratios->data(), count);
    for (std::size_t i = 0; i < count; ++i) per_y_[i] = 1.0F / std::max(y_[i], 1e-6F);
}

// By the parabola through three widths.
std::size_t NearestLobe::find_floors(const float* square, Floors& floors) const {
    std::size_t count = 0;
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
            floors[count++] = floor;
        }
    }
    return count;
}

// A valley's deepest floor is below those of the peaks beside it.
bool NearestLobe::is_deepest(const Floors& floors, std::size_t count, std::size_t k) {
    const Floor& floor = floors[k];
    const auto is_below = [&](const Floor& other) {
        constexpr double same_spread = 0.08;
        constexpr double same_valley = same_spread * (spreads - 1) / (1.0 - narrowest_spread);
        return other.square < floor.square && std::abs(other.spread_index - floor.spread_index) < same_valley;
    };
    for (std::size_t i = k; i-- > 0 && floors[i].peak_index + 1 >= floor.peak_index;)
        if (is_below(floors[i])) return false;
    for (std::size_t i = k + 1; i < count && floors[i].peak_index <= floor.peak_index + 1; ++i)
        if (is_below(floors[i])) return false;
    return true;
}

// The deepest floors as lobes that are as light as the target, the deepest first.
std::size_t NearestLobe::seeds_in(const Lab& target, const Floors& floors, std::size_t count, Seeds& seeds) const {
    std::array<std::size_t, peaks * spreads> valleys;
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (is_deepest(floors, count, i)) valleys[found++] = i;
    const std::size_t taken = std::min(found, seeds.size());
    std::partial_sort(valleys.begin(), valleys.begin() + static_cast<std::ptrdiff_t>(taken),
                      valleys.begin() + static_cast<std::ptrdiff_t>(found),
                      [&](std::size_t a, std::size_t b) { return floors[a].square < floors[b].square; });
    for (std::size_t i = 0; i < taken; ++i) {
        const Floor& floor = floors[valleys[i]];
        const double along = static_cast<double>(floor.peak_index) / (peaks - 1);
        const LobePlace place{std::lerp(colours_.first_nm(), colours_.last_nm(), along),
                              spread_at(floor.spread_index, spreads)};
        seeds[i] = with_lightness(colours_, target, place);
        seeds[i].square = floor.square;
    }
    return taken;
}

DimmedLobe NearestLobe::find(const Lab& target) const {
    constexpr std::size_t count = peaks * spreads;
    const auto target_root = static_cast<float>(root_of_lightness(target.l));
    std::array<float, count + RootColours::padding> factor, square;
    for (std::size_t i = 0; i < factor.size(); ++i) factor[i] = std::clamp(target_root * per_y_[i], least_root, 1.0F);
    many_differences(target, {x_.data(), y_.data(), z_.data(), factor.data(), count}, square.data());
    Floors floors;
    const std::size_t floor_count = find_floors(square.data(), floors);
    Seeds seeds;
    const std::size_t seed_count = seeds_in(target, floors, floor_count, seeds);

    DimmedLobe best;
    best.square = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < seed_count; ++i) {
        constexpr double hopeless = 2.25;  // 1.5 times the difference
        if (seeds[i].square > hopeless * best.square) break;
        const DimmedLobe candidate = nearest_downhill(colours_, target, seeds[i], best.square);
        if (candidate.square < best.square) best = candidate;
    }
    return best;
}

}  // namespace nacre
