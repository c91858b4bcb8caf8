#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/bake/image.h"

namespace nacre {

/// A line of text as coverage: how much of each pixel the letters cover, in [0, 1].
struct TextPixels {
    int left = 0;  ///< of the image, relative to the start of the baseline
    int top = 0;   ///< likewise; negative: above it
    Image<float> coverage;
};

/// A font, opened by FreeType.
///
/// OpenImageIO has render_text(), but up to 2.4 it keeps only the last six bits of a letter beyond ASCII, so that a
/// degree sign comes out as a zero (its issue 3933). One thread at a time may use an object; each may have its own.
class TextFace {
public:
    /// @throws IoError if the file is no font
    explicit TextFace(const std::string& file);

    /// In pixels, from the start of the first letter's space to the end of the last one's.
    /// @param text  UTF-8; what is not becomes U+FFFD, and letters that the font lacks become its box
    double width_px(std::string_view text, int size_px) const;
    TextPixels draw(std::string_view text, int size_px) const;

private:
    struct Glyphs;
    std::shared_ptr<Glyphs> glyphs_;
};

/// Code points of UTF-8; every byte that is no part of a letter becomes U+FFFD.
std::vector<char32_t> code_points(std::string_view utf8);

}  // namespace nacre
