#include "nacre/swatch/swatch_lit.h"

#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "nacre/lut/axis.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/layered.h"
#include "nacre/optics/refractive_index.h"
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

double automatic_ev(const LitTable& table, const LitPicture& picture, const PlannedSwatch& planned, double brightness) {
    // What is only seen through is as bright as what is behind it; what is mirrored in front of that adds to it.
    if (table.through.size() > 0 && planned.kind == SwatchKind::sphere) return 0.0;
    if (table.through.size() > 0) brightness -= light_square;
    const double level = brightness * (table.quantity == Quantity::grating_u ? 2.5 : 1.0);
    return picture.brightest > 0.0 ? std::log2(level / picture.brightest) : 0.0;
}

// "20 nm at the top, 1200 nm at the bottom"
std::string ends_text(const Axis& axis, const Scenery& scenery) {
    std::string unit(axis.parameter.allowed.unit);
    if (!unit.empty()) unit = unit == "degrees" ? "°" : " " + unit;
    const auto end = [&](double value, const char* where) { return rounded_text(value, 4) + unit + " " + where; };
    return end(axis.from, scenery.first) + ", " + end(axis.to, scenery.last);
}

// Of water 1.333 to 1.339 over the visible range (Hale and Querry 1973); a scene may say 1.33, or mean sea water.
bool is_water(const Index& index) {
    constexpr double green_nm = 550.0;
    const RefractiveIndex n = index.at(green_nm);
    return std::abs(n.real() - 1.334) < 0.01 && n.imag() < 1e-3;
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

SwatchKind object_of(const Material& material) {
    if (quantity_of(material.mechanism) == Quantity::grating_u) return SwatchKind::disc;
    const auto* film = std::get_if<Film>(&material.mechanism);
    if (film == nullptr || is_transmittance(material.mechanism) || material.mechanism.effects.base)
        return SwatchKind::sphere;
    if (film->substrate == film->incident) return SwatchKind::bubble;
    return is_water(film->substrate) ? SwatchKind::puddle : SwatchKind::sphere;
}

LitImage lit_image(const PlannedSwatch& planned, int side, double most_effort) {
    const LitTable table = lit_table(planned.jobs.front(), most_effort);
    const Scenery scenery = scenery_of(planned.kind);
    LitPicture picture = take_picture(
        scenery.camera, [&](const Ray& ray) { return scenery.look(table, ray); }, side);
    const double exposure_ev = planned.exposure_ev.value_or(automatic_ev(table, picture, planned, scenery.brightness));
    LitImage lit{exposed(std::move(picture), std::exp2(exposure_ev)), exposure_ev, {}, {}};
    if (table.second) {
        lit.second_axis = table.second->parameter.description;
        lit.second_ends = ends_text(*table.second, scenery);
    }
    return lit;
}

Swatch draw_lit(const PlannedSwatch& planned) {
    LitImage lit = lit_image(planned, lit_side);
    Swatch swatch;
    swatch.width = swatch.height = lit_side;
    swatch.panels.push_back({0, 0, std::move(lit.image)});
    draw_title(swatch, planned.title, planned.jobs.front(), lit_margin, lit_side - lit_margin);
    for (Overlay& overlay : swatch.overlays) {
        if (auto* text = std::get_if<Text>(&overlay))
            text->halo = is_transmittance(planned.jobs.front().material.mechanism);
    }
    if (!lit.second_axis.empty()) draw_note(swatch, lit.second_axis + ": " + lit.second_ends, Align::left);
    draw_note(swatch, exposure_text(lit.exposure_ev), Align::right);
    return swatch;
}

}  // namespace nacre
