#include "io/image/lut_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nacre/base/error.h"
#include "nacre/lut/formats.h"
#include "support/folders.h"

namespace nacre {
namespace {

// Not Rec. 709, which is what OpenEXR takes for granted.
const LutHeader header{"nacre test",
                       "lin_p3d65_scene",
                       std::array<float, 8>{0.68f, 0.32f, 0.265f, 0.69f, 0.15f, 0.06f, 0.3127f, 0.329f},
                       {{"scene", "nacre = 1\n\"quoted\"\n"}, {"version", "9"}}};

Image<Rgb> gradient() {
    Image<Rgb> image(4, 2);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 4; ++x) image.at(x, y) = {0.1 * x, -0.25 * y, 1.0 / 3.0};
    }
    return image;
}

StoredLut write_and_read(PixelFormat format) {
    const test::TemporaryFolder folder;
    return read_lut(folder.file("a.exr", encode_lut(gradient(), format, header)));
}

TEST(LutFile, ComesBackWithItsHeaderAndTheFirstRowFirst) {
    const StoredLut lut = write_and_read(PixelFormat::single_float);
    ASSERT_EQ(lut.image.width(), 4);
    ASSERT_EQ(lut.image.height(), 2);
    EXPECT_EQ(lut.format, PixelFormat::single_float);
    EXPECT_EQ(lut.image.at(3, 0).g, 0.0);
    EXPECT_EQ(lut.image.at(3, 1).g, -0.25);
    EXPECT_EQ(lut.image.at(1, 0).r, static_cast<double>(0.1f));
    EXPECT_EQ(lut.header.software, "nacre test");
    EXPECT_EQ(lut.header.interop_id, "lin_p3d65_scene");
    EXPECT_EQ(lut.header.chromaticities, header.chromaticities);
    EXPECT_EQ(lut.header.value("scene"), "nacre = 1\n\"quoted\"\n");
    EXPECT_EQ(lut.header.value("none"), "");
}

TEST(LutFile, HalfIsRoundedToNearestTiesToEven) {
    EXPECT_EQ(stored_value(1.0 / 3.0, PixelFormat::half_float), 1365.0 / 4096.0);              // 0x3555, by hand
    EXPECT_EQ(stored_value(1.0 + 1.0 / 2048.0, PixelFormat::half_float), 1.0);                 // a tie: to even
    EXPECT_EQ(stored_value(1.0 + 3.0 / 2048.0, PixelFormat::half_float), 1.0 + 2.0 / 1024.0);  // the other tie
    EXPECT_EQ(write_and_read(PixelFormat::half_float).image.at(0, 0).b, 1365.0 / 4096.0);
}

TEST(LutFile, OnlyFormsThatEveryEngineReadsAreWritten) {
    const test::TemporaryFolder folder;
    const auto input =
        OIIO::ImageInput::open(folder.file("a.exr", encode_lut(gradient(), PixelFormat::half_float, header)));
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    EXPECT_EQ(spec.get_string_attribute("compression"), "none");
    EXPECT_EQ(spec.channelnames, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(spec.format, OIIO::TypeDesc::HALF);
    EXPECT_EQ(spec.tile_width, 0);
    EXPECT_EQ(spec.get_int_attribute("oiio:subimages", 1), 1);
}

TEST(LutFile, SameImageIsTheSameBytesAndHoldsNoDate) {
    const std::string bytes = encode_lut(gradient(), PixelFormat::half_float, header);
    EXPECT_EQ(bytes, encode_lut(gradient(), PixelFormat::half_float, header));
    const auto input_year = bytes.find("202");
    EXPECT_EQ(input_year, std::string::npos) << "a year";
    EXPECT_EQ(bytes.find("OpenImageIO"), std::string::npos);
}

TEST(LutFile, ValuesThatTheFormatCannotHoldAreRefused) {
    Image<Rgb> image = gradient();
    image.at(2, 1).g = 70000.0;
    EXPECT_THROW(encode_lut(image, PixelFormat::half_float, header), Error);
    EXPECT_NO_THROW(encode_lut(image, PixelFormat::single_float, header));
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        image.at(2, 1).g = value;
        EXPECT_THROW(encode_lut(image, PixelFormat::single_float, header), Error);
    }
}

}  // namespace
}  // namespace nacre
