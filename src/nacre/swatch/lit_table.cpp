#include "nacre/swatch/lit_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "nacre/lut/axis.h"
#include "nacre/material/effects.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/base.h"

namespace nacre {
namespace {

// Texels; chosen so that linear interpolation errs by less than a picture of 8 bits shows.
constexpr PlotArea line_area{0, 0, 1024, 1};
constexpr PlotArea plane_area_of_two{0, 0, 384, 192};

bool scatters_below(const Job& job) {
    const std::optional<Base>& base = job.material.mechanism.effects.base;
    return base && !std::holds_alternative<MetalBase>(*base) && !job.without.has(Effect::base);
}

bool is_of_material(const Axis& axis) {
    return !axis.is_angle() && axis.parameter.name != "azimuth_deg";
}

// Of rough facets half are steeper than alpha, of tilted ones half are steeper than 1.18 standard deviations.
double slope_of(const Relief& relief) {
    constexpr double deviations_of_a_half = 1.18;
    if (relief.roughness > 0.0) return relief.roughness * relief.roughness / deviations_of_a_half;
    return relief.tilt_deg * std::numbers::pi / 180.0;
}

struct Between {
    int low;       // the next texel is low + 1
    double share;  // of the next
};
Between between_texels(double position, int size) {
    const double texel = std::clamp(position, 0.0, 1.0) * (size - 1);
    const int low = std::clamp(static_cast<int>(texel), 0, std::max(size - 2, 0));
    return {low, texel - low};
}

}  // namespace

LitTable lit_table(const Job& job, double most_effort) {
    LitTable table;
    table.quantity = quantity_of(job.material.mechanism);
    if (job.y && is_of_material(*job.y)) table.second = job.y;
    if (!table.second && is_of_material(job.x)) table.second = job.x;
    Job fine = job;
    fine.x = default_axis(table.quantity);
    fine.y = table.second;
    const PlotArea& area = fine.y ? plane_area_of_two : line_area;
    table.first_slope = slope_of(mechanism_at(fine, 0.0, 0.0).effects.relief);
    table.last_slope = slope_of(mechanism_at(fine, 0.0, 1.0).effects.relief);
    if (is_transmittance(job.material.mechanism)) {
        table.through = bake_panel(fine, area, most_effort).image;
        fine.material.mechanism.effects.observed = Observed::reflectance;
    }
    table.mirrored = bake_panel(fine, area, most_effort).image;
    if (!scatters_below(job)) return table;
    table.scattered = std::move(table.mirrored);
    fine.without.insert(Effect::base);
    table.mirrored = bake_panel(fine, area, most_effort).image;
    std::transform(table.scattered.begin(), table.scattered.end(), table.mirrored.begin(), table.scattered.begin(),
                   [](const Xyz& all, const Xyz& mirrored) { return all + -1.0 * mirrored; });
    return table;
}

Xyz colour_at(const Image<Xyz>& colours, double coordinate, double along) {
    const Between x = between_texels(coordinate, colours.width());
    const auto across = [&](int row) {
        return (1.0 - x.share) * colours.at(x.low, row) + x.share * colours.at(x.low + 1, row);
    };
    if (colours.height() == 1) return across(0);
    const Between y = between_texels(1.0 - along, colours.height());
    return (1.0 - y.share) * across(y.low) + y.share * across(y.low + 1);
}

Xyz mirrored_at(const LitTable& table, double cos_theta, double along) {
    return colour_at(table.mirrored, std::sqrt(std::clamp(cos_theta, 0.0, 1.0)), along);
}

double blur_rad(const LitTable& table, double along) {
    if (table.first_slope == 0.0 && table.last_slope == 0.0) return 0.0;
    return 2.0 * std::lerp(table.first_slope, table.last_slope, along);
}

}  // namespace nacre
