#include "io/image/png_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace nacre {
namespace {

struct Read {
    OIIO::ImageSpec spec;
    std::vector<std::uint16_t> values;
};

Read read_png(std::vector<std::uint8_t>& file) {
    OIIO::Filesystem::IOMemReader memory(file);
    const auto input = OIIO::ImageInput::open("picture.png", nullptr, &memory);
    if (!input) return {};
    Read read{input->spec(), std::vector<std::uint16_t>(input->spec().image_pixels() * 3)};
    EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT16, read.values.data()));
    return read;
}

Image<Rgb> two_pixels() {
    Image<Rgb> image(1, 2);
    image.at(0, 0) = {0.25, 1.5, -0.5};
    image.at(0, 1) = {100.4 / 65535.0, 100.6 / 65535.0, 1.0};
    return image;
}

TEST(PngFile, OfSixteenBitsHoldsRoundedAndClampedNumbersRowForRow) {
    std::vector<std::uint8_t> file = encode_png(two_pixels(), PngDepth::sixteen_bits, true);
    const Read read = read_png(file);
    EXPECT_EQ(read.spec.format, OIIO::TypeDesc::UINT16);
    EXPECT_EQ(read.spec.nchannels, 3);
    EXPECT_EQ(read.values, (std::vector<std::uint16_t>{16384, 65535, 0, 100, 101, 65535}));
    EXPECT_EQ(read.spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
}

TEST(PngFile, SaysNothingOfTheMachineThatMadeItAndIsTheSameEveryTime) {
    for (const PngDepth depth : {PngDepth::eight_bits, PngDepth::sixteen_bits}) {
        const std::vector<std::uint8_t> file = encode_png(two_pixels(), depth, false);
        const std::string_view bytes(reinterpret_cast<const char*>(file.data()), file.size());
        for (const std::string_view word : {"tIME", "Software", "DateTime", "OpenImageIO", "sRGB"})
            EXPECT_EQ(bytes.find(word), std::string_view::npos) << word;
        EXPECT_EQ(encode_png(two_pixels(), depth, false), file);
    }
}

}  // namespace
}  // namespace nacre
