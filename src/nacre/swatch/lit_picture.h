#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/swatch/studio.h"

namespace nacre {

/// A pinhole camera with a square picture.
struct Camera {
    glm::dvec3 from{}, forward{}, right{}, up{};
    double half_side = 0.2;  ///< of the picture, at distance 1

    /// @param x,y  in [-1, 1], y up
    Ray through(double x, double y) const;
};
/// @pre the camera does not look straight up or down
Camera camera_at(const glm::dvec3& from, const glm::dvec3& to, double half_side);

/// What one point of a picture shows.
struct Seen {
    Xyz material{};           ///< light by way of the material: what the exposure multiplies
    Xyz rest{};               ///< everything else, shown as it is
    bool is_grazing = false;  ///< such points do not count for the exposure
};

/// A neutral colour.
inline constexpr Xyz grey(double luminance) {
    return xyz_from_chromaticity(d65_chromaticity, luminance);
}

/// A picture before the exposure.
struct LitPicture {
    Image<Xyz> material;
    Image<Xyz> rest;
    double brightest = 0.0;  ///< largest component of the material in linear Rec.709, at points that are not grazing
};

/// 2 x 2 samples per pixel, and 6 x 6 where those differ visibly. Where the picture is smooth, the mean of 2 x 2
/// samples follows from corners that neighbours share, to less than an 8-bit code. The same picture on every machine
/// and any number of threads.
LitPicture take_picture(const Camera& camera, const std::function<Seen(const Ray&)>& look, int side);

/// exposure * material + rest.
Image<Xyz> exposed(LitPicture picture, double exposure);

}  // namespace nacre
