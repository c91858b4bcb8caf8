#pragma once

#include <cstdint>
#include <vector>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

enum class PngDepth { eight_bits, sixteen_bits };  ///< of a component

/// An RGB picture as the bytes of a PNG: components are clamped to [0, 1] and rounded to nearest. No date, no program's
/// name, no dithering.
/// @param is_srgb  whether the numbers are those of an sRGB display; the file says so
/// @throws IoError if OpenImageIO cannot encode
std::vector<std::uint8_t> encode_png(const Image<Rgb>& image, PngDepth depth, bool is_srgb);

}  // namespace nacre
