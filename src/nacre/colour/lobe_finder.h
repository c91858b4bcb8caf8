#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <vector>

#include "nacre/colour/colour_types.h"
#include "nacre/colour/difference.h"
#include "nacre/colour/lobe_moments.h"
#include "nacre/colour/tristimulus.h"

namespace nacre {

/// Why no lobe has a colour.
enum class LobeMiss {
    none,       ///< one has: to `exact_lobe_de00`
    bright,     ///< lobes of its chromaticity are darker, even at height 1
    saturated,  ///< no lobe has its chromaticity: a purple, or more saturated than a band of any width
};

/// The lobe that was found for a colour.
struct LobeMatch {
    double peak_nm = 0.0;
    double width_nm = 0.0;
    double height = 0.0;
    double de00 = 0.0;  ///< between the colour and the lobe's own, both beside D65 white
    LobeMiss miss = LobeMiss::none;
};

/// Colours that are this near to a lobe's count as its own.
inline constexpr double exact_lobe_de00 = 0.01;

/// Finds the lobe whose colour is asked for: peak within the weights' range, width up to 1000 nm, height up to 1.
///
/// A table of lobes says which triangles of chromaticity a colour lies in (two lobes may share one), Newton's method
/// ends the search in each, and of all that are not too bright the widest is taken, because it moves the least. Where
/// none is, CIEDE2000 is minimised from the best of the table on (Levenberg and Marquardt's method).
/// Deterministic; immutable once made, so that threads may share it.
class LobeFinder {
public:
    /// Takes some milliseconds. @param weights,moments  have to outlive this
    /// @param adaptation  what the weights' XYZ are multiplied with so as to be relative to D65
    LobeFinder(const TristimulusWeights& weights, const LobeMoments& moments, const glm::dmat3& adaptation);

    /// @param colour  relative to D65, Y = 1 for the perfect reflector; finite. Black has width 0
    LobeMatch find(Xyz colour) const;

private:
    // A lobe of height 1 by what is solved for: the width goes with the square of `spread`, so that lobes next to the
    // spectrum's locus are as far apart as others.
    struct Place {
        double peak_nm = 0.0;
        double spread = 0.0;  // in [0, 1]
    };
    struct Uv {
        double u = 0.0;
        double v = 0.0;
    };
    struct Node {
        Place place;
        Xyz colour;
        Uv uv;
    };

    static Uv uv_of(Xyz colour);
    static double width_nm(double spread);
    Xyz colour_of(Place place) const;
    Xyz exact_colour_of(Place place) const;
    Place clamped(Place place) const;
    void add_triangle(std::size_t a, std::size_t b, std::size_t c);
    Place start_in(std::uint32_t triangle, Uv target, double& outside) const;
    bool solve(Uv target, Place& place) const;
    std::vector<Place> seeds_for(const Lab& target) const;
    LobeMatch refined(const Lab& target, Place start) const;
    LobeMatch match(const Lab& target, Place place, double height) const;

    const TristimulusWeights& weights_;
    const LobeMoments& moments_;
    glm::dmat3 adaptation_;
    Xyz white_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> triangles_;             // three nodes each
    std::vector<std::vector<std::uint32_t>> buckets_;  // triangles that touch a cell of the (u, v) plane
};

}  // namespace nacre
