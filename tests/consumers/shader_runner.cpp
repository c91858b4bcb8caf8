#include "consumers/shader_runner.h"

#include <GLES3/gl3.h>

#include <cstddef>
#include <stdexcept>

#include "consumers/gl_context.h"
#include "nacre/lut/snippet.h"

namespace nacre::testing {
namespace {

constexpr int inputs_per_row = 100;
constexpr GLint lut_unit = 0;
constexpr GLint inputs_unit = 1;

constexpr std::string_view glsl_es_head = R"(#version 300 es
#define VEC3 vec3
#define LUT lut
)";
constexpr std::string_view glsl_es_tail = R"(
uniform highp sampler2D lut;
uniform highp sampler2D inputs;
out highp vec4 result;
void main() {
    highp vec4 value = texelFetch(inputs, ivec2(gl_FragCoord.xy), 0);
    result = vec4(EXPRESSION, 1.0);
}
)";
constexpr std::string_view glsl_head = R"(#version 450
#define VEC3 vec3
#define LUT lut
)";
constexpr std::string_view glsl_tail = R"(
layout(binding = 0) uniform sampler2D lut;
layout(binding = 1) uniform sampler2D inputs;
layout(location = 0) out vec4 result;
void main() {
    vec4 value = texelFetch(inputs, ivec2(gl_FragCoord.xy), 0);
    result = vec4(EXPRESSION, 1.0);
}
)";
constexpr std::string_view hlsl_head = R"(#define VEC3 float3
#define LUT lut, lut_sampler
)";
constexpr std::string_view hlsl_tail = R"(
Texture2D lut : register(t0);
SamplerState lut_sampler : register(s0);
Texture2D inputs : register(t1);
float4 main(float4 position : SV_Position) : SV_Target {
    float4 value = inputs.Load(int3(int2(position.xy), 0));
    return float4(EXPRESSION, 1.0);
}
)";

// One triangle that covers the picture.
constexpr std::string_view vertex_body = R"(
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

GLuint compile(GLenum stage, const std::string& source) {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        throw std::runtime_error("the driver refuses this shader:\n" + log + "\n" + source);
    }
    return shader;
}

void use_program(const std::string& vertex, const std::string& fragment) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) throw std::runtime_error("the driver does not link this shader:\n" + fragment);
    glUseProgram(program);
    // ES 3.0 has no layout(binding); elsewhere this repeats it, and unknown names are at -1, which is ignored.
    glUniform1i(glGetUniformLocation(program, "lut"), lut_unit);
    glUniform1i(glGetUniformLocation(program, "inputs"), inputs_unit);
}

void bind_texture(GLint unit, GLint filter, GLint wrap) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
}

void upload_lut(const Image<Rgb>& lut, LutUse use) {
    std::vector<float> texels;
    texels.reserve(3 * lut.size());
    for (int row = 0; row < lut.height(); ++row) {
        const int y = use.first_row_at_v_1 ? lut.height() - 1 - row : row;
        for (int x = 0; x < lut.width(); ++x) {
            const Rgb& texel = lut.at(x, y);
            for (const double component : {texel.r, texel.g, texel.b}) texels.push_back(static_cast<float>(component));
        }
    }
    bind_texture(lut_unit, GL_LINEAR, use.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB16F, lut.width(), lut.height(), 0, GL_RGB, GL_FLOAT, texels.data());
}

void upload_inputs(std::vector<std::array<float, 4>> inputs, int rows) {
    inputs.resize(static_cast<std::size_t>(rows) * inputs_per_row);
    bind_texture(inputs_unit, GL_NEAREST, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, inputs_per_row, rows, 0, GL_RGBA, GL_FLOAT, inputs.data());
}

void bind_picture(int rows) {
    GLuint picture = 0;
    glGenRenderbuffers(1, &picture);
    glBindRenderbuffer(GL_RENDERBUFFER, picture);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, inputs_per_row, rows);
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, picture);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("the driver cannot draw 32-bit floats (in ES: no EXT_color_buffer_float)");
    }
}

std::vector<Rgb> draw(std::size_t count, int rows) {
    GLuint vertex_array = 0;
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glViewport(0, 0, inputs_per_row, rows);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<std::array<float, 4>> pixels(static_cast<std::size_t>(rows) * inputs_per_row);
    glReadPixels(0, 0, inputs_per_row, rows, GL_RGBA, GL_FLOAT, pixels.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        throw std::runtime_error("OpenGL error " + std::to_string(error));
    }
    std::vector<Rgb> colours;
    for (std::size_t i = 0; i < count; ++i) colours.push_back({pixels[i][0], pixels[i][1], pixels[i][2]});
    return colours;
}

}  // namespace

std::string fragment_shader(const ShaderJob& job) {
    const bool es = job.variant == ShaderVariant::glsl_es_300;
    const bool hlsl = job.variant == ShaderVariant::hlsl;
    std::string text(es ? glsl_es_head : hlsl ? hlsl_head : glsl_head);
    if (job.use.first_row_at_v_1) text += "#define NACRE_FLIP_V 1\n";
    text += job.snippet;
    text += "#define EXPRESSION " + job.expression + "\n";
    return text.append(es ? glsl_es_tail : hlsl ? hlsl_tail : glsl_tail);
}

// Textures, shaders and buffers are not deleted one by one: they end with the context.
std::vector<Rgb> run_shader(const ShaderJob& job) {
    const bool es = job.variant == ShaderVariant::glsl_es_300;
    const std::string fragment = fragment_shader(job);
    const std::string drawn = job.variant == ShaderVariant::hlsl ? hlsl_to_glsl_450(fragment) : fragment;
    const int rows = static_cast<int>((job.inputs.size() + inputs_per_row - 1) / inputs_per_row);

    const GlContext context(es ? GlApi::es_3_0 : GlApi::desktop_4_5);
    use_program((es ? "#version 300 es" : "#version 450") + std::string(vertex_body), drawn);
    upload_lut(job.lut, job.use);
    upload_inputs(job.inputs, rows);
    bind_picture(rows);
    return draw(job.inputs.size(), rows);
}

std::vector<Rgb> fetch_baked_lut(ShaderVariant variant, const Image<Rgb>& lut,
                                 std::span<const std::array<float, 2>> coordinates, LutUse use) {
    const ShaderLanguage language = variant == ShaderVariant::hlsl ? ShaderLanguage::hlsl : ShaderLanguage::glsl;
    ShaderJob job{
        .variant = variant, .snippet = snippet(language), .lut = lut, .inputs = {}, .expression = {}, .use = use};
    for (const auto& [x, y] : coordinates) job.inputs.push_back({x, y, 0.0F, 0.0F});
    job.expression = lut.height() == 1 ? "nacre_fetch(LUT, value.x)" : "nacre_fetch(LUT, value.x, value.y)";
    return run_shader(job);
}

}  // namespace nacre::testing
