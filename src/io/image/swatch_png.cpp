#include "io/image/swatch_png.h"

#include <algorithm>
#include <cassert>
#include <variant>

#include "io/image/png_file.h"
#include "io/image/swatch_canvas.h"
#include "nacre/swatch/swatch_gamut.h"

namespace nacre {
namespace {

constexpr int rows_at_once = 16;  // what fits the processor's cache

// From row `top`, so many or what is left.
Image<Xyz> rows_of(const Image<Xyz>& image, int top) {
    Image<Xyz> rows(image.width(), std::min(rows_at_once, image.height() - top));
    std::copy_n(&image.at(0, top), rows.size(), rows.begin());
    return rows;
}

}  // namespace

std::vector<std::uint8_t> encode_swatch_png(const Swatch& swatch, const DisplayTransform& to_display,
                                            const PngSettings& settings) {
    Canvas canvas(swatch.width, swatch.height, swatch.background, settings.font.string());
    for (const Panel& panel : swatch.panels) {
        const bool is_bent = settings.is_srgb && settings.compress && !panel.is_exact;
        for (int top = 0; top < panel.image.height(); top += rows_at_once) {
            const Image<Xyz> rows = rows_of(panel.image, top);
            const Image<Rgb> shown = to_display(is_bent ? fit_to_srgb(rows) : rows);
            assert(shown.width() == rows.width() && shown.height() == rows.height());
            canvas.paste(panel.left, panel.top + top, shown);
        }
    }
    for (const Overlay& overlay : swatch.overlays) {
        std::visit([&](const auto& shape) { canvas.draw(shape); }, overlay);
    }
    return encode_png(canvas.pixels(), PngDepth::eight_bits, settings.is_srgb);
}

}  // namespace nacre
