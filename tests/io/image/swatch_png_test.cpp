#include "io/image/swatch_png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "io/image/font.h"
#include "io/image/swatch_canvas.h"
#include "io/image/text_face.h"
#include "nacre/base/error.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

// Y as grey, without an encoding: what goes in is what the file must hold.
Image<Rgb> grey(const Image<Xyz>& image) {
    Image<Rgb> result(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double value = image.at(x, y).y;
            result.at(x, y) = {value, value, value};
        }
    }
    return result;
}

Swatch empty_picture() {
    Swatch swatch;
    swatch.width = 200;
    swatch.height = 80;
    return swatch;
}

struct Decoded {
    OIIO::ImageSpec spec;
    std::vector<unsigned char> pixels;
    int at(int x, int y) const { return pixels[3 * static_cast<std::size_t>(y * spec.width + x)]; }
};

Decoded decode(std::vector<std::uint8_t>& file) {
    OIIO::Filesystem::IOMemReader memory(file);
    const auto input = OIIO::ImageInput::open("picture.png", nullptr, &memory);
    if (!input) return {};
    Decoded result{input->spec(), std::vector<unsigned char>(input->spec().image_bytes())};
    EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, result.pixels.data()));
    return result;
}

Decoded encode_and_decode(const Swatch& swatch) {
    std::vector<std::uint8_t> file = encode_swatch_png(swatch, grey, {find_font(), false});
    return decode(file);
}

class SwatchFolder : public testing::Test {
protected:
    void SetUp() override {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder_ = fs::temp_directory_path() /
                  ("nacre_swatch_" + name + std::to_string(std::hash<std::thread::id>{}(std::this_thread::get_id())));
        fs::create_directories(folder_ / "deep" / "deeper");
    }
    void TearDown() override { fs::remove_all(folder_); }
    void write(const fs::path& file, const std::string& content) const { std::ofstream(folder_ / file) << content; }

    fs::path folder_;
};

TEST(SwatchPng, IsAnEightBitRgbPictureOfTheAskedSize) {
    const Decoded decoded = encode_and_decode(empty_picture());
    EXPECT_EQ(decoded.spec.width, 200);
    EXPECT_EQ(decoded.spec.height, 80);
    EXPECT_EQ(decoded.spec.nchannels, 3);
    EXPECT_EQ(decoded.spec.format, OIIO::TypeDesc::UINT8);
    EXPECT_EQ(decoded.at(5, 5), 27);  // 255 x 0.105 = 26.8
}

TEST(SwatchPng, PixelsAreRoundedToTheNearestOf256Levels) {
    Swatch swatch = empty_picture();
    Panel panel{10, 20, Image<Xyz>(4, 1)};
    panel.image.at(0, 0) = {0.0, 100.49 / 255.0, 0.0};
    panel.image.at(1, 0) = {0.0, 100.51 / 255.0, 0.0};
    panel.image.at(2, 0) = {0.0, 1.7, 0.0};
    panel.image.at(3, 0) = {0.0, -0.2, 0.0};
    swatch.panels.push_back(panel);
    const Decoded decoded = encode_and_decode(swatch);
    EXPECT_EQ(decoded.at(10, 20), 100);
    EXPECT_EQ(decoded.at(11, 20), 101);
    EXPECT_EQ(decoded.at(12, 20), 255);
    EXPECT_EQ(decoded.at(13, 20), 0);
    EXPECT_EQ(decoded.at(14, 20), 27);
}

TEST(SwatchPng, TheSamePictureGivesTheSameBytesOnEveryThread) {
    Swatch swatch = empty_picture();
    swatch.overlays.push_back(Text{"λ = 460 nm at θ = 40°", {10.0, 40.0}});
    swatch.overlays.push_back(Polyline{{{5.0, 5.0}, {190.0, 70.0}, {100.0, 10.0}}, 2.5, {1.0, 0.5}, {}});
    const PngSettings settings{find_font()};
    const auto first = encode_swatch_png(swatch, grey, settings);
    std::vector<std::vector<std::uint8_t>> others(4);
    std::vector<std::thread> threads;
    for (auto& other : others) threads.emplace_back([&] { other = encode_swatch_png(swatch, grey, settings); });
    for (std::thread& thread : threads) thread.join();
    for (const auto& other : others) EXPECT_EQ(other, first);
}

