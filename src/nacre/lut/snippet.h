#pragma once

#include <string>

namespace nacre {

enum class ShaderLanguage { glsl, hlsl };

/// The lines that a shader needs to use a LUT: one function per axis kind, and `nacre_fetch`.
///
/// GLSL: for `#version 300 es` and `#version 330` and later, to be pasted below that line. HLSL: shader model 4 and
/// later. Written from the rows of `axis_kinds()` and from the texel map that bake; the same text every time.
std::string snippet(ShaderLanguage language);

}  // namespace nacre
