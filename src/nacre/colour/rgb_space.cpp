#include "nacre/colour/rgb_space.h"

#include <cmath>
#include <glm/glm.hpp>

namespace nacre {
namespace {

constexpr Chromaticity aces_chromaticity{0.32168, 0.33767};

// ITU-R BT.709, SMPTE EG 432-1, ITU-R BT.2020, Adobe RGB (1998), SMPTE ST 2065-1, AMPAS S-2014-004.
constexpr std::array<KnownRgbSpace, 6> known_spaces{{
    {"lin_rec709", "lin_srgb", "lin_rec709_scene", {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65_chromaticity}},
    {"lin_p3d65", "", "lin_p3d65_scene", {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, d65_chromaticity}},
    {"lin_rec2020", "", "lin_rec2020_scene", {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, d65_chromaticity}},
    {"lin_adobergb", "", "lin_adobergb_scene", {{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, d65_chromaticity}},
    {"lin_ap0", "ACES2065-1", "lin_ap0_scene", {{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, aces_chromaticity}},
    {"lin_ap1", "ACEScg", "lin_ap1_scene", {{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, aces_chromaticity}},
}};

glm::dvec3 to_vector(Xyz colour) {
    return {colour.x, colour.y, colour.z};
}

}  // namespace

std::span<const KnownRgbSpace> known_rgb_spaces() {
    return known_spaces;
}

std::optional<RgbPrimaries> primaries_by_interop_id(std::string_view interop_id) {
    for (const KnownRgbSpace& space : known_spaces) {
        if (space.interop_id == interop_id) return space.primaries;
    }
    return std::nullopt;
}

std::optional<RgbPrimaries> primaries_of(const glm::dmat3& xyz_to_rgb) {
    if (glm::determinant(xyz_to_rgb) == 0.0) return std::nullopt;
    const glm::dmat3 to_xyz = glm::inverse(xyz_to_rgb);
    const auto chromaticity = [](const glm::dvec3& xyz) { return chromaticity_of({xyz.x, xyz.y, xyz.z}); };
    const RgbPrimaries primaries{chromaticity(to_xyz[0]), chromaticity(to_xyz[1]), chromaticity(to_xyz[2]),
                                 chromaticity(to_xyz[0] + to_xyz[1] + to_xyz[2])};
    for (const Chromaticity& c : {primaries.red, primaries.green, primaries.blue, primaries.white}) {
        if (!std::isfinite(c.x) || !std::isfinite(c.y)) return std::nullopt;
    }
    return primaries;
}

glm::dmat3 xyz_to_rgb_matrix(const RgbPrimaries& primaries) {
    // Columns: the primaries' XYZ up to a factor each, which the white settles. x, y, 1 - x - y works for y = 0 too.
    const auto column = [](Chromaticity c) { return glm::dvec3(c.x, c.y, 1.0 - c.x - c.y); };
    const glm::dmat3 directions(column(primaries.red), column(primaries.green), column(primaries.blue));
    const glm::dvec3 scale = glm::inverse(directions) * to_vector(xyz_from_chromaticity(primaries.white));
    return glm::inverse(glm::dmat3(directions[0] * scale.x, directions[1] * scale.y, directions[2] * scale.z));
}

}  // namespace nacre
