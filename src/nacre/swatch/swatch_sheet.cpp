#include "nacre/swatch/swatch_sheet.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "nacre/swatch/swatch.h"
#include "nacre/swatch/swatch_layout.h"

namespace nacre {
namespace {

constexpr int sheet_margin = 38;  // two strips of half their width fill the picture between the margins
constexpr int sheet_gap = 24;
constexpr int sheet_top = 92;
constexpr int below_picture = 58;  // the label, and air
constexpr int note_height = 34;

// By how much both sides of a picture are divided: two strips in a row, or four spheres.
int reduction(SwatchKind kind) {
    return kind == SwatchKind::strip ? 2 : 4;
}

// The mean of factor x factor pixels.
Image<Xyz> reduced(const Image<Xyz>& image, int factor) {
    Image<Xyz> small(image.width() / factor, image.height() / factor);
    const double share = 1.0 / (factor * factor);
    for (int y = 0; y < small.height() * factor; ++y) {
        for (int x = 0; x < small.width() * factor; ++x) {
            const Xyz& pixel = image.at(x, y);
            Xyz& sum = small.at(x / factor, y / factor);
            sum = {sum.x + share * pixel.x, sum.y + share * pixel.y, sum.z + share * pixel.z};
        }
    }
    return small;
}

Image<Xyz> small_picture(const PlannedSwatch& planned, const Job& job, const LutSpace& space) {
    PlannedSwatch one = planned;
    one.kind = planned.panels;
    one.jobs = {job};
    return reduced(draw_swatch(one, space).panels.front().image, reduction(planned.panels));
}

}  // namespace

Swatch draw_sheet(const PlannedSwatch& planned, const LutSpace& space) {
    const std::size_t shown = std::min(planned.jobs.size(), most_sheet_pictures);
    std::vector<Image<Xyz>> pictures;
    int width = 0, height = 0;
    for (std::size_t i = 0; i < shown; ++i) {
        pictures.push_back(small_picture(planned, planned.jobs[i], space));
        width = std::max(width, pictures.back().width());
        height = std::max(height, pictures.back().height());
    }
    const int columns = (picture_width - 2 * sheet_margin + sheet_gap) / (width + sheet_gap);
    const int rows = (static_cast<int>(shown) + columns - 1) / columns;
    const bool is_part = shown < planned.jobs.size();
    Swatch swatch;
    swatch.width = picture_width;
    swatch.height = sheet_top + rows * (height + below_picture) + (is_part ? note_height : 0);
    draw_title(swatch, planned.title, planned.jobs.front(), sheet_margin, picture_width - sheet_margin);
    for (std::size_t i = 0; i < shown; ++i) {
        const int left = sheet_margin + static_cast<int>(i) % columns * (width + sheet_gap);
        const int top = sheet_top + static_cast<int>(i) / columns * (height + below_picture);
        const double baseline = top + height + 28.0;
        swatch.overlays.push_back(Text{planned.labels[i],
                                       {static_cast<double>(left), baseline},
                                       label_px,
                                       Align::left,
                                       text_grey,
                                       static_cast<double>(width)});
        swatch.panels.push_back({left, top, std::move(pictures[i])});
    }
    if (is_part) {
        const std::string note =
            "the first " + std::to_string(shown) + " of " + std::to_string(planned.jobs.size()) + " LUTs";
        swatch.overlays.push_back(
            Text{note, {static_cast<double>(sheet_margin), swatch.height - 18.0}, note_px, Align::left, dim_grey});
    }
    return swatch;
}

}  // namespace nacre
