#include "io/image/swatch_png.h"

#include <cassert>
#include <variant>

#include "io/image/png_file.h"
#include "io/image/swatch_canvas.h"
#include "nacre/swatch/swatch_gamut.h"

namespace nacre {
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
    return encode_png(canvas.pixels(), PngDepth::eight_bits, settings.is_srgb);
}

}  // namespace nacre
