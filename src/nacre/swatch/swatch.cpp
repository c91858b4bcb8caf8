#include "nacre/swatch/swatch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "nacre/lut/job.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/lobe.h"
#include "nacre/optics/palette.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/swatch_clamps.h"
#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_lit.h"
#include "nacre/swatch/swatch_panel.h"
#include "nacre/swatch/swatch_picks.h"
#include "nacre/swatch/swatch_preview.h"
#include "nacre/swatch/swatch_sheet.h"
#include "nacre/swatch/swatch_strip.h"

namespace nacre {
namespace {

constexpr PlotArea plane_area{104, 128, 1046, 560};
constexpr int below_plot = 104;  // ticks, labels, title of the axis, margin

Swatch blank(int width, int height) {
    Swatch swatch;
    swatch.width = width;
    swatch.height = height;
    return swatch;
}

std::string pick_caption(const Pick& pick) {
    const Lobe& band = pick.lobe;
    std::string text = rounded_text(band.peak_nm) + " nm at " + rounded_text(pick.angle_deg) + "°";
    if (band.floor != 0.0) text += ", floor " + rounded_text(band.floor, 2);
    if (band.flatness != 0.0) text += ", flatness " + rounded_text(band.flatness, 2);
    return text;
}

// ---- plane

// The peak's path, through every pick exactly.
std::vector<Point> peak_curve(const Palette& palette, const Job& job, const PlotArea& area) {
    std::vector<double> angles_deg;
    for (int half_degrees = 0; half_degrees <= 180; ++half_degrees) angles_deg.push_back(0.5 * half_degrees);
    for (const Pick& pick : palette.picks) angles_deg.push_back(pick.angle_deg);
    std::sort(angles_deg.begin(), angles_deg.end());
    const PaletteCurve curve(palette);
    std::vector<Point> points;
    for (const double angle_deg : angles_deg) {
        const double peak_nm = curve.at(Incidence::from_degrees(angle_deg)).peak_nm;
        points.push_back(area.at(axis_coordinate(job.x, peak_nm), axis_coordinate(*job.y, angle_deg)));
    }
    return points;
}

void draw_plane_clamps(Swatch& swatch, const Palette& palette, const Job& job, const PlotArea& area) {
    constexpr double dash_px = 10.0;
    for (const ClampedRange& range : clamped_ranges(job.material)) {
        const double y = std::floor(area.at(0.0, axis_coordinate(*job.y, range.from_deg)).y);
        for (double x = area.left; x < area.left + area.width; x += 2.0 * dash_px) {
            swatch.overlays.push_back(
                Rectangle{{x, y, std::min(x + dash_px, area.box().right), y + 1.0}, {}, {1.0, 0.45}});
        }
        // On the side on which the curve is not, in the clamped part if that is high enough.
        const double peak_nm = palette_lobe(palette, Incidence::from_degrees(range.from_deg)).peak_nm;
        const bool at_right = axis_coordinate(job.x, peak_nm) < 0.5;
        const bool is_upper = range.to_deg > range.from_deg;
        const double room = is_upper ? y - area.top : area.box().bottom - y;
        const bool above = is_upper == (room > 40.0);
        const Point end{at_right ? area.box().right - 14.0 : area.left + 14.0, above ? y - 10.0 : y + 25.0};
        swatch.overlays.push_back(
            Text{range.caption, end, note_px, at_right ? Align::right : Align::left, text_grey, 0.0, true});
    }
}

void draw_plane_picks(Swatch& swatch, const Palette& palette, const Job& job, const PlotArea& area) {
    constexpr std::size_t most_captions = 4;
    for (const Pick& pick : palette.picks) {
        const double x = axis_coordinate(job.x, pick.lobe.peak_nm);
        if (x < 0.0 || x > 1.0) continue;
        const Point centre = area.at(x, axis_coordinate(*job.y, pick.angle_deg));
        draw_pick(swatch, centre);
        if (palette.picks.size() > most_captions) continue;
        const bool at_right = x < 0.7;
        const double baseline = std::clamp(centre.y + 7.0, area.top + 28.0, area.box().bottom - 12.0);
        swatch.overlays.push_back(Text{pick_caption(pick),
                                       {centre.x + (at_right ? 22.0 : -22.0), baseline},
                                       note_px,
                                       at_right ? Align::left : Align::right,
                                       1.0,
                                       0.0,
                                       true});
    }
}

Swatch draw_plane(const PlannedSwatch& planned) {
    const PlotArea area = plane_area;
    const Job& job = planned.jobs.front();
    Swatch swatch = blank(picture_width, area.top + area.height + below_plot);
    swatch.panels.push_back(bake_panel(job, area));
    draw_title(swatch, planned.title, job, area.left - 10, area.left + area.width);
    draw_frame(swatch, area);
    draw_x_axis(swatch, area, job.x, "peak wavelength (nm)");
    draw_y_axis(swatch, area, *job.y, "angle");
    const auto* palette = std::get_if<Palette>(&job.material.mechanism);
    if (palette == nullptr) return swatch;
    draw_plane_clamps(swatch, *palette, job, area);
    const std::vector<Point> curve = peak_curve(*palette, job, area);
    swatch.overlays.push_back(Polyline{curve, 6.0, {0.0, 0.35}, area.box()});
    swatch.overlays.push_back(Polyline{curve, 2.5, {1.0, 0.9}, area.box()});
    draw_plane_picks(swatch, *palette, job, area);
    return swatch;
}

// ---- palette

// As many columns as leave the panels large enough to read.
int palette_columns(std::size_t panels) {
    if (panels <= 1) return 1;
    return panels <= 4 ? 2 : 3;
}

Swatch draw_palette(const PlannedSwatch& planned) {
    constexpr int margin = 104, gap = 96, above_panel = 76, top = 70;
    const std::size_t shown = std::min(planned.jobs.size(), most_palette_panels);
    const int columns = palette_columns(shown);
    const int rows = (static_cast<int>(shown) + columns - 1) / columns;
    const int side = columns == 1 ? 640 : (picture_width - margin - 50 - (columns - 1) * gap) / columns;
    const int width = margin + columns * side + (columns - 1) * gap + 50;
    Swatch swatch = blank(width, top + rows * (above_panel + side + below_plot - 10) + 10);
    draw_title(swatch, planned.title, planned.jobs.front(), margin - 10, width - 50);
    for (std::size_t i = 0; i < shown; ++i) {
        const int column = static_cast<int>(i) % columns;
        const int row = static_cast<int>(i) / columns;
        const PlotArea area{margin + column * (side + gap),
                            top + above_panel + row * (above_panel + side + below_plot - 10), side, side};
        const Job& job = planned.jobs[i];
        const Pick& pick = std::get<Palette>(job.material.mechanism).picks.front();
        swatch.panels.push_back(bake_panel(job, area));
        draw_frame(swatch, area);
        draw_x_axis(swatch, area, job.x, "width (nm)");
        draw_y_axis(swatch, area, *job.y, "height");
        swatch.overlays.push_back(Text{
            pick_caption(pick), {area.box().right, area.top - 22.0}, label_px, Align::right, text_grey, 0.6 * side});
        draw_pick(swatch,
                  area.at(axis_coordinate(job.x, pick.lobe.width_nm), axis_coordinate(*job.y, pick.lobe.height)));
    }
    if (shown < planned.jobs.size()) {
        const std::string note =
            "the first " + std::to_string(shown) + " of " + std::to_string(planned.jobs.size()) + " picks";
        swatch.overlays.push_back(Text{note, {width - 50.0, swatch.height - 18.0}, note_px, Align::right, dim_grey});
    }
    return swatch;
}

}  // namespace

Swatch draw_swatch(const PlannedSwatch& swatch, const LutSpace& space) {
    switch (swatch.kind) {
        case SwatchKind::plane:
            return draw_plane(swatch);
        case SwatchKind::palette:
            return draw_palette(swatch);
        case SwatchKind::strip:
            return draw_strip(swatch, space);
        case SwatchKind::sphere:
        case SwatchKind::bubble:
        case SwatchKind::disc:
        case SwatchKind::puddle:
            return draw_lit(swatch);
        case SwatchKind::picks:
            return draw_picks(swatch, space);
        case SwatchKind::contact_sheet:
            return draw_sheet(swatch, space);
        case SwatchKind::preview:
            return draw_preview(swatch, space);
    }
    return {};
}

}  // namespace nacre
