#include "nacre/swatch/swatch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/job.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/incidence.h"
#include "nacre/optics/lobe.h"
#include "nacre/optics/palette.h"
#include "nacre/swatch/swatch_gamut.h"
#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_picks.h"
#include "nacre/swatch/swatch_sheet.h"
#include "nacre/swatch/swatch_sphere.h"

namespace nacre {
namespace {

constexpr PlotArea plane_area{104, 128, 1046, 560};
constexpr PlotArea strip_area{50, 148, 1100, 170};
constexpr PlotArea lut_area{104, 128, 1046, 520};
constexpr int below_plot = 104;  // ticks, labels, title of the axis, margin
constexpr int sphere_side = 900;

Swatch blank(int width, int height) {
    Swatch swatch;
    swatch.width = width;
    swatch.height = height;
    return swatch;
}

// Where the palette asks for what no surface can do, from one angle to the end of the axis.
struct ClampedRange {
    double from_deg = 0.0;
    double to_deg = 0.0;
    std::string caption;
};

std::vector<ClampedRange> clamped_ranges(const Material& material) {
    std::vector<ClampedRange> ranges;
    const auto* palette = std::get_if<Palette>(&material.mechanism);
    if (palette == nullptr) return ranges;
    const auto add = [&](double bound_deg, double end_deg) {
        const Lobe lobe = palette_lobe_unclamped(*palette, Incidence::from_degrees(bound_deg));
        const std::string what = lobe.height > 1.0                  ? "height reaches 1"
                                 : lobe.height < 0.0                ? "height reaches 0"
                                 : lobe.width_nm < 0.0              ? "width reaches 0"
                                 : lobe.floor > 1.0                 ? "floor reaches 1"
                                 : lobe.floor < 0.0                 ? "floor reaches 0"
                                 : lobe.flatness > largest_flatness ? "flatness reaches 1"
                                                                    : "flatness reaches 0";
        ranges.push_back({bound_deg, end_deg, what + " at " + rounded_text(bound_deg) + "°"});
    };
    const ClampBounds bounds = palette_clamp_bounds(*palette);
    if (bounds.below_deg) add(*bounds.below_deg, 0.0);
    if (bounds.above_deg) add(*bounds.above_deg, 90.0);
    return ranges;
}

std::string pick_caption(const Pick& pick) {
    return rounded_text(pick.lobe.peak_nm) + " nm at " + rounded_text(pick.angle_deg) + "°";
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

// ---- strip

// A bar from the bound to the end of the axis, its caption above that end.
void draw_strip_clamps(Swatch& swatch, const Job& job, const PlotArea& area) {
    const double y = area.top - 30.0;
    for (const ClampedRange& range : clamped_ranges(job.material)) {
        const double bound = std::floor(area.at(axis_coordinate(job.x, range.from_deg), 0.0).x);
        const bool ends_left = axis_coordinate(job.x, range.to_deg) < 0.5;
        const double end = ends_left ? area.left : area.box().right;
        swatch.overlays.push_back(
            Rectangle{{std::min(bound, end), y, std::max(bound + 1.0, end), y + 1.0}, {}, {dim_grey}});
        swatch.overlays.push_back(Rectangle{{bound, y, bound + 1.0, area.top - 1.0}, {}, {dim_grey}});
        swatch.overlays.push_back(
            Text{range.caption, {end, y - 10.0}, note_px, ends_left ? Align::left : Align::right, dim_grey});
    }
}

void draw_strip_picks(Swatch& swatch, const Job& job, const PlotArea& area) {
    const auto* palette = std::get_if<Palette>(&job.material.mechanism);
    if (palette == nullptr) return;
    for (const Pick& pick : palette->picks) {
        draw_pick(swatch, {area.at(axis_coordinate(job.x, pick.angle_deg), 0.0).x, area.top - 14.0}, 13.0);
    }
}

std::string fixed_text(const Job& job) {
    switch (quantity_of(job.material.mechanism)) {
        case Quantity::grating_u:
            return "u = " + rounded_text(job.fixed.grating_u, 2);
        case Quantity::cos_scatter:
            return "cos(scatter) = " + rounded_text(job.fixed.cos_scatter, 2);
        case Quantity::incidence:
            break;
    }
    return rounded_text(job.fixed.incidence.theta_deg) + "°";
}

// Of a grating it is power per unit of u, of scattering what goes one way: either may be brighter than white.
void expose(Swatch& swatch, const PlotArea& area) {
    Image<Xyz>& image = swatch.panels.back().image;
    double brightest = 0.0;
    for (const Xyz& colour : image) {
        const Rgb rgb = linear_rec709(colour);
        brightest = std::max({brightest, rgb.r, rgb.g, rgb.b});
    }
    if (brightest <= 1.0) return;
    for (Xyz& colour : image) colour = {colour.x / brightest, colour.y / brightest, colour.z / brightest};
    swatch.overlays.push_back(Text{"exposure x " + rounded_text(1.0 / brightest, 2),
                                   {area.box().right, area.top - 22.0},
                                   note_px,
                                   Align::right,
                                   dim_grey});
}

Swatch draw_strip(const PlannedSwatch& planned, const LutSpace& space) {
    const Job& job = planned.jobs.front();
    const PlotArea area = job.y ? lut_area : strip_area;
    Swatch swatch = blank(picture_width, area.top + area.height + below_plot);
    swatch.panels.push_back(bake_panel(job, area));
    draw_outside(swatch, area, swatch.panels.back().image, !job.y, space);
    if (quantity_of(job.material.mechanism) != Quantity::incidence) expose(swatch, area);
    draw_title(swatch, planned.title, job, job.y ? area.left - 10 : area.left, area.left + area.width);
    draw_frame(swatch, area);
    draw_x_axis(swatch, area, job.x, axis_title(job.x));
    if (job.y) draw_y_axis(swatch, area, *job.y, axis_title(*job.y));
    if (!job.has_angle()) {
        const std::string note = "seen at " + fixed_text(job);
        swatch.overlays.push_back(Text{note, {area.box().right, area.top - 22.0}, label_px, Align::right, dim_grey});
    }
    // With a second axis the picks and the bounds may be elsewhere at each of its values.
    if (job.x.is_angle() && !job.y) {
        draw_strip_clamps(swatch, job, area);
        draw_strip_picks(swatch, job, area);
    }
    return swatch;
}

// ---- sphere

Swatch draw_sphere(const PlannedSwatch& planned) {
    const Job& job = planned.jobs.front();
    const SphereTable table = sphere_table(job);
    const double exposure = sphere_exposure(table);
    const Ball ball{0.5 * sphere_side, 0.5 * sphere_side + 12.0, 0.375 * sphere_side};
    Swatch swatch = blank(sphere_side, sphere_side);
    swatch.panels.push_back({0, 0, draw_ball(table, exposure, ball, sphere_side, sphere_side)});
    draw_title(swatch, planned.title, job, 46, sphere_side - 46);
    swatch.overlays.push_back(Text{"exposure x " + rounded_text(exposure, 2),
                                   {sphere_side - 46.0, sphere_side - 40.0},
                                   note_px,
                                   Align::right,
                                   dim_grey});
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
            return draw_sphere(swatch);
        case SwatchKind::picks:
            return draw_picks(swatch);
        case SwatchKind::contact_sheet:
            return draw_sheet(swatch, space);
    }
    return {};
}

}  // namespace nacre
