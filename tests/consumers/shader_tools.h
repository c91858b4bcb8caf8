#pragma once

#include <string>
#include <string_view>

namespace nacre::testing {

/// What a fragment shader is written in. HLSL is drawn as the GLSL 4.50 that spirv-cross makes of it.
enum class ShaderVariant { glsl_es_300, glsl_450, hlsl };

/// A name for test output: "GlslEs300", "Glsl450", "Hlsl".
std::string_view name_of(ShaderVariant variant);

/// Lets glslangValidator judge a fragment shader; GLSL 4.50 is judged by OpenGL's rules and by Vulkan's.
///
/// @throws std::runtime_error with the compiler's words, or the Debian package to install
void check_with_glslang(ShaderVariant variant, std::string_view source);

/// HLSL fragment shader (entry point `main`) as GLSL 4.50 for OpenGL, through SPIR-V.
///
/// Textures and samplers come out combined, at the binding that register(tN) gave to the texture.
/// @throws std::runtime_error as `check_with_glslang`
std::string hlsl_to_glsl_450(std::string_view source);

}  // namespace nacre::testing
