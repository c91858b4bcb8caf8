#include "io/text_face.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nacre/error.h"

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

double pixels(FT_Pos position_26_6) {
    return static_cast<double>(position_26_6) / 64.0;
}

}  // namespace

std::vector<char32_t> code_points(std::string_view utf8) {
    constexpr char32_t smallest[] = {0, 0x80, 0x800, 0x10000};
    std::vector<char32_t> result;
    std::size_t i = 0;
    while (i < utf8.size()) {
        const auto first = static_cast<unsigned char>(utf8[i++]);
        const int following = following_bytes(first);
        char32_t letter = following <= 0 ? first : first & (0x3Fu >> following);
        int seen = 0;
        std::size_t next = i;
        for (; seen < following && next < utf8.size() && (utf8[next] & 0xC0) == 0x80; ++seen, ++next) {
            letter = (letter << 6) | (static_cast<unsigned char>(utf8[next]) & 0x3Fu);
        }
        const bool is_letter = following >= 0 && seen == following && letter >= smallest[following] &&
                               letter <= 0x10FFFF && (letter < 0xD800 || letter > 0xDFFF);
        result.push_back(is_letter ? letter : replacement);
        if (is_letter) i = next;
    }
    return result;
}

struct TextFace::Glyphs {
    explicit Glyphs(const std::string& file) {
        if (FT_Init_FreeType(&library) != 0) throw IoError("FreeType does not start; swatches need it for their text");
        if (FT_New_Face(library, file.c_str(), 0, &face) != 0) {
            FT_Done_FreeType(library);
            throw IoError(file +
                          ": not a font that FreeType can read; install the Debian package fonts-dejavu-core "
                          "(DejaVuSans.ttf)");
        }
    }
    ~Glyphs() {
        FT_Done_Face(face);
        FT_Done_FreeType(library);
    }
    Glyphs(const Glyphs&) = delete;
    Glyphs& operator=(const Glyphs&) = delete;

    // Calls visit(pen) with each letter in turn as the face's current glyph; returns where the pen ends.
    template <typename Visit>
    double walk(std::string_view text, int size_px, const Visit& visit) const {
        FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size_px));
        double pen = 0.0;
        FT_UInt previous = 0;
        for (const char32_t letter : code_points(text)) {
            const FT_UInt glyph = FT_Get_Char_Index(face, letter);
            FT_Vector kerning{0, 0};
            if (previous != 0) FT_Get_Kerning(face, previous, glyph, FT_KERNING_UNFITTED, &kerning);
            pen += pixels(kerning.x);
            previous = glyph;
            // Light hinting: sharp feet and shoulders, true widths.
            if (FT_Load_Glyph(face, glyph, FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP) != 0) continue;
            visit(pen);
            pen += static_cast<double>(face->glyph->linearHoriAdvance) / 65536.0;
        }
        return pen;
    }

    FT_Library library = nullptr;
    FT_Face face = nullptr;
};

TextFace::TextFace(const std::string& file) : glyphs_(std::make_shared<Glyphs>(file)) {}

double TextFace::width_px(std::string_view text, int size_px) const {
    return glyphs_->walk(text, size_px, [](double) {});
}

TextPixels TextFace::draw(std::string_view text, int size_px) const {
    const int margin = size_px;  // accents and overhangs
    const int width = static_cast<int>(std::ceil(width_px(text, size_px))) + 2 * margin;
    TextPixels result{-margin, -2 * size_px, Image<float>(width, 3 * size_px)};
    glyphs_->walk(text, size_px, [&](double pen) {
        FT_GlyphSlot slot = glyphs_->face->glyph;
        if (slot->format != FT_GLYPH_FORMAT_OUTLINE) return;
        const double whole = std::floor(pen);
        FT_Outline_Translate(&slot->outline, std::lround(64.0 * (pen - whole)), 0);
        if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) return;
        const FT_Bitmap& bitmap = slot->bitmap;
        for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
            for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
                const int x = static_cast<int>(whole) + slot->bitmap_left + column - result.left;
                const int y = row - slot->bitmap_top - result.top;
                if (x < 0 || x >= width || y < 0 || y >= result.coverage.height()) continue;
                const float here = static_cast<float>(bitmap.buffer[row * bitmap.pitch + column]) / 255.0F;
                result.coverage.at(x, y) = std::max(result.coverage.at(x, y), here);
            }
        }
    });
    return result;
}

}  // namespace nacre
