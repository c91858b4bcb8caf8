#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nacre/base/image.h"

namespace nacre {

/// A line of text as coverage: how much of each pixel the letters cover, in [0, 1].
struct TextPixels {
    int left = 0;  ///< of the image, relative to the start of the baseline
    int top = 0;   ///< likewise; negative: above it
    Image<float> coverage;
};

/// A font that OpenImageIO draws text with.
///
/// Up to version 2.4, render_text() cannot draw beyond ASCII: a degree sign becomes a small raised o, and any other
/// such letter a question mark. Each thread needs its own; OpenImageIO lets one draw at a time.
class TextFace {
public:
    /// @throws IoError if the file is not a font
    explicit TextFace(std::string file);

    /// In pixels, from the start of the first letter's space to the end of the last one's.
    /// @param text  UTF-8
    int width_px(std::string_view text, int size_px) const;
    TextPixels draw(std::string_view text, int size_px) const;

private:
    // Where the next letter would start.
    int advance_px(const std::string& text, int size_px) const;

    std::string file_;
    mutable std::map<std::pair<std::string, int>, int>
        ends_;  // of texts of a size, because OpenImageIO measures slowly
};

/// A letter of UTF-8 and how many bytes it takes; every byte that is not part of a letter counts as one U+FFFD.
struct Letter {
    char32_t code;
    std::size_t bytes;
    friend bool operator==(const Letter&, const Letter&) = default;
};
std::vector<Letter> letters_of(std::string_view utf8);

}  // namespace nacre