TEST(SwatchPng, SaysThatItIsSrgbAndNothingOfTheMachineThatMadeIt) {
    std::vector<std::uint8_t> file = encode_swatch_png(empty_picture(), grey, {find_font()});
    const std::string_view bytes(reinterpret_cast<const char*>(file.data()), file.size());
    for (const std::string_view word : {"tIME", "Software", "DateTime", "OpenImageIO", "swatch.png", "/"}) {
        EXPECT_EQ(bytes.substr(0, bytes.find("IDAT")).find(word), std::string_view::npos) << word;
    }
    EXPECT_NE(bytes.find("sRGB"), std::string_view::npos);
    EXPECT_EQ(decode(file).spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
}

TEST(SwatchPng, AFontThatIsNoneIsAnErrorInOneLine) {
    try {
        encode_swatch_png(empty_picture(), grey, {"/nowhere/DejaVuSans.ttf"});
        FAIL();
    } catch (const IoError& error) {
        EXPECT_STREQ(
            error.what(),
            "/nowhere/DejaVuSans.ttf: is not a font that OpenImageIO can draw with; install the Debian package "
            "fonts-dejavu-core (DejaVuSans.ttf)");
    }
}

TEST(Canvas, TextIsDrawnWhereItIsAligned) {
    Swatch swatch = empty_picture();
    swatch.overlays.push_back(Text{"HHHH", {100.0, 50.0}, 22, Align::right});
    const Decoded decoded = encode_and_decode(swatch);
    int left = 0, right = 0;
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 200; ++x) (x < 100 ? left : right) += decoded.at(x, y) > 200;
    }
    EXPECT_GT(left, 100);
    EXPECT_EQ(right, 0);
}

TEST(Canvas, LongTextIsMadeToFit) {
    Swatch swatch = empty_picture();
    swatch.overlays.push_back(Text{std::string(100000, 'W'), {10.0, 40.0}, 30, Align::left, 1.0, 120.0});
    const Decoded decoded = encode_and_decode(swatch);
    int beyond = 0;
    for (int y = 0; y < 80; ++y) {
        for (int x = 131; x < 200; ++x) beyond += decoded.at(x, y) != 27;
    }
    EXPECT_EQ(beyond, 0);
}

TEST(Canvas, ABoxOnWholePixelsHasSharpEdges) {
    Canvas canvas(10, 10, 0.0, find_font().string());
    canvas.draw(Rectangle{{2.0, 3.0, 5.0, 4.0}, {}, {1.0}});
    EXPECT_EQ(canvas.pixels().at(1, 3).g, 0.0);
    EXPECT_EQ(canvas.pixels().at(2, 3).g, 1.0);
    EXPECT_EQ(canvas.pixels().at(4, 3).g, 1.0);
    EXPECT_EQ(canvas.pixels().at(5, 3).g, 0.0);
    EXPECT_EQ(canvas.pixels().at(2, 4).g, 0.0);
}

TEST(Canvas, ALineIsAsWideAsAskedAndNowhereDarkerAtItsJoints) {
    Canvas canvas(40, 40, 0.0, find_font().string());
    canvas.draw(Polyline{{{-5.0, 20.0}, {20.0, 20.0}, {45.0, 20.0}}, 3.0, {1.0, 0.5}, {}});
    for (const int x : {5, 19, 20, 35}) {
        double sum = 0.0;
        for (int y = 0; y < 40; ++y) sum += canvas.pixels().at(x, y).r;
        EXPECT_NEAR(sum, 0.5 * 3.0, 1e-6) << x;
    }
}

TEST(Canvas, AClippedLineStaysInside) {
    Canvas canvas(40, 40, 0.0, find_font().string());
    canvas.draw(Polyline{{{0.0, 20.0}, {40.0, 20.0}}, 3.0, {1.0}, Box{10.0, 0.0, 30.0, 40.0}});
    EXPECT_EQ(canvas.pixels().at(9, 20).r, 0.0);
    EXPECT_GT(canvas.pixels().at(10, 20).r, 0.9);
    EXPECT_EQ(canvas.pixels().at(30, 20).r, 0.0);
}

