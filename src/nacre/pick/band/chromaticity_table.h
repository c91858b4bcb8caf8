#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "nacre/colour/colour_types.h"

namespace nacre {

/// CIE 1976 (u', v'), in which chromaticities are compared.
struct Uv {
    double u = 0.0;
    double v = 0.0;
};

/// @pre colour.x + 15 colour.y + 3 colour.z != 0
inline Uv uv_of(const Xyz& colour) {
    const double per_sum = 1.0 / (colour.x + 15.0 * colour.y + 3.0 * colour.z);
    return {4.0 * colour.x * per_sum, 9.0 * colour.y * per_sum};
}

/// The way back from a chromaticity to the two numbers that a family of colours has: where to start looking for them.
///
/// A grid over the two numbers makes triangles in the (u', v') plane, sorted into cells. Several triangles may hold one
/// chromaticity.
class ChromaticityTable {
public:
    /// Two numbers in [0, 1].
    struct Place {
        double p = 0.0;
        double q = 0.0;
    };

    /// @param colour  of the family; black where it has none
    ChromaticityTable(std::size_t columns, std::size_t rows, const std::function<Xyz(const Place&)>& colour);

    struct Places {
        std::array<Place, 12> place;
        std::size_t count = 0;

        const Place* begin() const { return place.data(); }
        const Place* end() const { return place.data() + count; }
    };

    /// Where in its triangles a chromaticity lies, were they flat; in the nearest triangle, if it lies in none.
    Places starts(Uv target) const;

private:
    void add_triangle(std::size_t a, std::size_t b, std::size_t c);
    Place place_in(std::size_t triangle, Uv target, double& outside) const;

    std::vector<Place> places_;
    std::vector<Uv> uvs_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace nacre
