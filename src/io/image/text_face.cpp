#include "io/image/text_face.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/oiioversion.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "nacre/base/error.h"

namespace nacre {
namespace {

constexpr char32_t replacement = 0xFFFD;

// How many bytes follow the first one of a letter, or -1 where no letter starts (Unicode 15, table 3-7).
int following_bytes(unsigned char first) {
    if (first < 0x80) return 0;
    if (first >= 0xC2 && first < 0xE0) return 1;
    if (first >= 0xE0 && first < 0xF0) return 2;
    if (first >= 0xF0 && first < 0xF5) return 3;
    return -1;
}

constexpr char32_t degree_sign = 0xB0;

// Up to 2.4 OpenImageIO keeps six bits of a letter beyond ASCII (its issue 3933): 40 degrees would read 400.
constexpr bool draws_unicode = OIIO_VERSION >= 20500;

// A stretch of text that OpenImageIO draws in one go. A degree sign is a small, raised o.
struct Run {
    std::string text;
    int size_px;
    int raised_px;
};

std::vector<Run> runs_of(std::string_view text, int size_px) {
    std::vector<Run> runs;
    const auto append = [&](std::string_view letters, int run_size_px, int raised_px) {
        if (runs.empty() || runs.back().size_px != run_size_px) runs.push_back({{}, run_size_px, raised_px});
        runs.back().text += letters;
    };
    std::size_t at = 0;
    for (const Letter& letter : letters_of(text)) {
        if (letter.code == degree_sign) {
            append("o", (3 * size_px + 2) / 5, size_px / 3);
        } else if (letter.code < 0x80 || (draws_unicode && letter.code != replacement)) {
            append(text.substr(at, letter.bytes), size_px, 0);
        } else {
            append("?", size_px, 0);
        }
        at += letter.bytes;
    }
    return runs;
}

}  // namespace

std::vector<Letter> letters_of(std::string_view utf8) {
    constexpr char32_t smallest[] = {0, 0x80, 0x800, 0x10000};
    std::vector<Letter> result;
    std::size_t i = 0;
    while (i < utf8.size()) {
        const auto first = static_cast<unsigned char>(utf8[i]);
        const int following = following_bytes(first);
        char32_t code = following <= 0 ? first : first & (0x3Fu >> following);
        int seen = 0;
        std::size_t next = i + 1;
        for (; seen < following && next < utf8.size() && (utf8[next] & 0xC0) == 0x80; ++seen, ++next) {
            code = (code << 6) | (static_cast<unsigned char>(utf8[next]) & 0x3Fu);
        }
        const bool is_letter = following >= 0 && seen == following && code >= smallest[following] && code <= 0x10FFFF &&
                               (code < 0xD800 || code > 0xDFFF);
        const std::size_t bytes = is_letter ? next - i : 1;
        result.push_back({is_letter ? code : replacement, bytes});
        i += bytes;
    }
    return result;
}

TextFace::TextFace(std::string file) : file_(std::move(file)) {
    if (!OIIO::ImageBufAlgo::text_size("0", 16, file_).defined()) {
        throw IoError(file_ +
                      ": is not a font that OpenImageIO can draw with; install the Debian package fonts-dejavu-core " +
                      "(DejaVuSans.ttf)");
    }
}

// The bar makes OpenImageIO count blanks at the end, which have no pixels.
int TextFace::advance_px(const std::string& text, int size_px) const {
    const auto end_of = [&](const std::string& letters) {
        const auto [place, is_new] = ends_.try_emplace({letters, size_px});
        if (is_new) place->second = OIIO::ImageBufAlgo::text_size(letters, size_px, file_).xend;
        return place->second;
    };
    return end_of(text + "|") - end_of("|");
}

int TextFace::width_px(std::string_view text, int size_px) const {
    int width = 0;
    for (const Run& run : runs_of(text, size_px)) width += advance_px(run.text, run.size_px);
    return width;
}

TextPixels TextFace::draw(std::string_view text, int size_px) const {
    const int margin = size_px;  // accents and overhangs
    TextPixels result{-margin, -2 * size_px, Image<float>(width_px(text, size_px) + 2 * margin, 3 * size_px)};
    Image<float>& coverage = result.coverage;
    OIIO::ImageBuf canvas(OIIO::ImageSpec(coverage.width(), coverage.height(), 1, OIIO::TypeDesc::FLOAT),
                          coverage.data());
    int pen = margin;
    for (const Run& run : runs_of(text, size_px)) {
        if (!OIIO::ImageBufAlgo::render_text(canvas, pen, -result.top - run.raised_px, run.text, run.size_px, file_,
                                             {1.0F})) {
            throw IoError("OpenImageIO cannot draw text: " + canvas.geterror());
        }
        pen += advance_px(run.text, run.size_px);
    }
    return result;
}

}  // namespace nacre
