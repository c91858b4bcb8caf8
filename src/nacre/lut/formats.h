#pragma once

#include <array>

#include "nacre/base/words.h"

namespace nacre {

/// The number that a texel's components are stored as.
enum class PixelFormat { half_float, single_float };

/// What is written for a LUT.
enum class LutOutput { exr, json, png };

inline constexpr std::array format_words{
    Word<PixelFormat>{"half", PixelFormat::half_float, "16 bits per component"},
    Word<PixelFormat>{"float", PixelFormat::single_float, "32 bits per component"},
};
inline constexpr std::array output_words{
    Word<LutOutput>{"exr", LutOutput::exr, "the texture"},
    Word<LutOutput>{"json", LutOutput::json, "what the texture is, for tools"},
    Word<LutOutput>{"png", LutOutput::png, "the texels as a 16-bit picture for a display"},
};

}  // namespace nacre
