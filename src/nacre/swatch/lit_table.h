#pragma once

#include <optional>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/job.h"
#include "nacre/material/geometry.h"
#include "nacre/swatch/swatch_panel.h"

namespace nacre {

inline Xyz operator+(Xyz a, Xyz b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Xyz operator*(double factor, Xyz colour) {
    return {factor * colour.x, factor * colour.y, factor * colour.z};
}

/// The colours of a material over the default axis of what they depend on, finely enough for linear interpolation; and
/// over its second axis, if it has one.
struct LitTable {
    Image<Xyz> mirrored;   ///< x: the angle; y: the second axis, its first value in the last row
    Image<Xyz> through;    ///< what goes through the layers, of the same size, if the job is of that; else empty
    Image<Xyz> scattered;  ///< what a base that is no metal scatters, of the same size; empty: there is none
    Quantity quantity = Quantity::incidence;
    double first_slope = 0.0;    ///< of the facets, its deviation in radians, at the first value of the second axis
    double last_slope = 0.0;     ///< and at the last
    std::optional<Axis> second;  ///< a number of the material
};

/// Of a job with two axes the number of the material (the second, if both are) becomes the second axis. An azimuth does
/// not: it says where the light comes from.
/// @param most_effort  as of bake_panel()
LitTable lit_table(const Job& job, double most_effort = most_panel_effort);

/// Linear interpolation, as a texture unit does it. @pre the image is at least 2 wide
/// @param coordinate  on the axis of the angle
/// @param along       on the second axis, from its first value (0) to its last (1)
Xyz colour_at(const Image<Xyz>& colours, double coordinate, double along);

/// What mirrors: colours of films, layers and metals. @param cos_theta  to the normal
Xyz mirrored_at(const LitTable& table, double cos_theta, double along);

/// Standard deviation of the directions into which facets mirror: twice that of their slopes.
double blur_rad(const LitTable& table, double along);

}  // namespace nacre
