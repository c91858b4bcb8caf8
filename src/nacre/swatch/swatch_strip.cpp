#include "nacre/swatch/swatch_strip.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/axis.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/palette.h"
#include "nacre/swatch/lit_table.h"
#include "nacre/swatch/swatch_clamps.h"
#include "nacre/swatch/swatch_gamut.h"
#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_lit.h"
#include "nacre/swatch/swatch_panel.h"

namespace nacre {
namespace {

constexpr PlotArea strip_area{50, 148, 1100, 170};
constexpr PlotArea lut_area{104, 128, 1046, 520};
constexpr int below_strip_plot = 104;  // ticks, labels, title of the axis, margin

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
double automatic_strip_ev(const Job& job, const Image<Xyz>& colours) {
    if (quantity_of(job.material.mechanism) == Quantity::incidence) return 0.0;
    double brightest = 1.0;
    for (const Xyz& colour : colours) {
        const Rgb rgb = linear_rec709(colour);
        brightest = std::max({brightest, rgb.r, rgb.g, rgb.b});
    }
    return -std::log2(brightest);
}

// Five squares high; on the light ones the colours are as they are.
void lay_over_checkerboard(Image<Xyz>& colours) {
    constexpr int rows = 5;
    constexpr double dark = 0.5;
    const int side = std::max(colours.height() / rows, 1);
    for (int y = 0; y < colours.height(); ++y) {
        for (int x = 0; x < colours.width(); ++x) {
            if ((x / side + y / side) % 2 == 1) colours.at(x, y) = dark * colours.at(x, y);
        }
    }
}

void draw_note_above(Swatch& swatch, const PlotArea& area, const std::string& note) {
    if (note.empty()) return;
    swatch.overlays.push_back(Text{note, {area.box().right, area.top - 22.0}, note_px, Align::right, dim_grey});
}

}  // namespace

Job shown_job(const PlannedSwatch& planned) {
    Job job = planned.jobs.front();
    const auto show = [&](Axis& axis) {
        if (axis.is_angle() && axis.kind->quantity == Quantity::incidence) axis.kind = planned.shown_axis;
    };
    show(job.x);
    if (job.y) show(*job.y);
    return job;
}

void draw_strip_in(Swatch& swatch, const PlannedSwatch& planned, const PlotArea& area, const LutSpace& space,
                   double most_effort) {
    const Job job = shown_job(planned);
    const AxisKind* texels = planned.jobs.front().x.kind;
    swatch.height = area.top + area.height + below_strip_plot;
    swatch.panels.push_back(bake_panel(job, area, most_effort));
    if (texels != job.x.kind) {
        draw_texel_scale(swatch, area, *job.x.kind, *texels);
        swatch.height += texel_scale_height;
    }
    Image<Xyz>& colours = swatch.panels.back().image;
    draw_outside(swatch, area, colours, !job.y, space);
    const double exposure_ev = planned.exposure_ev.value_or(automatic_strip_ev(job, colours));
    for (Xyz& colour : colours) colour = std::exp2(exposure_ev) * colour;
    if (is_transmittance(job.material.mechanism)) lay_over_checkerboard(colours);
    draw_frame(swatch, area);
    draw_x_axis(swatch, area, job.x, axis_title(job.x));
    if (job.y) draw_y_axis(swatch, area, *job.y, axis_title(*job.y));
    const std::string exposure = exposure_text(exposure_ev);
    const std::string seen = job.has_angle() ? "" : "seen at " + fixed_text(job);
    draw_note_above(swatch, area, seen + (seen.empty() || exposure.empty() ? "" : ", ") + exposure);
    // With a second axis the picks and the bounds may be elsewhere at each of its values.
    if (job.x.is_angle() && !job.y) {
        draw_strip_clamps(swatch, job, area);
        draw_strip_picks(swatch, job, area);
    }
}

Swatch draw_strip(const PlannedSwatch& planned, const LutSpace& space) {
    const Job& job = planned.jobs.front();
    const PlotArea area = job.y ? lut_area : strip_area;
    Swatch swatch;
    swatch.width = picture_width;
    draw_strip_in(swatch, planned, area, space);
    draw_title(swatch, planned.title, job, job.y ? area.left - 10 : area.left, area.left + area.width);
    return swatch;
}

}  // namespace nacre
