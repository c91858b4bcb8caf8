#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "nacre/colour/difference.h"
#include "nacre/colour/lobe_colours.h"
#include "nacre/colour/nearest_downhill.h"

namespace nacre {

/// The lobe that is nearest to a colour in CIEDE2000, where none has the colour.
///
/// A table of lobes as light as the colour shows the valleys of the difference; each that may win is walked down. There
/// are several, because CIEDE2000 is no simple bowl: a purple may have its nearest among reds, among violets, and next
/// to grey where the hue is opposite, its rotation being largest there.
class NearestLobe {
public:
    explicit NearestLobe(const LobeColours& colours);

    /// Accuracy: for 99 in 100 colours CIEDE2000 0.05 beside an exhaustive search, else 0.5; see
    /// tests/nacre/colour/lobe_finder_test.cpp.
    DimmedLobe find(const Lab& target) const;

private:
    static constexpr std::size_t peaks = 30;
    static constexpr std::size_t spreads = 16;

    // The least difference along the widths of one peak.
    struct Floor {
        double square;
        double spread_index;
        std::size_t peak_index;
    };
    using Floors = std::array<Floor, peaks * spreads>;
    using Seeds = std::array<DimmedLobe, 6>;
    static bool is_deepest(const Floors& floors, std::size_t count, std::size_t k);
    std::size_t seeds_in(const Lab& target, const Floors& floors, std::size_t count, Seeds& seeds) const;
    std::size_t find_floors(const float* square, Floors& floors) const;

    LobeColours colours_;
    std::vector<float> x_, y_, z_;  // cube roots of ratios to white, spreads side by side
    std::vector<float> per_y_;
};

}  // namespace nacre
