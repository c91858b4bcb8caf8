#include "nacre/swatch/swatch_lit.h"

#include <cmath>
#include <string>
#include <utility>

#include "nacre/lut/axis.h"
#include "nacre/material/geometry.h"
#include "nacre/swatch/lit_picture.h"
#include "nacre/swatch/lit_table.h"
#include "nacre/swatch/swatch_disc.h"
#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_puddle.h"
#include "nacre/swatch/swatch_sphere.h"

namespace nacre {
namespace {

constexpr int lit_side = 900;
constexpr int lit_margin = 46;
constexpr double wet_brightest = 0.55;  // water on the ground is no paper

struct Scenery {
    Camera camera;
    Seen (*look)(const LitTable&, const Ray&);
    double brightness;  // of the brightest component
    const char* first;  // where the first value of a second axis is
    const char* last;
};

Scenery scenery_of(SwatchKind kind) {
    switch (kind) {
        case SwatchKind::bubble:
            return {ball_camera(), look_at_bubble, lit_brightest, "at the top", "at the bottom"};
        case SwatchKind::disc:
            return {disc_camera(), look_at_disc, lit_brightest, "inside", "at the edge"};
        case SwatchKind::puddle:
            return {puddle_camera(), look_at_puddle, wet_brightest, "at the edge", "in the middle"};
        default:
            return {ball_camera(), look_at_ball, lit_brightest, "at the top", "at the bottom"};
    }
}

double automatic_ev(const LitTable& table, const LitPicture& picture, double brightness) {
    const double level = brightness * (table.quantity == Quantity::grating_u ? 2.5 : 1.0);
    return picture.brightest > 0.0 ? std::log2(level / picture.brightest) : 0.0;
}

// "thickness: 20 nm at the top, 1200 nm at the bottom"
std::string second_axis_text(const Axis& axis, const Scenery& scenery) {
    const std::string unit =
        axis.parameter.allowed.unit == "degrees" ? "°" : " " + std::string(axis.parameter.allowed.unit);
    const auto end = [&](double value, const char* where) { return rounded_text(value, 4) + unit + " " + where; };
    return axis.parameter.description + ": " + end(axis.from, scenery.first) + ", " + end(axis.to, scenery.last);
}

void draw_note(Swatch& swatch, const std::string& text, Align align) {
    if (text.empty()) return;
    const double x = align == Align::left ? lit_margin : lit_side - lit_margin;
    swatch.overlays.push_back(
        Text{text, {x, lit_side - 36.0}, note_px, align, text_grey, 0.7 * (lit_side - 2 * lit_margin), true});
}

}  // namespace

std::string exposure_text(double exposure_ev) {
    const std::string rounded = rounded_text(exposure_ev, 2);
    if (rounded == "0") return {};
    return "exposure " + std::string(exposure_ev > 0.0 ? "+" : "") + rounded + " EV";
}

LitImage lit_image(const PlannedSwatch& planned, int side) {
    const LitTable table = lit_table(planned.jobs.front());
    const Scenery scenery = scenery_of(planned.kind);
    const LitPicture picture = take_picture(
        scenery.camera, [&](const Ray& ray) { return scenery.look(table, ray); }, side);
    const double exposure_ev = planned.exposure_ev.value_or(automatic_ev(table, picture, scenery.brightness));
    return {exposed(picture, std::exp2(exposure_ev)), exposure_ev,
            table.second ? second_axis_text(*table.second, scenery) : ""};
}

Swatch draw_lit(const PlannedSwatch& planned) {
    LitImage lit = lit_image(planned, lit_side);
    Swatch swatch;
    swatch.width = swatch.height = lit_side;
    swatch.panels.push_back({0, 0, std::move(lit.image)});
    draw_title(swatch, planned.title, planned.jobs.front(), lit_margin, lit_side - lit_margin);
    draw_note(swatch, lit.second_axis, Align::left);
    draw_note(swatch, exposure_text(lit.exposure_ev), Align::right);
    return swatch;
}

}  // namespace nacre