// OpenImageIO 2.4 would draw "0", "8", "$" and ";" here: the last six bits of each.
TEST(TextFace, LettersBeyondAsciiAreNotMistakenForOthers) {
    const TextFace face(find_font().string());
    const auto pixels = [&](std::string_view text) {
        const TextPixels drawn = face.draw(text, 40);
        return std::vector<float>(drawn.coverage.begin(), drawn.coverage.end());
    };
    for (const auto& [letter, wrong] : {std::pair{"°", "0"}, {"θ", "8"}, {"ä", "$"}, {"λ", ";"}, {"×", "\x17"}}) {
        EXPECT_NE(pixels(letter), pixels(wrong)) << letter;
    }
}

TEST(TextFace, DegreeSignIsARaisedRing) {
    const TextPixels ring = TextFace(find_font().string()).draw("°", 40);
    float highest = 0.0F;
    for (int y = 0; y < ring.coverage.height(); ++y) {
        for (int x = 0; x < ring.coverage.width(); ++x) {
            if (ring.coverage.at(x, y) > 0.5F) {
                EXPECT_LT(ring.top + y, -10) << "above the baseline by a quarter of the size";
            }
            highest = std::max(highest, ring.coverage.at(x, y));
        }
    }
    EXPECT_GT(highest, 0.5F);
}

TEST(TextFace, BlanksTakeRoomAndWidthsAdd) {
    const TextFace face(find_font().string());
    EXPECT_GT(face.width_px("a ", 40), face.width_px("a", 40) + 5);
    EXPECT_NEAR(face.width_px("40° and", 40),
                face.width_px("40", 40) + face.width_px("°", 40) + face.width_px(" and", 40), 2);
}

std::vector<char32_t> code_points(std::string_view text) {
    std::vector<char32_t> codes;
    for (const Letter& letter : letters_of(text)) codes.push_back(letter.code);
    return codes;
}

TEST(TextFace, CodePointsFollowUnicodeTable37) {
    EXPECT_EQ(code_points("a°θ€😀"), (std::vector<char32_t>{U'a', U'°', U'θ', U'€', U'😀'}));
    // Cut short, overlong, a surrogate, beyond the last plane, a lone continuation: one replacement per byte.
    EXPECT_EQ(code_points("\xCE"), (std::vector<char32_t>{0xFFFD}));
    EXPECT_EQ(code_points("\xC0\xB0z"), (std::vector<char32_t>{0xFFFD, 0xFFFD, U'z'}));
    EXPECT_EQ(code_points("\xED\xA0\x80"), (std::vector<char32_t>{0xFFFD, 0xFFFD, 0xFFFD}));
    EXPECT_EQ(code_points("\xF4\x90\x80\x80"), (std::vector<char32_t>{0xFFFD, 0xFFFD, 0xFFFD, 0xFFFD}));
    EXPECT_EQ(code_points("\x80"), (std::vector<char32_t>{0xFFFD}));
    EXPECT_TRUE(code_points("").empty());
}

TEST_F(SwatchFolder, DejaVuIsPreferredWhereverItLies) {
    write("NotoSans-Regular.ttf", "");
    write("deep/LiberationSans-Regular.ttf", "");
    const std::vector<fs::path> folders{folder_ / "not there", folder_};
    EXPECT_EQ(find_font(folders), folder_ / "deep/LiberationSans-Regular.ttf");
    write("deep/deeper/DejaVuSans.ttf", "");
    EXPECT_EQ(find_font(folders), folder_ / "deep/deeper/DejaVuSans.ttf");
}

TEST_F(SwatchFolder, WithoutAFontTheErrorNamesThePackage) {
    const std::vector<fs::path> folders{folder_};
    try {
        find_font(folders);
        FAIL();
    } catch (const IoError& error) {
        EXPECT_STREQ(error.what(),
                     "pictures need a font, and nacre found none; install the Debian package fonts-dejavu-core "
                     "(DejaVuSans.ttf), or Liberation Sans or Noto Sans");
    }
}

TEST_F(SwatchFolder, AFileThatOnlyLooksLikeAFontIsAnError) {
    write("DejaVuSans.ttf", "this is no font");
    EXPECT_THROW(TextFace((folder_ / "DejaVuSans.ttf").string()), IoError);
}

}  // namespace
}  // namespace nacre
