// The whole road: a scene is baked to a half-float EXR, the EXR is read, a shader fetches from it with nacre's snippet
// on a graphics pipeline, and what comes out is the core's own value at that angle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "consumers/shader_runner.h"
#include "io/ocio/colour_config.h"
#include "io/scene/scene_file.h"
#include "nacre/accuracy/exact_colour.h"
#include "nacre/accuracy/trial.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/lut/sampler.h"
#include "nacre/lut/snippet.h"
#include "pipeline/baked_lut.h"
#include "support/folders.h"

namespace nacre::testing {
namespace {

constexpr int count = 10000;
// Half stores 1 to within 4.9e-4 and linear interpolation of 256 texels adds some 1e-4; the contract says 1e-3.
constexpr double tolerance = 1e-3;

struct Baked {
    PlannedLut lut;
    Image<Rgb> stored;
    ColourTransform transform;
};

Baked bake_and_read(const std::string& scene) {
    const Plan plan = plan_scene(parse_scene(scene, "test"), scene_files());
    const ColourConfig config = ColourConfig::open({"", "", "test"});
    const ColourTransform transform = config.to_colour_space(plan.colour.space, "test");
    const ChosenLut chosen = choose_lut(plan.luts.front(), lut_encoding(transform, plan.colour.gamut));
    const PlannedLut& lut = chosen.lut;
    const test::TemporaryFolder folder;
    const std::string file =
        folder.file("lut.exr", encode_lut(bake_lut(chosen, plan, {}, transform).image, lut.format, {}));
    return {lut, read_lut(file).image, transform};
}

double largest_error(const Baked& baked, const std::vector<Rgb>& fetched,
                     const std::vector<std::array<float, 4>>& inputs,
                     const std::function<std::array<double, 2>(const std::array<float, 4>&)>& coordinates) {
    double largest = 0.0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto [x, y] = coordinates(inputs[i]);
        const Rgb exact = baked.transform.to_rgb(exact_xyz(baked.lut.job, x, y));
        largest = std::max({largest, std::abs(fetched[i].r - exact.r), std::abs(fetched[i].g - exact.g),
                            std::abs(fetched[i].b - exact.b)});
    }
    return largest;
}

std::vector<std::array<float, 4>> random_inputs() {
    std::mt19937 generator(20140);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    std::vector<std::array<float, 4>> inputs{{0, 0, 0, 0}, {1, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}};
    while (inputs.size() < count) inputs.push_back({uniform(generator), uniform(generator), 0, 0});
    return inputs;
}

const std::string morpho =
    "[material.m]\nshape = 0.26\n"
    "picks = [ { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1.0 }, { angle_deg = 40, peak_nm = 395, "
    "width_nm = 60, height = 0.7 } ]\n";
const std::string beetle =
    "[material.b]\nshape = 0.91\n"
    "picks = [ { angle_deg = 10, peak_nm = 530, width_nm = 110, height = 0.73 }, { angle_deg = 60, peak_nm = 460, "
    "width_nm = 110, height = 1.0 } ]\n";

class BakedLut1D : public ::testing::TestWithParam<ShaderVariant> {};

std::vector<Rgb> fetch(const Baked& baked, ShaderVariant variant, const std::string& expression, LutUse use = {}) {
    const auto language = variant == ShaderVariant::hlsl ? ShaderLanguage::hlsl : ShaderLanguage::glsl;
    return run_shader({variant, snippet(language), baked.stored, random_inputs(), expression, use});
}

TEST_P(BakedLut1D, AShaderFetchesTheCoresOwnValueAtTenThousandCosines) {
    for (const std::string& scene : {morpho, beetle}) {
        for (const AxisKind& kind : axis_kinds()) {
            if (kind.quantity != Quantity::incidence) continue;
            const Baked baked = bake_and_read(scene + "[lut.a]\nsize = 512\nx = \"" + std::string(kind.name) + "\"\n");
            const auto fetched =
                fetch(baked, GetParam(), "nacre_fetch(LUT, nacre_" + std::string(kind.name) + "(value.x))");
            const double error = largest_error(baked, fetched, random_inputs(), [&](const auto& input) {
                return std::array<double, 2>{kind.coordinate(static_cast<double>(input[0])), 0.0};
            });
            // cos and theta waste texels where the colour does not change: their own error, seen in exact arithmetic,
            // is what linear interpolation of 512 texels leaves.
            EXPECT_LE(error, tolerance) << kind.name;
            RecordProperty(std::string(kind.name), std::to_string(error));
        }
    }
}

/// The largest CIEDE2000 between what a shader fetched and the model, at the scale of the brightest texel.
double largest_difference(const Baked& baked, const std::vector<Rgb>& fetched,
                          const std::function<std::array<double, 2>(const std::array<float, 4>&)>& coordinates) {
    const auto inputs = random_inputs();
    const double scale = display_scale(baked.transform.to_xyz(baked.stored));
    Sampler model(baked.lut.job);
    double largest = 0.0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const Xyz seen = baked.transform.to_xyz(Image<Rgb>(1, 1, fetched[i])).at(0, 0);
        const auto [x, y] = coordinates(inputs[i]);
        const Xyz exact = model.at(x, y);
        largest = std::max(largest, difference_at(seen, exact, scale));
    }
    return largest;
}

