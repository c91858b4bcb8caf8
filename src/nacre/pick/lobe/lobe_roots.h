#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/pick/lobe/lobe_colours.h"

namespace nacre {

/// Lobes of one chromaticity.
///
/// A table of lobes says which triangles of the CIE 1976 (u', v') plane a chromaticity lies in (two lobes may share
/// one), and Newton's method ends the search in each.
class LobeRoots {
public:
    struct Found {
        std::array<LobePlace, 16> places;
        std::size_t count = 0;
        std::optional<LobePlace> unsolved;  ///< where Newton's method last came to no end
    };

    explicit LobeRoots(const LobeColours& colours);

    /// @pre colour.y > 0, colour.x + 15 colour.y + 3 colour.z > 0
    /// Accuracy: 1e-6 in u' + v'
    Found find(const Xyz& colour) const;

    /// The lobe of the table that is nearest in chromaticity and bright enough. @pre as of find()
    LobePlace nearest_node(const Xyz& colour) const;

private:
    struct Uv {
        double u = 0.0;
        double v = 0.0;
    };
    struct Node {
        LobePlace place;
        Uv uv;
        double y;  // of height 1
    };

    static Uv uv_of(const Xyz& colour);
    void add_triangle(std::size_t a, std::size_t b, std::size_t c);
    LobePlace start_in(std::size_t triangle, Uv target, double& outside) const;
    bool solve(Uv target, LobePlace& place) const;
    void add_root(Uv target, LobePlace start, Found& found) const;

    LobeColours colours_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> triangles_;             // three nodes each
    std::vector<std::vector<std::uint32_t>> buckets_;  // triangles that touch a cell of the (u, v) plane
};

}  // namespace nacre
