#pragma once

#include <string>

#include "io/image/text_face.h"
#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// Display-referred pixels on which shapes are drawn.
///
/// Every shape is drawn with the fraction of each pixel that it covers. render_line and render_box of OpenImageIO draw
/// whole pixels only, and its render_text draws no degree sign (see TextFace).
class Canvas {
public:
    /// @throws IoError if the font cannot be used
    Canvas(int width, int height, double background, const std::string& font);

    /// @pre the image lies within the canvas
    void paste(int left, int top, const Image<Rgb>& image);
    void draw(const Polyline& line);
    void draw(const Rectangle& rectangle);
    void draw(const Text& text);

    const Image<Rgb>& pixels() const { return pixels_; }

private:
    void blend(int x, int y, Ink ink, double coverage);

    Image<Rgb> pixels_;
    TextFace face_;
};

}  // namespace nacre