/// The bound of the contract, kept by a graphics pipeline and not only by our model of one.
void expect_keeps_its_bound(ShaderVariant variant, const std::string& scene, const std::string& expression,
                            const std::function<double(double)>& coordinate) {
    const Baked baked = bake_and_read(scene);
    const double largest = largest_difference(baked, fetch(baked, variant, expression), [&](const auto& input) {
        return std::array<double, 2>{coordinate(static_cast<double>(input[0])), 0.0};
    });
    EXPECT_LE(largest, baked.lut.request.max_de00);
    EXPECT_GT(largest, 0.2 * baked.lut.request.max_de00);  // or it was not the worst that was looked at
}

TEST_P(BakedLut1D, DefaultLutOfAShippedSceneKeepsItsBound) {
    for (const std::string& scene : {morpho, beetle}) {
        expect_keeps_its_bound(GetParam(), scene, "nacre_fetch(LUT, nacre_sqrt_cos_theta(value.x))",
                               [](double cos_theta) { return std::sqrt(cos_theta); });
    }
}

TEST_P(BakedLut1D, AGratingIsFetchedByTheSumOfSinesOfEitherSign) {
    const std::string scene = "[material.g]\nmechanism = \"grating\"\nperiod_nm = 1600\ngrooves = 4\ndepth_nm = 120\n";
    for (const std::string sign : {"2.0", "-2.0"}) {
        expect_keeps_its_bound(GetParam(), scene, "nacre_fetch(LUT, nacre_grating_u(" + sign + " * value.x))",
                               [](double half_u) { return half_u; });
    }
}

TEST_P(BakedLut1D, ScatteringIsFetchedByTheCosineOfTheTurn) {
    expect_keeps_its_bound(
        GetParam(),
        "[material.s]\nmechanism = \"scatter\"\nmodel = \"mie\"\nparticle = 1.5\nmedium = 1\nradius_nm = 300\n"
        "volume_fraction = 0.01\nthickness_um = 10\n",
        "nacre_fetch(LUT, nacre_cos_scatter(2.0 * value.x - 1.0))", [](double along) { return along; });
}

TEST_P(BakedLut1D, LutOf256TexelsIsWithinAThousandthOfTheModel) {
    for (const std::string& scene : {morpho, beetle}) {
        const Baked baked = bake_and_read("[accuracy]\nsize = 256\n" + scene);
        ASSERT_EQ(baked.stored.width(), 256);
        const auto fetched = fetch(baked, GetParam(), "nacre_fetch(LUT, nacre_sqrt_cos_theta(value.x))");
        const double error = largest_error(baked, fetched, random_inputs(), [](const auto& input) {
            return std::array<double, 2>{std::sqrt(static_cast<double>(input[0])), 0.0};
        });
        EXPECT_LE(error, tolerance);
    }
}

TEST_P(BakedLut1D, TwoDimensionalLutIsFetchedOverTheAngleAndTheParameter) {
    const Baked baked =
        bake_and_read(beetle + "[lut.a]\ny = { parameter = \"width_nm\", from = 40, to = 200 }\nsize = [256, 256]\n");
    for (const bool first_row_at_v_1 : {false, true}) {
        const auto fetched = fetch(
            baked, GetParam(),
            "nacre_fetch(LUT, nacre_sqrt_cos_theta(value.x), nacre_parameter(40.0 + 160.0 * value.y, 40.0, 200.0))",
            {first_row_at_v_1, false});
        EXPECT_LE(largest_error(baked, fetched, random_inputs(),
                                [](const auto& input) {
                                    return std::array<double, 2>{std::sqrt(static_cast<double>(input[0])),
                                                                 static_cast<double>(input[1])};
                                }),
                  tolerance);
    }
}

