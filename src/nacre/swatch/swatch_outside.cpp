#include "nacre/swatch/swatch_outside.h"

#include <algorithm>
#include <cmath>

#include "nacre/lut/gamut.h"

namespace nacre {
namespace {

constexpr int caption_height = 30;
constexpr double sample_px = 34.0;  // of the mark, before the caption
constexpr int hatching_px = 16;     // from line to line, across

// 1 where a component is negative. Of a strip the first row.
Image<char> outside_of(const Image<Xyz>& colours, bool is_strip, const LutSpace& space) {
    Image<Xyz> seen(colours.width(), is_strip ? 1 : colours.height());
    for (int y = 0; y < seen.height(); ++y) {
        for (int x = 0; x < seen.width(); ++x) seen.at(x, y) = colours.at(x, y);
    }
    const Image<Rgb> rgb = space.to_rgb(seen);
    Image<char> outside(seen.width(), seen.height());
    std::transform(rgb.begin(), rgb.end(), outside.begin(), [](const Rgb& c) {
        return static_cast<char>(std::min({c.r, c.g, c.b}) < gamut_tolerance ? 1 : 0);
    });
    return outside;
}

// Calls what(first, end) for every run of true.
template <typename IsOutside, typename What>
void for_each_run(int begin, int end, const IsOutside& is_outside, const What& what) {
    for (int i = begin; i < end; ++i) {
        if (!is_outside(i)) continue;
        int last = i;
        while (last < end && is_outside(last)) ++last;
        what(i, last);
        i = last;
    }
}

void draw_bar(Swatch& swatch, double left, double right, double bottom) {
    const double top = bottom - outside_bar_px;
    swatch.overlays.push_back(Rectangle{{left, top - outside_air_px, right, bottom}, {}, {swatch.background}});
    swatch.overlays.push_back(Rectangle{{left, top, right, bottom}, {}, {dim_grey}});
}

// Dark below light, so that it is seen on any colour.
void draw_hatch(Swatch& swatch, Point from, Point to) {
    swatch.overlays.push_back(Polyline{{from, to}, 2.5, {0.0, 0.2}, {}});
    swatch.overlays.push_back(Polyline{{from, to}, 1.0, {1.0, 0.35}, {}});
}

void hatch(Swatch& swatch, const PlotArea& area, const Image<char>& outside) {
    const int width = outside.width(), height = outside.height();
    for (int sum = hatching_px; sum < width + height - 1; sum += hatching_px) {
        // From the lower left to the upper right: x + y = sum.
        const auto point = [&](double x) { return Point{area.left + x + 0.5, area.top + (sum - x) + 0.5}; };
        for_each_run(
            std::max(0, sum - height + 1), std::min(width, sum + 1), [&](int x) { return outside.at(x, sum - x) != 0; },
            [&](int first, int end) { draw_hatch(swatch, point(first), point(end - 1)); });
    }
}

std::string share_text(const Image<char>& outside) {
    const auto count = static_cast<double>(std::count(outside.begin(), outside.end(), 1));
    const double percent = 100.0 * count / static_cast<double>(outside.size());
    if (percent < 1.0) return "less than 1 %";
    // All of it only if it is.
    return rounded_text(percent < 100.0 ? std::min(percent, 99.0) : percent, 0) + " %";
}

void draw_caption(Swatch& swatch, const PlotArea& area, const std::string& caption, bool is_strip) {
    swatch.height += caption_height;
    const double baseline = swatch.height - 0.8 * caption_height;
    const double left = area.left, middle = std::floor(baseline - 0.36 * note_px);
    if (is_strip) {
        draw_bar(swatch, left, left + sample_px, middle + std::ceil(0.5 * outside_bar_px));
    } else {
        for (double x = left; x <= left + sample_px - 14.0; x += 10.0)
            draw_hatch(swatch, {x, middle + 7.0}, {x + 14.0, middle - 7.0});
    }
    swatch.overlays.push_back(Text{
        caption, {left + sample_px + 12.0, baseline}, note_px, Align::left, dim_grey, area.width - sample_px - 12.0});
}

}  // namespace

bool draw_outside_patch(Swatch& swatch, const Panel& panel, const LutSpace& space) {
    if (!space.to_rgb) return false;
    const Image<char> outside = outside_of(panel.image, false, space);
    if (std::find(outside.begin(), outside.end(), 1) == outside.end()) return false;
    hatch(swatch, {panel.left, panel.top, panel.image.width(), panel.image.height()}, outside);
    return true;
}

void draw_outside(Swatch& swatch, const PlotArea& area, const Image<Xyz>& colours, bool is_strip,
                  const LutSpace& space) {
    if (!space.to_rgb) return;
    const Image<char> outside = outside_of(colours, is_strip, space);
    if (std::find(outside.begin(), outside.end(), 1) == outside.end()) return;
    if (is_strip) {
        for_each_run(
            0, outside.width(), [&](int x) { return outside.at(x, 0) != 0; },
            [&](int first, int end) { draw_bar(swatch, area.left + first, area.left + end, area.box().bottom); });
    } else {
        hatch(swatch, area, outside);
    }
    draw_caption(
        swatch, area,
        "outside " + space.name + ": " + share_text(outside) + (is_strip ? " of the strip" : " of the picture"),
        is_strip);
}

}  // namespace nacre
