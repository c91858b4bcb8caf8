#include "pipeline/swatch_file.h"

#include "io/image/swatch_png.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch.h"
#include "pipeline/lut_png.h"

namespace nacre {
std::string swatch_bytes(const PlannedSwatch& swatch, const ColourSpace& space, const ColourSpace& display,
                         const std::filesystem::path& font) {
    const LutSpace lut_space{space.name(), [&](const Image<Xyz>& image) { return space.to_rgb(image); }};
    const PngSettings settings{font, is_srgb_display(display), swatch.gamut == Gamut::compress};
    const auto bytes = encode_swatch_png(
        draw_swatch(swatch, lut_space), [&](const Image<Xyz>& image) { return display.to_rgb(image); }, settings);
    return {bytes.begin(), bytes.end()};
}

}  // namespace nacre
