#include "nacre/swatch/swatch_picks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "nacre/base/image.h"
#include "nacre/base/text.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/axis.h"
#include "nacre/lut/job.h"
#include "nacre/material/geometry.h"
#include "nacre/pick/picked_colour.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/swatch/lit_table.h"
#include "nacre/swatch/swatch_gamut.h"
#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_lit.h"
#include "nacre/swatch/swatch_panel.h"
#include "nacre/swatch/swatch_strip.h"

namespace nacre {
namespace {

constexpr int margin = 50;
constexpr int gap = 28;
constexpr int pairs_top = 118;  // below the title and the captions of the first row
constexpr int pair_height = 150;
constexpr int row_height = pair_height + 112;
constexpr int strip_height = 110;
constexpr int below_strip = 104;  // ticks, labels, title of the axis, margin
constexpr int widest_pair = 536;
constexpr std::size_t most_columns = 6;

double brightest_of(const Image<Xyz>& colours) {
    double brightest = 1.0;
    for (const Xyz& colour : colours) {
        const Rgb rgb = linear_rec709(colour);
        brightest = std::max({brightest, rgb.r, rgb.g, rgb.b});
    }
    return brightest;
}

void draw_patch(Swatch& swatch, int left, int top, int width, const Xyz& colour, const LutSpace& space) {
    swatch.panels.push_back({left, top, Image<Xyz>(width, pair_height, colour), true});
    draw_outside_patch(swatch, swatch.panels.back(), space);
}

double place_of(const Axis& axis, const PickedColour& picked) {
    const bool is_u = axis.is_angle() && axis.kind->quantity == Quantity::grating_u;
    return axis_coordinate(axis, is_u ? std::sin(picked.angle_deg * std::numbers::pi / 180.0) : picked.angle_deg);
}

std::string reached_text(const PickedColour& picked) {
    return picked.lobe && picked.is_met() ? "exact" : "dE00 " + significant_text(picked.de00, 2);
}

void draw_pair(Swatch& swatch, const PickedColour& picked, int left, int top, int width, const LutSpace& space) {
    const int half = width / 2;
    draw_patch(swatch, left, top, half, picked.colour, space);
    draw_patch(swatch, left + half, top, width - half, picked.reached, space);
    const double middle = left + half;
    const auto write = [&](const std::string& text, double x, double y, Align align, double grey, double room) {
        swatch.overlays.push_back(Text{text, {x, y}, note_px, align, grey, room});
    };
    const std::string angle = rounded_text(picked.angle_deg) + "°";
    write(angle, left + width, top - 12.0, Align::right, text_grey, 0.25 * width);
    write(picked.text, left, top - 12.0, Align::left, text_grey, 0.7 * width);
    write("picked", left, top + pair_height + 26.0, Align::left, dim_grey, 0.5 * width);
    write("reached", left + width, top + pair_height + 26.0, Align::right, dim_grey, 0.5 * width);
    write(reached_text(picked), middle, top + pair_height + 54.0, Align::centre, text_grey, width);
}

// The colours over the angle, shown by the rule of the patches.
void draw_picks_strip(Swatch& swatch, const PlannedSwatch& planned, const PlotArea& strip, const LutSpace& space) {
    const Job job = shown_job(planned);
    const AxisKind& texels = *planned.jobs.front().x.kind;
    swatch.panels.push_back(bake_panel(job, strip));
    swatch.panels.back().is_exact = true;
    if (&texels != job.x.kind) {
        draw_texel_scale(swatch, strip, *job.x.kind, texels);
        swatch.height += texel_scale_height;
    }
    Image<Xyz>& colours = swatch.panels.back().image;
    draw_outside(swatch, strip, colours, true, space);
    const double brightest = brightest_of(colours);
    for (Xyz& colour : colours) colour = (1.0 / brightest) * colour;
    draw_frame(swatch, strip);
    draw_x_axis(swatch, strip, job.x, axis_title(job.x));
    for (const PickedColour& picked : planned.picked)
        draw_pick(swatch, {strip.at(place_of(job.x, picked), 0.0).x, strip.top - 14.0}, 13.0);
    constexpr double visible = 1.005;
    if (brightest <= visible) return;
    const std::string note = "strip: " + exposure_text(-std::log2(brightest));
    swatch.overlays.push_back(Text{note, {strip.box().right, swatch.height - 18.0}, note_px, Align::right, dim_grey});
}

}  // namespace

Swatch draw_picks(const PlannedSwatch& planned, const LutSpace& space) {
    const auto& picks = planned.picked;
    const std::size_t shown = std::min(picks.size(), most_pairs);
    const std::size_t columns = std::clamp<std::size_t>(shown, 1, most_columns);
    const int rows = static_cast<int>((shown + columns - 1) / columns);
    const int room = picture_width - 2 * margin;
    const int width = std::min((room - static_cast<int>(columns - 1) * gap) / static_cast<int>(columns), widest_pair);
    const PlotArea strip{margin, pairs_top + rows * row_height, room, strip_height};
    Swatch swatch;
    swatch.width = picture_width;
    swatch.height = strip.top + strip.height + below_strip;
    for (std::size_t i = 0; i < shown; ++i) {
        const int column = static_cast<int>(i % columns);
        const int row = static_cast<int>(i / columns);
        draw_pair(swatch, picks[i], margin + column * (width + gap), pairs_top + row * row_height, width, space);
    }
    draw_title(swatch, planned.title, planned.jobs.front(), margin, margin + room);
    draw_picks_strip(swatch, planned, strip, space);
    if (shown < picks.size()) {
        const std::string note =
            "the first " + std::to_string(shown) + " of " + std::to_string(picks.size()) + " picks";
        const double baseline = pairs_top + rows * row_height - row_height + pair_height + 82.0;
        swatch.overlays.push_back(Text{note, {static_cast<double>(margin), baseline}, note_px, Align::left, dim_grey});
    }
    return swatch;
}

}  // namespace nacre
