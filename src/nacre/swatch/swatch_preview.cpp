#include "nacre/swatch/swatch_preview.h"

#include <algorithm>
#include <string>
#include <utility>

#include "nacre/swatch/swatch_layout.h"
#include "nacre/swatch/swatch_lit.h"
#include "nacre/swatch/swatch_strip.h"

namespace nacre {
namespace {

constexpr int preview_margin = 50;
constexpr int object_top = 92;
constexpr int object_side = 360;
constexpr int below_object = 42;  // its second axis, or air
constexpr PlotArea strip_beside{460, 148, 690, 130};
constexpr PlotArea plane_beside{530, 128, 620, 300};

// In reflectances of a film, of the strip and of the object each: some tenths of a second, so that a preview takes less
// than the LUT of an expensive material does.
constexpr double most_preview_effort = 1e8;

void write_at_object(Swatch& swatch, const std::string& text, Point baseline, Align align, double grey) {
    if (text.empty()) return;
    const bool is_on_it = baseline.y < object_top + object_side;
    swatch.overlays.push_back(Text{text, baseline, note_px, align, grey, 0.92 * object_side, is_on_it});
}

void draw_object(Swatch& swatch, const PlannedSwatch& planned) {
    PlannedSwatch object = planned;
    object.kind = object_of(planned.jobs.front().material);
    LitImage lit = lit_image(object, object_side, most_preview_effort);
    swatch.panels.push_back({preview_margin, object_top, std::move(lit.image)});
    constexpr double left = preview_margin, right = left + object_side, bottom = object_top + object_side;
    write_at_object(swatch, exposure_text(lit.exposure_ev), {right - 14.0, bottom - 14.0}, Align::right, text_grey);
    write_at_object(swatch, lit.second_ends, {left, bottom + 28.0}, Align::left, dim_grey);
    swatch.height = std::max(swatch.height, object_top + object_side + below_object);
}

}  // namespace

Swatch draw_preview(const PlannedSwatch& planned, const LutSpace& space) {
    const Job& job = planned.jobs.front();
    Swatch swatch;
    swatch.width = picture_width;
    draw_strip_in(swatch, planned, job.y ? plane_beside : strip_beside, space, most_preview_effort);
    draw_title(swatch, planned.title, job, preview_margin, picture_width - preview_margin);
    draw_object(swatch, planned);
    return swatch;
}

}  // namespace nacre
