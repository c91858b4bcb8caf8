#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

/// A place on a picture, in pixels: pixel (i, j) covers [i, i + 1) x [j, j + 1), (0, 0) is the top left corner.
struct Point {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// Edges in the same coordinates.
struct Box {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;
};

/// A neutral tone as the display shows it (not light): 0 black, 1 white. Laid over what is below it.
struct Ink {
    double grey = 1.0;
    double opacity = 1.0;
};

/// Connected straight lines with round ends.
struct Polyline {
    std::vector<Point> points;
    double width_px = 2.0;
    Ink ink;
    std::optional<Box> clip;  ///< nothing is drawn outside
};

/// A filled rectangle, or its outline: `line_px` wide, inside the edges.
struct Rectangle {
    Box box;
    std::optional<double> line_px;
    Ink ink;
};

enum class Align { left, centre, right };

/// One line of text, UTF-8.
struct Text {
    std::string text;
    Point baseline;  ///< left end, middle or right end of the line on which the letters stand
    int size_px = 22;
    Align align = Align::left;
    double grey = 1.0;
    double max_width_px = 0.0;  ///< set smaller, then shortened, to fit; 0: no limit
    bool halo = false;          ///< a dark rim, for text over colours
};

using Overlay = std::variant<Polyline, Rectangle, Text>;

/// Colours of the scene; one value per pixel of the picture.
struct Panel {
    int left = 0;
    int top = 0;
    Image<Xyz> image;
    bool is_exact = false;  ///< shown as it is and clipped to the display, never compressed into its gamut
};

/// A picture without displays, fonts and files: shapes with their places in pixels.
struct Swatch {
    int width = 0;
    int height = 0;
    double background = 0.105;  ///< grey as the display shows it
    std::vector<Panel> panels;
    std::vector<Overlay> overlays;  ///< in the order in which they are drawn
};

}  // namespace nacre
