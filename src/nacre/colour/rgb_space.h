#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "nacre/colour/colour_types.h"

namespace nacre {

/// The definition of an RGB space.
struct RgbPrimaries {
    Chromaticity red;
    Chromaticity green;
    Chromaticity blue;
    Chromaticity white;
};

/// A linear space of a standard.
struct KnownRgbSpace {
    std::string_view name;        ///< as scenes write it: "lin_rec709"
    std::string_view alias;       ///< what else it is called: "ACEScg"; may be empty
    std::string_view interop_id;  ///< the Color Interop Forum's id: "lin_rec709_scene"
    RgbPrimaries primaries;       ///< as the standard prints them
};
std::span<const KnownRgbSpace> known_rgb_spaces();

/// Primaries of a well-known linear space, as its standard prints them; nothing for an unknown id.
/// @param interop_id  the Color Interop Forum's id, e.g. "lin_rec709_scene"
std::optional<RgbPrimaries> primaries_by_interop_id(std::string_view interop_id);

/// Primaries and white of the space that a matrix leads to, relative to the XYZ that it starts from; nothing if the
/// matrix cannot be inverted, or a primary has no chromaticity.
std::optional<RgbPrimaries> primaries_of(const glm::dmat3& xyz_to_rgb);

/// XYZ -> RGB of a space by its primaries (SMPTE RP 177-1993): (1, 1, 1) is the white at Y = 1.
glm::dmat3 xyz_to_rgb_matrix(const RgbPrimaries& primaries);

}  // namespace nacre
