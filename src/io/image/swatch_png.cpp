#include "io/image/swatch_png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>

#include "io/image/swatch_canvas.h"
#include "nacre/base/error.h"
#include "nacre/swatch/swatch_gamut.h"

namespace nacre {
namespace {

std::vector<std::uint8_t> eight_bits(const Image<Rgb>& image) {
    const auto rounded = [](double value) {
        return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
    };
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * image.size());
    for (const Rgb& pixel : image) {
        for (const double component : {pixel.r, pixel.g, pixel.b}) bytes.push_back(rounded(component));
    }
    return bytes;
}

std::vector<std::uint8_t> encode_png(const Image<Rgb>& image, bool is_srgb) {
    std::vector<std::uint8_t> file;
    OIIO::Filesystem::IOVecOutput memory(file);
    const auto output = OIIO::ImageOutput::create("png", &memory);
    if (!output) throw IoError("PNG: OpenImageIO cannot write this format: " + OIIO::geterror());
    OIIO::ImageSpec spec(image.width(), image.height(), 3, OIIO::TypeDesc::UINT8);
    if (is_srgb) spec.attribute("oiio:ColorSpace", "sRGB");
    const bool is_written = output->open("swatch.png", spec) &&
                            output->write_image(OIIO::TypeDesc::UINT8, eight_bits(image).data()) && output->close();
    if (!is_written) throw IoError("PNG: OpenImageIO cannot encode the picture: " + output->geterror());
    return file;
}

}  // namespace

std::vector<std::uint8_t> encode_swatch_png(const Swatch& swatch, const DisplayTransform& to_display,
                                            const PngSettings& settings) {
    Canvas canvas(swatch.width, swatch.height, swatch.background, settings.font.string());
    for (const Panel& panel : swatch.panels) {
        const bool is_bent = settings.is_srgb && settings.compress && !panel.is_exact;
        const Image<Rgb> shown = to_display(is_bent ? fit_to_srgb(panel.image) : panel.image);
        assert(shown.width() == panel.image.width() && shown.height() == panel.image.height());
        canvas.paste(panel.left, panel.top, shown);
    }
    for (const Overlay& overlay : swatch.overlays) {
        std::visit([&](const auto& shape) { canvas.draw(shape); }, overlay);
    }
    return encode_png(canvas.pixels(), settings.is_srgb);
}

}  // namespace nacre
