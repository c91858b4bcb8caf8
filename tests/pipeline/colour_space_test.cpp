// The two providers of colour spaces give the same numbers, and a LUT is baked without OpenColorIO.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "io/image/lut_file.h"
#include "io/ocio/ocio_spaces.h"
#include "nacre/base/error.h"
#include "nacre/colour/rgb_space.h"
#include "nacre/lut/colour_space.h"
#include "nacre/lut/rgb_colour_space.h"
#include "pipeline/baked_lut.h"
#include "pipeline/decide.h"
#include "pipeline/loaded_scene.h"
#include "pipeline/verify_lut.h"
#include "support/folders.h"

namespace nacre::test {
namespace {

// Saturated, dark, bright and imaginary colours.
Image<Xyz> some_colours() {
    Image<Xyz> colours(5, 1);
    colours.at(0, 0) = {0.4, 0.2, 0.02};
    colours.at(1, 0) = {0.95, 1.0, 1.09};
    colours.at(2, 0) = {0.01, 0.002, 0.05};
    colours.at(3, 0) = {3.0, 7.0, 0.5};
    colours.at(4, 0) = {-0.1, 0.5, 0.2};
    return colours;
}

double largest_difference(const Image<Rgb>& one, const Image<Rgb>& other) {
    double largest = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        const Rgb& a = one.data()[i];
        const Rgb& b = other.data()[i];
        largest = std::max({largest, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    }
    return largest;
}

class SharedSpace : public testing::TestWithParam<std::string> {};

// Both matrices are rounded to 15 digits; components reach 15, so the last digits add up to some 1e-13.
constexpr double matrix_tolerance = 1e-13;

TEST_P(SharedSpace, HasTheSameNumbersFromBothProviders) {
    const auto own = own_colour_spaces()->space(GetParam(), "test");
    const auto ocio = open_ocio_spaces({"", "", "test"})->space(GetParam(), "test");
    const Image<Xyz> colours = some_colours();
    EXPECT_LE(largest_difference(own->to_rgb(colours), ocio->to_rgb(colours)), matrix_tolerance);
    EXPECT_EQ(own->name(), ocio->name());
    EXPECT_EQ(own->interop_id(), ocio->interop_id());
    ASSERT_TRUE(own->has_inverse() && ocio->has_inverse());
    const Image<Xyz> back = own->to_xyz(own->to_rgb(colours));
    for (std::size_t i = 0; i < colours.size(); ++i) {
        EXPECT_NEAR(back.data()[i].x, colours.data()[i].x, 1e-14);
        EXPECT_NEAR(back.data()[i].y, colours.data()[i].y, 1e-14);
        EXPECT_NEAR(back.data()[i].z, colours.data()[i].z, 1e-14);
    }
}

TEST_P(SharedSpace, IsReadByOpenColorIoFromTheTextThatTheCoreWrites) {
    const auto own = own_colour_spaces()->space(GetParam(), "test");
    const auto read = ocio_space_of_text(own->transform_text(), own->name(), "test", own->interop_id());
    ASSERT_TRUE(read->linear_matrix());
    EXPECT_EQ(*read->linear_matrix(), *own->linear_matrix());
    EXPECT_EQ(read->interop_id(), own->interop_id());
    EXPECT_EQ(read->transform_text(), own->transform_text());
}

std::string name_of_space(const testing::TestParamInfo<std::string>& info) {
    return info.param;
}

std::vector<std::string> all_own_names() {
    return own_colour_spaces()->names();
}

INSTANTIATE_TEST_SUITE_P(Spaces, SharedSpace, testing::ValuesIn(all_own_names()), name_of_space);

TEST(OwnColourSpaces, AreFoundByAliasAndInteropId) {
    const auto own = own_colour_spaces();
    EXPECT_EQ(own->space("ACEScg", "test")->name(), "lin_ap1");
    EXPECT_EQ(own->space("lin_rec2020_scene", "test")->name(), "lin_rec2020");
    try {
        own->space("lin_rec907", "s.toml:3:9 [colour]");
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "s.toml:3:9 [colour]: unknown colour space \"lin_rec907\"; known: lin_rec709, lin_p3d65, "
                  "lin_rec2020, lin_adobergb, lin_ap0, lin_ap1");
    }
}

// OpenColorIO computes its curve in float: half of its last digit at 1, and what float's power adds.
TEST(OwnColourSpaces, ShowTheSameOnAnSrgbDisplay) {
    const auto own = own_colour_spaces()->display_view("", "", "test");
    const auto ocio = open_ocio_spaces({"", "", "test"})->display_view("sRGB", "Standard", "test");
    EXPECT_EQ(own->name(), ocio->name());
    EXPECT_EQ(own->interop_id(), ocio->interop_id());
    for (const double grey : {0.0, 0.001, 0.0031, 0.18, 0.5, 1.0}) {
        const Xyz colour{0.9504559270516716 * grey, grey, 1.0890577507598784 * grey};
        EXPECT_NEAR(own->to_rgb(colour).g, ocio->to_rgb(colour).g, 1e-5) << grey;
    }
}

// ---- a whole LUT

constexpr const char* morpho =
    "nacre = 1\n[material.morpho]\npicks = [\n"
    "    { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1 },\n"
    "    { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 },\n]\n";

struct Baked {
    BakedLut lut;
    PixelFormat format;
};

Baked bake_with(const OpenColourSpaces& open_colours) {
    SceneRequest request;
    request.open_colours = open_colours;
    std::vector<LoadedScene> scenes;
    scenes.push_back(load_scene_text(morpho, "s.toml", request));
    std::vector<DecidedLut> luts = undecided_luts(scenes);
    decide_all(luts, {});
    const LoadedScene& scene = scenes.front();
    return {bake_lut(luts.front().lut, scene.plan, scene.source, scene.space_of(scene.plan.colour)),
            luts.front().lut.lut.format};
}

TEST(OwnColourSpaces, BakeALutWithoutOpenColorIo) {
    const BakedLut own = bake_with(own_colour_spaces).lut;
    const BakedLut ocio = bake_with(open_ocio_spaces).lut;
    ASSERT_EQ(own.image.width(), ocio.image.width());
    // Half is rounded: a last digit of the matrix may turn a tie, by one step of half below 1.
    EXPECT_LE(largest_difference(own.image, ocio.image), 0.0005);
    EXPECT_EQ(own.reached, ocio.reached);
    EXPECT_EQ(own.header.interop_id, "lin_rec709_scene");
    EXPECT_EQ(own.header.chromaticities, ocio.header.chromaticities);
    EXPECT_EQ(own.header.value("scene"), ocio.header.value("scene"));
    EXPECT_EQ(own.header.value("colourConfig"), "nacre (compiled in)");
}

TEST(OwnColourSpaces, MakeAFileThatVerifiesWithOpenColorIo) {
    const Baked own = bake_with(own_colour_spaces);
    const TemporaryFolder folder;
    const std::string file = folder.file("morpho.exr", encode_lut(own.lut.image, own.format, own.lut.header));
    const Verification found = verify_lut(read_lut(file), ocio_space_of_text);
    EXPECT_TRUE(found.passed()) << found.problem;
}

TEST(Execution, TellsHowFarItIsAndStopsWhenItsStepThrows) {
    SceneRequest request;
    request.open_colours = own_colour_spaces;
    std::vector<LoadedScene> scenes;
    scenes.push_back(load_scene_text(morpho, "s.toml", request));
    std::vector<DecidedLut> luts = undecided_luts(scenes);
    std::size_t told = 0;
    Execution execution;
    execution.progress = [&](std::size_t done, std::size_t) { told = done; };
    decide_all(luts, execution);
    EXPECT_EQ(told, 1U);
    struct Stop {};
    execution.step = [] { throw Stop{}; };
    EXPECT_THROW(decide_all(luts, execution), Stop);
}

}  // namespace
}  // namespace nacre::test
