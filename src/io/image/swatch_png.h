#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// XYZ (D65, Y = 1 for the perfect reflector) to display values, [0, 1] per component.
using DisplayTransform = std::function<Image<Rgb>(const Image<Xyz>&)>;

/// How a picture becomes a file.
struct PngSettings {
    std::filesystem::path font;  ///< a font file, see find_font()
    bool is_srgb = true;         ///< whether the transform leads to sRGB; the file says so
    bool compress = true;        ///< compress colours outside sRGB into it, see fit_to_srgb(); only if is_srgb
};

/// The picture as the bytes of a PNG: 8-bit RGB, rounded to nearest, no dithering, no date, no program's name.
///
/// The same picture, font and libraries give the same bytes. May be called from many threads.
/// @throws IoError if the font cannot be used or OpenImageIO cannot encode
std::vector<std::uint8_t> encode_swatch_png(const Swatch& swatch, const DisplayTransform& to_display,
                                            const PngSettings& settings);

}  // namespace nacre
