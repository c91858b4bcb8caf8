#include "pipeline/lut_png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "io/ocio/ocio_spaces.h"

namespace nacre {
namespace {

// IEC 61966-2-1.
double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

std::vector<std::uint16_t> numbers_of(const std::string& png) {
    std::vector<std::uint8_t> file(png.begin(), png.end());
    OIIO::Filesystem::IOMemReader memory(file);
    const auto input = OIIO::ImageInput::open("picture.png", nullptr, &memory);
    if (!input) return {};
    std::vector<std::uint16_t> numbers(input->spec().image_pixels() * 3);
    EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT16, numbers.data()));
    return numbers;
}

TEST(LutPng, IsEncodedAsTheDisplayAsksFor) {
    const auto colours = open_ocio_spaces({});
    const auto display = colours->display_view("", "", "test");
    ASSERT_TRUE(is_srgb_display(*display));
    Image<Rgb> texels(3, 2);
    for (int i = 0; i < 6; ++i) texels.at(i % 3, i / 3) = {0.001 + 0.16 * i, 0.5, 0.9 - 0.1 * i};
    const LutPng png = lut_png(texels, *colours->space("lin_rec709", "test"), *display);
    EXPECT_EQ(png.clamped, 0u);
    const std::vector<std::uint16_t> numbers = numbers_of(png.bytes);
    ASSERT_EQ(numbers.size(), 18u);
    for (std::size_t i = 0; i < 6; ++i) {
        const Rgb& texel = texels.data()[i];
        // 4e-6: of the slope at zero, see configs/README.md; and rounding.
        EXPECT_NEAR(numbers[3 * i] / 65535.0, srgb(texel.r), 2e-5);
        EXPECT_NEAR(numbers[3 * i + 1] / 65535.0, srgb(texel.g), 2e-5);
        EXPECT_NEAR(numbers[3 * i + 2] / 65535.0, srgb(texel.b), 2e-5);
    }
}

TEST(LutPng, CountsTheTexelsThatTheDisplayCannotShow) {
    const auto colours = open_ocio_spaces({});
    const auto display = colours->display_view("", "", "test");
    Image<Rgb> texels(4, 1, {0.5, 0.5, 0.5});
    texels.at(1, 0).r = -0.1;
    texels.at(2, 0).b = 1.2;
    EXPECT_EQ(lut_png(texels, *colours->space("lin_rec709", "test"), *display).clamped, 2u);
    // White, and all colours of sRGB, are what it can show.
    EXPECT_EQ(lut_png(Image<Rgb>(4, 1, {1.0, 1.0, 1.0}), *colours->space("lin_p3d65", "test"), *display).clamped, 0u);
    EXPECT_EQ(lut_png(Image<Rgb>(4, 1, {0.0, 1.0, 0.0}), *colours->space("lin_p3d65", "test"), *display).clamped, 4u);
}

}  // namespace
}  // namespace nacre
