#include "nacre/lut/srgb_colour_space.h"

#include <cmath>

#include "nacre/colour/rgb_space.h"

namespace nacre {
namespace {

// The curve of the config's ExponentWithLinearTransform, gamma 2.4 and offset 0.055, mirrored at zero: a power and a
// line that meet with one slope. (IEC 61966-2-1 rounds that slope to 12.92, which moves no 8-bit number.)
constexpr double gamma = 2.4;
constexpr double offset = 0.055;

double line_slope() {
    return (gamma - 1.0) / offset * std::pow(offset * gamma / ((gamma - 1.0) * (1.0 + offset)), gamma);
}

double decoded(double encoded) {
    const double size = std::abs(encoded);
    const double light =
        size > offset / (gamma - 1.0) ? std::pow((size + offset) / (1.0 + offset), gamma) : size * line_slope();
    return std::copysign(light, encoded);
}

double encoded(double light) {
    const double size = std::abs(light);
    const double number = size > offset / (gamma - 1.0) * line_slope()
                              ? (1.0 + offset) * std::pow(size, 1.0 / gamma) - offset
                              : size / line_slope();
    return std::copysign(number, light);
}

}  // namespace

SrgbColourSpace::SrgbColourSpace() : linear_(known_rgb_spaces().front()) {}

Image<Rgb> SrgbColourSpace::to_rgb(const Image<Xyz>& image) const {
    Image<Rgb> rgb = linear_.to_rgb(image);
    for (Rgb& pixel : rgb) pixel = {encoded(pixel.r), encoded(pixel.g), encoded(pixel.b)};
    return rgb;
}

Image<Xyz> SrgbColourSpace::to_xyz(const Image<Rgb>& image) const {
    Image<Rgb> light = image;
    for (Rgb& pixel : light) pixel = {decoded(pixel.r), decoded(pixel.g), decoded(pixel.b)};
    return linear_.to_xyz(light);
}

}  // namespace nacre
