#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "nacre/base/least_squares.h"
#include "nacre/colour/difference.h"
#include "nacre/pick/lobe/lobe_colours.h"
#include "nacre/pick/lobe/many_differences.h"
#include "nacre/pick/lobe/nearest_downhill.h"

namespace nacre {

/// The lobe that is nearest to a colour in CIEDE2000, where none has the colour.
///
/// A table of lobes as light as the colour shows the valleys of the difference; each that may win is walked down. There
/// are several, because CIEDE2000 is no simple bowl: a purple may have its nearest among reds, among violets, and next
/// to grey where the hue is opposite, its rotation being largest there.
class NearestLobe {
public:
    NearestLobe(const LobeColours& colours, LeastSquaresSolver solve);

    /// Some 120 microseconds; without a solver 60, and up to 0.1 further.
    /// Accuracy: CIEDE2000 0.05 beside an exhaustive search; see tests/pipeline/lobe_finder_test.cpp.
    DimmedLobe find(const Lab& target) const;

private:
    static constexpr std::size_t peaks = 30;
    static constexpr std::size_t spreads = 16;
    static constexpr std::size_t count = peaks * spreads;
    static constexpr std::size_t table_size = count + RootColours::padding;

    // The table as a target sees it.
    struct TableView {
        std::array<float, table_size> square;  // of the difference
        std::array<float, table_size> share;   // of the root of the height that makes a lobe as light as the target
    };

    // The least difference along the widths of one peak.
    struct Floor {
        double square;
        double spread_index;
        std::size_t peak_index;
    };
    using Floors = std::array<Floor, count>;
    using Seeds = std::array<DimmedLobe, 12>;
    // Where walks ended.
    struct Candidates {
        std::array<DimmedLobe, 15> lobes;
        std::size_t count = 0;
    };
    static bool is_deepest(const Floors& floors, std::size_t found, std::size_t k);
    void look_over_table(const Lab& target, TableView& view) const;
    std::size_t seeds_in(const Lab& target, const TableView& view, const Floors& floors, std::size_t found,
                         Seeds& seeds) const;
    std::size_t find_floors(const float* square, Floors& floors) const;
    void add_along_valley(const Lab& target, const DimmedLobe& from, Candidates& candidates) const;
    DimmedLobe nearest_of(const Lab& target, const Candidates& candidates) const;

    LobeColours colours_;
    LeastSquaresSolver solve_;
    std::vector<float> x_, y_, z_;  // cube roots of ratios to white, spreads side by side
    std::vector<float> per_y_;
};

}  // namespace nacre
