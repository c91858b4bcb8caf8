#include "nacre/swatch/swatch_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include "nacre/base/text.h"
#include "nacre/colour/light.h"
#include "nacre/colour/observer.h"
#include "nacre/lut/job.h"
#include "nacre/material/geometry.h"

namespace nacre {
namespace {

constexpr double tick_px = 9.0;
constexpr double title_baseline = 54.0;

// Digits of DejaVu Sans, the widest of the usual fonts, are 0.64 of its size wide; a label also wants some air.
constexpr double digit_width = 0.64;
constexpr double label_gap_px = 14.0;
constexpr double line_spacing = 1.35;

// Code points: the bytes of UTF-8 that do not continue one.
double label_width_px(std::string_view text) {
    const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
    return digit_width * label_px * static_cast<double>(letters);
}

// The largest of 1, 2, 5 times a power of ten that gives at least `wanted` steps.
double round_step(double span, double wanted) {
    const double raw = span / wanted;
    const double decade = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * decade <= raw * (1.0 + 1e-9)) return factor * decade;
    }
    return decade;
}

// Angles to the normal are shown in degrees, whatever the axis is even in.
bool is_in_degrees(const Axis& axis) {
    return axis.is_angle() && axis.kind->quantity == Quantity::incidence;
}

// Of an axis that is not: the smaller one first.
std::pair<double, double> ends_of(const Axis& axis) {
    if (!axis.is_angle()) return {std::min(axis.from, axis.to), std::max(axis.from, axis.to)};
    return {axis.kind->quantity == Quantity::grating_u ? 0.0 : axis.kind->low, axis.kind->high};
}

std::vector<double> tick_values(const Axis& axis, int length_px, bool is_horizontal) {
    std::vector<double> values;
    if (is_in_degrees(axis)) {
        for (int tens = 0; tens <= 9; ++tens) values.push_back(10.0 * tens);
        return values;
    }
    const auto [low, high] = ends_of(axis);
    const double step = round_step(high - low, std::max(2.0, length_px / (is_horizontal ? 180.0 : 110.0)));
    const double first = std::ceil(low / step - 1e-9);
    // Counted, because adding 1 to `first` may not change it: ranges may be narrower than their ends have digits for.
    const int steps = static_cast<int>(std::clamp(std::floor(high / step + 1e-9) - first, 0.0, 100.0));
    for (int i = 0; i <= steps; ++i) values.push_back((first + i) * step + 0.0);
    return values;
}

// Ends first, then the thirds of the quarter turn, then what is left; of a parameter, from the start.
int label_rank(const Axis& axis, double value) {
    if (!is_in_degrees(axis)) return 0;
    constexpr std::array<int, 10> ranks{0, 9, 8, 3, 4, 5, 2, 6, 7, 1};
    return ranks[static_cast<std::size_t>(std::lround(value / 10.0))];
}

std::string geometric_title(const AxisKind& kind) {
    switch (kind.quantity) {
        case Quantity::grating_u:
            return "u = |sin in + sin out|";
        case Quantity::cos_scatter:
            return "cos(scatter)";
        case Quantity::incidence:
            break;
    }
    return "angle";
}

}  // namespace

Point PlotArea::at(double x, double y) const {
    return {left + 0.5 + x * (width - 1), top + 0.5 + (1.0 - y) * (height - 1)};
}

Box PlotArea::box() const {
    return {static_cast<double>(left), static_cast<double>(top), static_cast<double>(left + width),
            static_cast<double>(top + height)};
}

double axis_coordinate(const Axis& axis, double value) {
    if (is_in_degrees(axis)) return axis.kind->coordinate(Incidence::from_degrees(value).cos_theta);
    if (axis.is_angle()) return axis.kind->coordinate(value);
    return (value - axis.from) / (axis.to - axis.from);
}

std::string axis_title(const Axis& axis) {
    if (axis.is_angle()) return geometric_title(*axis.kind);
    const std::string_view unit = axis.parameter.allowed.unit;
    if (unit.empty() || unit == "degrees") return axis.parameter.description;
    return axis.parameter.description + " (" + std::string(unit) + ")";
}

std::string rounded_text(double value, int digits) {
    const double scale = std::pow(10.0, digits);
    return number_text(std::round(value * scale) / scale + 0.0);
}

namespace {

// Labels as many ticks as have room, in the given order.
void give_labels(std::vector<Tick>& ticks, const std::vector<std::size_t>& order,
                 const std::vector<std::string>& labels, int length_px, bool is_horizontal) {
    for (const std::size_t i : order) {
        const bool has_room = std::none_of(ticks.begin(), ticks.end(), [&](const Tick& other) {
            const double distance_px = std::abs(other.coordinate - ticks[i].coordinate) * (length_px - 1);
            const double needed_px =
                is_horizontal ? 0.5 * (label_width_px(labels[i]) + label_width_px(other.label)) + label_gap_px
                              : line_spacing * label_px;
            return !other.label.empty() && distance_px < needed_px;
        });
        if (has_room) ticks[i].label = labels[i];
    }
}

}  // namespace

