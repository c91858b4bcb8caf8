#pragma once

#include <string>
#include <vector>

#include "nacre/lut/axis.h"
#include "nacre/lut/job.h"
#include "nacre/scene/plan.h"
#include "nacre/swatch/swatch_picture.h"

namespace nacre {

/// One typography for all swatches.
inline constexpr int title_px = 30;
inline constexpr int label_px = 22;
inline constexpr int note_px = 20;
inline constexpr double text_grey = 0.88;
inline constexpr double dim_grey = 0.62;
inline constexpr double line_grey = 0.42;
inline constexpr int picture_width = 1200;

/// The pixels of a picture on which a job is shown. The smallest y is at the bottom, as in any diagram.
struct PlotArea {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;

    /// Where the value at coordinates in [0, 1] is: the middle of a pixel at either end, as texels are.
    Point at(double x, double y) const;
    Box box() const;
};

/// The inverse of an axis: the coordinate of an angle in degrees or of a parameter's value. In [0, 1] within the axis.
double axis_coordinate(const Axis& axis, double value);

/// "peak wavelength of every pick (nm)", "angle"
std::string axis_title(const Axis& axis);

/// A mark on an axis.
struct Tick {
    double coordinate = 0.0;
    std::string label;  ///< empty where there is no room for one
};

/// Round values: 10° apart for angles, else 1, 2 or 5 times a power of ten apart. Labels never overlap: those at the
/// ends go first.
/// @param length_px       of the axis
/// @param is_horizontal   labels stand side by side, not above each other
std::vector<Tick> axis_ticks(const Axis& axis, int length_px, bool is_horizontal);

/// The tenths of a texture's coordinate, on an axis that shows the angle in another form.
/// @param shown   what the picture is even in
/// @param texels  what the texture is even in
std::vector<Tick> texel_ticks(const AxisKind& shown, const AxisKind& texels, int length_px);

/// "460", "78.3": at most `digits` behind the point.
std::string rounded_text(double value, int digits = 1);

/// The frame, the ticks with their labels and the title of the x axis.
void draw_x_axis(Swatch& swatch, const PlotArea& area, const Axis& axis, const std::string& title);
/// A second scale below that axis: where the texels of the LUT are. The picture is higher by `texel_scale_height`.
void draw_texel_scale(Swatch& swatch, const PlotArea& area, const AxisKind& shown, const AxisKind& texels);
inline constexpr int texel_scale_height = 90;
/// The same for y; its title stands above the axis, so that it can be read horizontally.
void draw_y_axis(Swatch& swatch, const PlotArea& area, const Axis& axis, const std::string& title);
void draw_frame(Swatch& swatch, const PlotArea& area);

/// The mark of a pick, a square: white, outlined dark.
void draw_pick(Swatch& swatch, Point centre, double side_px = 20.0);

/// The title, and at its right, dimmed, the light.
void draw_title(Swatch& swatch, const std::string& title, const Job& job, int left, int right);

}  // namespace nacre