// Both forms of a lit material: row 0 at the facet that mirrors the light, the row of the roughness at N and V.
TEST_P(BakedLut1D, RoughSurfacesAreFetchedByLightAndByEnvironment) {
    const std::string vec3 = GetParam() == ShaderVariant::hlsl ? "float3" : "vec3";
    const std::string to_eye = vec3 + "(sqrt(1.0 - value.x * value.x), 0.0, value.x)";
    const std::string to_light = vec3 + "(-sqrt(1.0 - value.x * value.x), 0.0, value.x)";
    const std::string rows = "[lut.a]\ny = { parameter = \"roughness\", from = 0, to = 1 }\nmax_de00 = 0.5\n";
    const std::string soap = "[material.s]\nmechanism = \"film\"\nindex = 1.33\nthickness_nm = 400\n";
    for (const std::string& scene : {soap + rows, beetle + rows}) {
        const Baked baked = bake_and_read(scene);
        const std::string punctual = "nacre_punctual(LUT, " + to_light + ", " + to_eye + ")";
        const std::string environment = "nacre_environment(LUT, " + vec3 + "(0.0, 0.0, 1.0), " + to_eye + ", value.y)";
        const auto cosine = [](const auto& input) { return std::sqrt(static_cast<double>(input[0])); };
        const double of_light = largest_difference(baked, fetch(baked, GetParam(), punctual), [&](const auto& input) {
            return std::array<double, 2>{cosine(input), 0.0};
        });
        const double of_environment =
            largest_difference(baked, fetch(baked, GetParam(), environment), [&](const auto& input) {
                return std::array<double, 2>{cosine(input), static_cast<double>(input[1])};
            });
        EXPECT_LE(of_light, baked.lut.request.max_de00);
        EXPECT_LE(of_environment, baked.lut.request.max_de00);
        EXPECT_GT(of_environment, 0.2 * baked.lut.request.max_de00);
    }
}

// The function as luts/README.md prints it.
std::string lit_material() {
    std::ifstream page(std::string(NACRE_SOURCE_DIR) + "/luts/README.md");
    std::string code;
    for (std::string line; std::getline(page, line);) {
        if (code.empty() && line.find("vec3 nacre_lit(") == std::string::npos) continue;
        code += line + "\n";
        if (line == "    }") break;
    }
    return code;
}

class LitMaterial : public ::testing::TestWithParam<ShaderVariant> {};

TEST_P(LitMaterial, OfThePageIsTheEnvironmentTimesItsEnergyWithoutALight) {
    const Baked baked = bake_and_read(
        "[material.s]\nmechanism = \"film\"\nindex = 2.4\nthickness_nm = 130\nsubstrate = \"cr\"\n[lut.a]\n"
        "y = { parameter = \"roughness\", from = 0, to = 1 }\nmax_de00 = 0.5\n");
    const std::string eye = "vec3(sqrt(1.0 - value.x * value.x), 0.0, value.x)";
    const std::string up = "vec3(0.0, 0.0, 1.0)";
    const std::string code = snippet(ShaderLanguage::glsl) + "precision highp float;\n" + lit_material();
    const auto run = [&](const std::string& expression) {
        ShaderJob job{GetParam(), code, baked.stored, random_inputs(), expression, {}};
        return run_shader(job);
    };
    const auto lit = [&](const std::string& light, const std::string& sky) {
        return run("nacre_lit(LUT, " + up + ", " + eye + ", " + up + ", vec3(" + light + "), vec3(" + sky +
                   "), vec2(0.5, 0.25), value.y)");
    };
    const std::vector<Rgb> under_sky = lit("0.0", "2.0");
    const std::vector<Rgb> fetched = run("nacre_environment(LUT, " + up + ", " + eye + ", value.y)");
    const std::vector<Rgb> under_light = lit("1.0", "0.0");
    for (std::size_t i = 0; i < fetched.size(); ++i) {
        EXPECT_NEAR(under_sky[i].g, 1.5 * fetched[i].g, 1e-5);
        EXPECT_GE(under_light[i].g, 0.0);
        EXPECT_TRUE(std::isfinite(under_light[i].g));
    }
}

INSTANTIATE_TEST_SUITE_P(Variants, LitMaterial, ::testing::Values(ShaderVariant::glsl_es_300, ShaderVariant::glsl_450));

INSTANTIATE_TEST_SUITE_P(Variants, BakedLut1D,
                         ::testing::Values(ShaderVariant::glsl_es_300, ShaderVariant::glsl_450, ShaderVariant::hlsl));

}  // namespace
}  // namespace nacre::testing
