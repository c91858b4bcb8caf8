#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "nacre/colour/colour_types.h"

namespace nacre {

/// What the eye sees on the way from one picked colour to the next.
struct ColourPath {
    double chroma = 1.0;  ///< the least on the way, as a share of the paler end's (in Oklab); 1: that end is grey
    std::vector<std::string>
        hues{};  ///< the names of those between the ends', in their order: "cyan", "blue"; "grey" too

    /// Whether the way is greyer than both ends: less than two fifths of the chroma are left.
    bool is_pale() const;
};

/// Of colours relative to D65. @pre at least two: the ends, and some between
ColourPath colour_path(std::span<const Xyz> colours);

/// Of the whole way through several picks.
ColourPath joined(std::span<const ColourPath> paths);

/// "through cyan and blue", "through many hues"; empty if there is nothing to name.
std::string path_text(const ColourPath& path);

/// Chroma in Oklab below which a colour is hardly one; chosen.
inline constexpr double hardly_coloured = 0.03;

/// How many colours of a path are looked at, the ends included.
inline constexpr std::size_t colours_of_path = 33;

}  // namespace nacre
