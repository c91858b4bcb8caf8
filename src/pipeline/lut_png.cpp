#include "pipeline/lut_png.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "io/image/png_file.h"

namespace nacre {
namespace {

// What the Color Interop Forum calls the encoding of an sRGB display.
constexpr std::string_view srgb_display_id = "srgb_rec709_display";

bool is_clamped(const Rgb& pixel) {
    constexpr double half_step = 0.5 / 65535.0;
    return std::min({pixel.r, pixel.g, pixel.b}) < -half_step || std::max({pixel.r, pixel.g, pixel.b}) > 1 + half_step;
}

}  // namespace

LutPng lut_png(const Image<Rgb>& texels, const ColourSpace& space, const ColourSpace& display) {
    const Image<Rgb> shown = display.to_rgb(space.to_xyz(texels));
    const std::vector<std::uint8_t> bytes = encode_png(shown, PngDepth::sixteen_bits, is_srgb_display(display));
    return {{bytes.begin(), bytes.end()},
            static_cast<std::size_t>(std::count_if(shown.begin(), shown.end(), is_clamped))};
}

bool is_srgb_display(const ColourSpace& display) {
    return display.interop_id() == srgb_display_id;
}

}  // namespace nacre
