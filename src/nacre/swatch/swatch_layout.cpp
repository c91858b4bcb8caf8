#include "nacre/swatch/swatch_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <variant>

#include "nacre/accuracy/choose_sampling.h"
#include "nacre/base/image.h"
#include "nacre/base/text.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/colour/observer.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/job.h"
#include "nacre/lut/sampler.h"
#include "nacre/material/geometry.h"
#include "nacre/optics/palette.h"
#include "nacre/shade/spectral_sampling.h"

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
    return "angle (" + std::string(kind.name) + ")";
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

std::vector<Tick> axis_ticks(const Axis& axis, int length_px, bool is_horizontal) {
    const bool is_degrees = is_in_degrees(axis) || axis.parameter.allowed.unit == "degrees";
    const std::vector<double> values = tick_values(axis, length_px, is_horizontal);
    std::vector<Tick> ticks;
    std::vector<std::size_t> order;
    for (const double value : values) {
        order.push_back(ticks.size());
        ticks.push_back({axis_coordinate(axis, value), {}});
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return label_rank(axis, values[a]) < label_rank(axis, values[b]);
    });
    for (const std::size_t i : order) {
        const std::string label = rounded_text(values[i], 9) + (is_degrees ? "°" : "");
        const bool has_room = std::none_of(ticks.begin(), ticks.end(), [&](const Tick& other) {
            const double distance_px = std::abs(other.coordinate - ticks[i].coordinate) * (length_px - 1);
            const double needed_px = is_horizontal
                                         ? 0.5 * (label_width_px(label) + label_width_px(other.label)) + label_gap_px
                                         : line_spacing * label_px;
            return !other.label.empty() && distance_px < needed_px;
        });
        if (has_room) ticks[i].label = label;
    }
    return ticks;
}

namespace {

// The effort limit of a picture, in reflectances of a film: a few seconds. A more expensive one is baked smaller and
// enlarged.
constexpr double most_panel_effort = 3e9;

// By how much both sides are divided.
double panel_reduction(const Job& job) {
    if (std::holds_alternative<Palette>(job.material.mechanism)) return 1.0;
    Sampler sampler(job);
    sampler.at(0.5, 0.5);
    const double pixels = static_cast<double>(job.width) * job.height;
    const double effort = pixels * static_cast<double>(sampler.work().samples) *
                          effort_per_sample(mechanism_at(job, 0.5, 0.5), job.sampling.slices);
    return std::max(1.0, std::sqrt(effort / most_panel_effort));
}

Xyz mixed(double share, const Xyz& a, const Xyz& b) {
    return {std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share), std::lerp(a.z, b.z, share)};
}

// Linear between the pixels of a smaller picture, whose first and last are at the edges as the larger one's.
class Enlarged {
public:
    Enlarged(Image<Xyz> small, int width, int height) : small_(std::move(small)), width_(width), height_(height) {}

    Xyz at(int column, int row) const {
        if (small_.width() == width_ && small_.height() == height_) return small_.at(column, row);
        const auto [left, right, across] = place(column, width_, small_.width());
        const auto [below, above, along] = place(row, height_, small_.height());
        return mixed(along, mixed(across, small_.at(left, below), small_.at(right, below)),
                     mixed(across, small_.at(left, above), small_.at(right, above)));
    }

private:
    struct Place {
        int low, high;
        double share;
    };
    static Place place(int pixel, int many, int few) {
        if (many < 2 || few < 2) return {0, 0, 0.0};
        const double at = static_cast<double>(pixel) * (few - 1) / (many - 1);
        const int low = std::min(static_cast<int>(at), few - 2);
        return {low, low + 1, at - low};
    }

    Image<Xyz> small_;
    int width_;
    int height_;
};

}  // namespace

Panel bake_panel(const Job& job, const PlotArea& area) {
    Job sized = job;
    sized.width = area.width;
    sized.height = job.y ? area.height : 1;
    sized.sampling = choose_sampling(sized, {0.1, 1.0, 0.1, 0.0}).sampling;
    if (const double reduction = panel_reduction(sized); job.y && reduction > 1.0) {
        constexpr double smallest = 64.0;
        sized.width = static_cast<int>(std::max(area.width / reduction, smallest));
        sized.height = static_cast<int>(std::max(area.height / reduction, smallest));
    }
    const Enlarged baked(bake(sized), area.width, job.y ? area.height : 1);
    Panel panel{area.left, area.top, Image<Xyz>(area.width, area.height)};
    for (int row = 0; row < area.height; ++row) {
        const int from_row = job.y ? area.height - 1 - row : 0;
        for (int column = 0; column < area.width; ++column) panel.image.at(column, row) = baked.at(column, from_row);
    }
    return panel;
}

void draw_frame(Swatch& swatch, const PlotArea& area) {
    const Box box = area.box();
    swatch.overlays.push_back(
        Rectangle{{box.left - 1.0, box.top - 1.0, box.right + 1.0, box.bottom + 1.0}, 1.0, {line_grey}});
}

void draw_x_axis(Swatch& swatch, const PlotArea& area, const Axis& axis, const std::string& title) {
    const double bottom = area.box().bottom;
    for (const Tick& tick : axis_ticks(axis, area.width, true)) {
        // Filled boxes on whole pixels, because they are the sharpest lines there are.
        const double x = std::floor(area.at(tick.coordinate, 0.0).x);
        const double length = tick.label.empty() ? 0.6 * tick_px : tick_px;
        swatch.overlays.push_back(Rectangle{{x, bottom + 1.0, x + 1.0, bottom + 1.0 + length}, {}, {dim_grey}});
        if (tick.label.empty()) continue;
        swatch.overlays.push_back(Text{tick.label, {x + 0.5, bottom + 34.0}, label_px, Align::centre, text_grey});
    }
    const Point middle{area.left + 0.5 * area.width, bottom + 72.0};
    swatch.overlays.push_back(Text{title, middle, label_px, Align::centre, dim_grey, 1.15 * area.width});
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