std::vector<Tick> axis_ticks(const Axis& axis, int length_px, bool is_horizontal) {
    const bool is_degrees = is_in_degrees(axis) || axis.parameter.allowed.unit == "degrees";
    const std::vector<double> values = tick_values(axis, length_px, is_horizontal);
    std::vector<Tick> ticks;
    std::vector<std::size_t> order;
    std::vector<std::string> labels;
    for (const double value : values) {
        order.push_back(ticks.size());
        ticks.push_back({axis_coordinate(axis, value), {}});
        labels.push_back(rounded_text(value, 9) + (is_degrees ? "°" : ""));
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return label_rank(axis, values[a]) < label_rank(axis, values[b]);
    });
    give_labels(ticks, order, labels, length_px, is_horizontal);
    return ticks;
}

std::vector<Tick> texel_ticks(const AxisKind& shown, const AxisKind& texels, int length_px) {
    constexpr int tenths = 10;
    std::vector<Tick> ticks;
    std::vector<std::size_t> order{0, tenths};  // the ends first
    std::vector<std::string> labels;
    for (int i = 0; i <= tenths; ++i) {
        const double coordinate = static_cast<double>(i) / tenths;
        ticks.push_back({shown.coordinate(texels.argument_at(coordinate)), {}});
        labels.push_back(rounded_text(coordinate));
        if (i > 0 && i < tenths) order.push_back(static_cast<std::size_t>(i));
    }
    give_labels(ticks, order, labels, length_px, true);
    return ticks;
}

void draw_frame(Swatch& swatch, const PlotArea& area) {
    const Box box = area.box();
    swatch.overlays.push_back(
        Rectangle{{box.left - 1.0, box.top - 1.0, box.right + 1.0, box.bottom + 1.0}, 1.0, {line_grey}});
}

namespace {

// Below a horizontal line.
void draw_x_scale(Swatch& swatch, const PlotArea& area, double line, const std::vector<Tick>& ticks,
                  const std::string& title) {
    for (const Tick& tick : ticks) {
        // Filled boxes on whole pixels, because they are the sharpest lines there are.
        const double x = std::floor(area.at(tick.coordinate, 0.0).x);
        const double length = tick.label.empty() ? 0.6 * tick_px : tick_px;
        swatch.overlays.push_back(Rectangle{{x, line + 1.0, x + 1.0, line + 1.0 + length}, {}, {dim_grey}});
        if (tick.label.empty()) continue;
        swatch.overlays.push_back(Text{tick.label, {x + 0.5, line + 34.0}, label_px, Align::centre, text_grey});
    }
    const Point middle{area.left + 0.5 * area.width, line + 72.0};
    swatch.overlays.push_back(Text{title, middle, label_px, Align::centre, dim_grey, 1.15 * area.width});
}

}  // namespace

void draw_x_axis(Swatch& swatch, const PlotArea& area, const Axis& axis, const std::string& title) {
    draw_x_scale(swatch, area, area.box().bottom, axis_ticks(axis, area.width, true), title);
}

void draw_texel_scale(Swatch& swatch, const PlotArea& area, const AxisKind& shown, const AxisKind& texels) {
    const double line = area.box().bottom + texel_scale_height;
    swatch.overlays.push_back(Rectangle{{area.box().left, line, area.box().right, line + 1.0}, {}, {line_grey}});
    draw_x_scale(swatch, area, line, texel_ticks(shown, texels, area.width),
                 "texture coordinate (" + std::string(texels.name) + ")");
}

void draw_y_axis(Swatch& swatch, const PlotArea& area, const Axis& axis, const std::string& title) {
    const double left = area.left;
    for (const Tick& tick : axis_ticks(axis, area.height, false)) {
        const double y = std::floor(area.at(0.0, tick.coordinate).y);
        const double length = tick.label.empty() ? 0.6 * tick_px : tick_px;
        swatch.overlays.push_back(Rectangle{{left - 1.0 - length, y, left - 1.0, y + 1.0}, {}, {dim_grey}});
        if (tick.label.empty()) continue;
        // 0.36 of the size is half the height of a digit.
        const Point end{left - tick_px - 9.0, y + 0.5 + 0.36 * label_px};
        swatch.overlays.push_back(Text{tick.label, end, label_px, Align::right, text_grey});
    }
    const Point start{left - tick_px - 1.0, area.top - 22.0};
    swatch.overlays.push_back(Text{title, start, label_px, Align::left, dim_grey, 0.6 * area.width});
}

void draw_pick(Swatch& swatch, Point centre, double side_px) {
    const auto square = [&](double half, double line, Ink ink) {
        swatch.overlays.push_back(
            Rectangle{{centre.x - half, centre.y - half, centre.x + half, centre.y + half}, line, ink});
    };
    const double half = 0.5 * side_px;
    square(half + 1.5, 5.5, {0.0, 0.65});
    square(half, 2.5, {1.0});
}

void draw_title(Swatch& swatch, const std::string& title, const Job& job, int left, int right) {
    const double width = right - left;
    swatch.overlays.push_back(
        Text{title, {static_cast<double>(left), title_baseline}, title_px, Align::left, text_grey, 0.6 * width});
    const LightSettings& light = job.light->settings;
    const std::string observer = light.observer == Observer::cie1931_2deg ? "CIE 1931 2°" : "CIE 1964 10°";
    swatch.overlays.push_back(Text{light.illuminant + ", " + observer,
                                   {static_cast<double>(right), title_baseline},
                                   note_px,
                                   Align::right,
                                   dim_grey,
                                   0.35 * width});
}

}  // namespace nacre
