// The snippet as engines use it: compiled by other people's compilers, drawn by a graphics pipeline.
#include "nacre/lut/snippet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

#include "consumers/shader_runner.h"
#include "nacre/lut/axis_kinds.h"

namespace nacre::testing {
namespace {

// Stored halves in [1, 2) are rounded by at most 2^-11 = 4.9e-4; the rest is room for graphics cards, whose filters
// weigh with 8 bits. A skipped half-texel shows as 6e-3 here.
constexpr double fetch_tolerance = 1e-3;

// Mesa's filter weighs with 32-bit floats: 6e-8 of 256 texels, times 0.1 from texel to texel.
// A graphics card weighs with 8 bits: 1/512 of the same step, on two axes.
double filter_tolerance() {
    return std::getenv("NACRE_TEST_HARDWARE_GL") == nullptr ? 2e-6 : 5e-4;
}

// Mesa's atan is a polynomial that errs by 4e-6, its acos by 1e-4; 1e-5 moves a fetch by 1/400 of a texel at 256.
constexpr double axis_tolerance = 1e-5;

/// Smooth, different in every component and direction, with values below 0 and above 1, as LUTs have them.
Rgb synthetic_colour(double x, double y) {
    return {0.6 + 0.6 * std::sin(5.0 * x + 2.0 * y), 0.5 + 0.5 * std::cos(6.0 * x - 3.0 * y),
            0.4 * std::cos(4.0 * x + y)};
}

Image<Rgb> synthetic_lut(int width, int height) {
    Image<Rgb> lut(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            lut.at(x, y) = synthetic_colour(coordinate_of_texel(x, width), coordinate_of_texel(y, height));
        }
    }
    return lut;
}

/// To the nearest half float, ties to even; normal numbers and zero only.
double to_half(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);  // fraction in [0.5, 1): 11 significant bits
    return std::ldexp(std::nearbyint(std::ldexp(fraction, 11)), exponent - 11);
}

Image<Rgb> to_half(Image<Rgb> lut) {
    for (Rgb& texel : lut) texel = {to_half(texel.r), to_half(texel.g), to_half(texel.b)};
    return lut;
}

Rgb mix(const Rgb& a, const Rgb& b, double weight) {
    return {a.r + weight * (b.r - a.r), a.g + weight * (b.g - a.g), a.b + weight * (b.b - a.b)};
}

/// Bilinear interpolation in double, apart from the core's own on purpose: texel i is at i / (size - 1).
Rgb interpolate(const Image<Rgb>& lut, double x, double y) {
    const double column = std::clamp(x, 0.0, 1.0) * (lut.width() - 1);
    const double row = std::clamp(y, 0.0, 1.0) * (lut.height() - 1);
    const int left = static_cast<int>(column), top = static_cast<int>(row);
    const int right = std::min(left + 1, lut.width() - 1), bottom = std::min(top + 1, lut.height() - 1);
    return mix(mix(lut.at(left, top), lut.at(right, top), column - left),
               mix(lut.at(left, bottom), lut.at(right, bottom), column - left), row - top);
}

double largest_component_difference(const Rgb& a, const Rgb& b) {
    return std::max({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)});
}

using Coordinates = std::vector<std::array<float, 2>>;

/// 10 000 of them: the corners, every texel of both axes, some beyond [0, 1], the rest at random.
Coordinates probe_coordinates(int width, int height) {
    Coordinates coordinates{{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}, {1.0F, 1.0F}, {-0.3F, 1.3F}, {1.3F, -0.3F}};
    std::mt19937 random(20140401);
    const auto uniform = [&random] { return static_cast<float>(static_cast<double>(random()) * 0x1p-32); };
    for (int x = 0; x < width; ++x)
        coordinates.push_back({static_cast<float>(coordinate_of_texel(x, width)), uniform()});
    for (int y = 0; y < height; ++y) {
        coordinates.push_back({uniform(), static_cast<float>(coordinate_of_texel(y, height))});
    }
    while (coordinates.size() < 10000) coordinates.push_back({uniform(), uniform()});
    return coordinates;
}

double largest_error(const std::vector<Rgb>& fetched, const Image<Rgb>& lut, const Coordinates& coordinates) {
    EXPECT_EQ(fetched.size(), coordinates.size());
    double error = 0.0;
    for (std::size_t i = 0; i < fetched.size(); ++i) {
        const Rgb expected = interpolate(lut, coordinates[i][0], coordinates[i][1]);
        error = std::fmax(error, largest_component_difference(fetched[i], expected));
    }
    return error;
}

std::string text_of(double number) {
    std::ostringstream text;
    text << number;
    return text.str();
}

ShaderLanguage language_of(ShaderVariant variant) {
    return variant == ShaderVariant::hlsl ? ShaderLanguage::hlsl : ShaderLanguage::glsl;
}

class Snippet : public ::testing::TestWithParam<ShaderVariant> {
protected:
    ShaderJob job(std::string expression) const {
        return {.variant = GetParam(),
                .snippet = snippet(language_of(GetParam())),
                .lut = Image<Rgb>(1, 1),
                .inputs = {},
                .expression = std::move(expression),
                .use = {}};
    }

