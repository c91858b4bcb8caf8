#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "consumers/shader_tools.h"
#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre::testing {

/// How an engine holds a LUT.
struct LutUse {
    bool first_row_at_v_1 = false;  ///< as three.js, Babylon.js and Blender do; the shader then sets NACRE_FLIP_V
    bool repeat = false;            ///< wrapping that nobody wants, but that Babylon.js has by default
};

/// One fragment shader evaluated for many inputs.
struct ShaderJob {
    ShaderVariant variant = ShaderVariant::glsl_450;
    std::string snippet;                       ///< goes in front of the shader
    Image<Rgb> lut;                            ///< first row = the file's; every value must be a half float already
    std::vector<std::array<float, 4>> inputs;  ///< what the expression sees as `value`
    /// A vec3 of `value`, in words that mean the same in all variants: VEC3 is vec3 or float3, LUT stands for the
    /// texture arguments, as in `nacre_fetch(LUT, value.x)`.
    std::string expression;
    LutUse use;
};

/// The text that `run_shader` compiles. In ES it sets no default precision, so the compiler refuses a snippet
/// that does not say highp itself.
std::string fragment_shader(const ShaderJob& job);

/// Evaluates the expression for every input on a graphics pipeline: LUT as RGB16F, linear filter, no mip-maps, drawn to
/// 32-bit floats. @throws std::runtime_error if a tool, the driver or the shader is at fault
std::vector<Rgb> run_shader(const ShaderJob& job);

/// The road for a baked LUT: what an engine's shader fetches at coordinates (x, y) in [0, 1], with nacre's own snippet.
///
/// @param lut  the file's pixels, first row first, as read from a half-float EXR (1D LUTs have one row)
std::vector<Rgb> fetch_baked_lut(ShaderVariant variant, const Image<Rgb>& lut,
                                 std::span<const std::array<float, 2>> coordinates, LutUse use = {});

}  // namespace nacre::testing
