#include "pipeline/swatch_file.h"

#include <string_view>

#include "io/image/swatch_png.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch.h"

namespace nacre {
namespace {

// What the Color Interop Forum calls the encoding of an sRGB display.
constexpr std::string_view srgb_display_id = "srgb_rec709_display";

}  // namespace

std::string swatch_bytes(const PlannedSwatch& swatch, const ColourSpace& space, const ColourSpace& display,
                         const std::filesystem::path& font) {
    const LutSpace lut_space{space.name(), [&](const Image<Xyz>& image) { return space.to_rgb(image); }};
    const PngSettings settings{font, display.interop_id() == srgb_display_id, swatch.gamut == Gamut::compress};
    const auto bytes = encode_swatch_png(
        draw_swatch(swatch, lut_space), [&](const Image<Xyz>& image) { return display.to_rgb(image); }, settings);
    return {bytes.begin(), bytes.end()};
}

}  // namespace nacre
