#include "io/image/png_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <limits>

#include "nacre/base/error.h"

namespace nacre {
namespace {

template <typename Component>
std::vector<Component> rounded_components(const Image<Rgb>& image) {
    constexpr double most = std::numeric_limits<Component>::max();
    std::vector<Component> components;
    components.reserve(3 * image.size());
    for (const Rgb& pixel : image) {
        for (const double value : {pixel.r, pixel.g, pixel.b}) {
            // Not negative, and far from what a double cannot hold: std::lround() would take longer than all else here.
            const double above_half = most * std::clamp(value, 0.0, 1.0) + 0.5;
            components.push_back(static_cast<Component>(above_half));
        }
    }
    return components;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image<Rgb>& image, PngDepth depth, bool is_srgb) {
    const bool is_deep = depth == PngDepth::sixteen_bits;
    const OIIO::TypeDesc type = is_deep ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
    std::vector<std::uint8_t> file;
    OIIO::Filesystem::IOVecOutput memory(file);
    const auto output = OIIO::ImageOutput::create("png", &memory);
    if (!output) throw IoError("PNG: OpenImageIO cannot write this format: " + OIIO::geterror());
    OIIO::ImageSpec spec(image.width(), image.height(), 3, type);
    if (is_srgb) spec.attribute("oiio:ColorSpace", "sRGB");
    const auto write = [&] {
        return is_deep ? output->write_image(type, rounded_components<std::uint16_t>(image).data())
                       : output->write_image(type, rounded_components<std::uint8_t>(image).data());
    };
    if (!output->open("picture.png", spec) || !write() || !output->close())
        throw IoError("PNG: OpenImageIO cannot encode the picture: " + output->geterror());
    return file;
}

}  // namespace nacre