    void expect_fetch_is_linear_interpolation(int width, int height, LutUse use) {
        const Image<Rgb> exact = synthetic_lut(width, height);
        const Image<Rgb> stored = to_half(exact);
        const Coordinates coordinates = probe_coordinates(width, height);
        const std::vector<Rgb> fetched = fetch_baked_lut(GetParam(), stored, coordinates, use);
        const double error = largest_error(fetched, exact, coordinates);
        const double filter_error = largest_error(fetched, stored, coordinates);
        RecordProperty("largest_error", text_of(error));
        RecordProperty("largest_error_of_filter", text_of(filter_error));
        EXPECT_LE(error, fetch_tolerance);
        EXPECT_LE(filter_error, filter_tolerance());
    }
};

TEST_P(Snippet, IsAcceptedByGlslang) {
    for (const bool flip : {false, true}) {
        ShaderJob fetches = job("nacre_fetch(LUT, value.x) + nacre_fetch(LUT, value.x, value.y)");
        fetches.use.first_row_at_v_1 = flip;
        EXPECT_NO_THROW(check_with_glslang(GetParam(), fragment_shader(fetches)));
    }
}

TEST_P(Snippet, AWrongShaderIsRefusedByGlslang) {
    try {
        check_with_glslang(GetParam(), fragment_shader(job("nacre_fetch(LUT)")));
        FAIL() << "nacre_fetch without a coordinate was accepted";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("refuses this shader"), std::string::npos) << error.what();
    }
}

TEST_P(Snippet, FetchOfOneRowIsLinearInterpolationBetweenTexels) {
    expect_fetch_is_linear_interpolation(256, 1, {});
}

TEST_P(Snippet, FetchOfManyRowsIsBilinear) {
    expect_fetch_is_linear_interpolation(64, 32, {});
}

TEST_P(Snippet, FetchOfOddSizesIsBilinear) {
    expect_fetch_is_linear_interpolation(63, 31, {});
}

TEST_P(Snippet, FlipVServesEnginesThatPutTheFirstRowAtVOne) {
    expect_fetch_is_linear_interpolation(64, 32, {.first_row_at_v_1 = true});
}

TEST_P(Snippet, RepeatDoesNoHarmBecauseCoordinatesStayBetweenTexelCentres) {
    expect_fetch_is_linear_interpolation(64, 32, {.repeat = true});
}

TEST_P(Snippet, AxisFunctionsAreThoseOfTheBake) {
    for (const AxisKind& kind : axis_kinds()) {
        ShaderJob axis = job("VEC3(nacre_" + std::string(kind.name) + "(value.x), 0.0, 0.0)");
        // Over its range, and a little beyond either end.
        for (const auto& [along, unused] : probe_coordinates(256, 1))
            axis.inputs.push_back({static_cast<float>(kind.low + (kind.high - kind.low) * along), unused});
        const std::vector<Rgb> coordinates = run_shader(axis);
        double error = 0.0;
        for (std::size_t i = 0; i < coordinates.size(); ++i) {
            const double argument = std::clamp(static_cast<double>(axis.inputs[i][0]), kind.low, kind.high);
            error = std::fmax(error, std::fabs(coordinates[i].r - kind.coordinate(argument)));
        }
        RecordProperty("largest_error_" + std::string(kind.name), text_of(error));
        EXPECT_LE(error, axis_tolerance) << kind.name;
    }
}

TEST_P(Snippet, ParameterAxisIsLinearAndClamped) {
    ShaderJob parameter = job("VEC3(nacre_parameter(value.x, 100.0, 900.0), 0.0, 0.0)");
    parameter.inputs = {{100.0F}, {300.0F}, {900.0F}, {0.0F}, {1000.0F}};
    const std::vector<Rgb> coordinates = run_shader(parameter);
    const std::array<double, 5> expected{0.0, 0.25, 1.0, 0.0, 1.0};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(coordinates[i].r, expected[i], 1e-7);
}

// The tests above must be able to fail: the classic mistake is far outside their tolerance.
TEST_P(Snippet, WithoutTheHalfTexelItWouldFail) {
    ShaderJob broken = job("nacre_fetch(LUT, value.x)");
    const std::size_t at = broken.snippet.find(texcoord_shader_expression);
    ASSERT_NE(at, std::string::npos);
    broken.snippet.replace(at, texcoord_shader_expression.size(), "t");
    broken.lut = to_half(synthetic_lut(256, 1));
    const Coordinates coordinates = probe_coordinates(256, 1);
    for (const auto& [x, y] : coordinates) broken.inputs.push_back({x, y});
    const double error = largest_error(run_shader(broken), broken.lut, coordinates);
    RecordProperty("largest_error", text_of(error));
    EXPECT_GT(error, 5.0 * fetch_tolerance);
}

INSTANTIATE_TEST_SUITE_P(Variants, Snippet,
                         ::testing::Values(ShaderVariant::glsl_es_300, ShaderVariant::glsl_450, ShaderVariant::hlsl),
                         [](const auto& instance) { return std::string(name_of(instance.param)); });

}  // namespace
}  // namespace nacre::testing
