#pragma once

#include <span>
#include <string_view>

#include "nacre/material/geometry.h"

namespace nacre {

/// One geometric axis: how a bake and a shader map a quantity, such as cos(theta), to [0, 1].
///
/// Both directions are written in double for the bake and once more, as text, for the shader; a test compares
/// them on a graphics pipeline.
struct AxisKind {
    std::string_view name;         ///< what a scene file says
    Quantity quantity;             ///< what it is an axis of: fits mechanisms that depend on that
    std::string_view description;  ///< half a line; may follow `// ` in a shader
    std::string_view argument;     ///< what a shader has: "cos_theta", "u", "cos_scatter"
    double low;                    ///< the argument is in [low, high]
    double high;
    double (*coordinate)(double argument);     ///< -> [0, 1]
    double (*argument_at)(double coordinate);  ///< its inverse on [0, 1]; end points are exact
    Geometry (*geometry)(double coordinate);   ///< the same, to full accuracy: with the angle beside the cosine
    std::string_view shader_expression;        ///< `coordinate` in terms of c, valid both as GLSL and as HLSL
};

/// All geometric axes, a closed list; the first of a quantity is its default.
std::span<const AxisKind> axis_kinds();
const AxisKind& default_axis_kind(Quantity quantity);

/// Coordinate in [0, 1] of a texel's centre: the first and the last texel are the ends of the axis.
/// @pre 0 <= texel < size; the only texel of an axis of size 1 is at 0
double coordinate_of_texel(int texel, int size);

/// Texture coordinate (u or v) at which a linear filter returns the value at `coordinate`.
///
/// Texel i is centred at (i + 0.5) / size, hence half a texel from the border. Skipping this costs up to
/// CIEDE2000 1.9 at 256 texels.
/// @pre coordinate in [0, 1], size >= 1
double texcoord_of(double coordinate, int size);

/// `texcoord_of` for the shader, in terms of t and n (both scalars or both vectors), valid as GLSL and as HLSL.
inline constexpr std::string_view texcoord_shader_expression = "(t * (n - 1.0) + 0.5) / n";

}  // namespace nacre
