// What a swatch bakes: a swatch is a LUT with axes of its own, so that no second renderer can differ from the LUTs.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nacre/lut/axis.h"
#include "nacre/scene/planned_swatch.h"
#include "nacre/scene/readers/axis_reader.h"

namespace nacre {
namespace {

// Texels. Chosen for the pictures, in which one texel is about one pixel; nothing else depends on them.
constexpr int plane_width = 1046;
constexpr int plane_height = 560;
constexpr int palette_side = 475;
constexpr int strip_width = 1100;

// The peaks that a plane shows: the visible ones.
constexpr double shortest_peak_nm = 380.0;
constexpr double longest_peak_nm = 780.0;

Job plane_job(Job job) {
    job.x = parameter_axis(job.material.mechanism, "peak_nm", shortest_peak_nm, longest_peak_nm);
    job.y = Axis{&even_degrees(), {}, 0.0, 1.0};
    job.width = plane_width;
    job.height = plane_height;
    return job;
}

// The largest width that a palette shows: a quarter more than its widest pick, rounded up to 50 nm; at least 200 nm, so
// that palettes of narrow picks share one scale, and at most 1000 nm, the widest band that a scene may have.
double widest_shown_nm(const Palette& palette) {
    constexpr double round_nm = 50.0;
    double widest_nm = 200.0;
    for (const Pick& pick : palette.picks) widest_nm = std::max(widest_nm, 1.25 * pick.lobe.width_nm);
    return std::min(round_nm * std::ceil(widest_nm / round_nm), 1000.0);
}

std::vector<Job> palette_jobs(Job job) {
    const Palette palette = std::get<Palette>(job.material.mechanism);
    const double widest_nm = widest_shown_nm(palette);
    std::vector<Job> jobs;
    for (const Pick& pick : palette.picks) {
        // At its own angle a pick is alone, so that its panel costs the same whatever else was picked.
        job.material.mechanism = Palette{{pick}};
        job.x = parameter_axis(job.material.mechanism, "width_nm", 0.0, widest_nm);
        job.y = parameter_axis(job.material.mechanism, "height", 0.0, 1.0);
        job.fixed = Incidence::from_degrees(pick.angle_deg);
        job.width = job.height = palette_side;
        jobs.push_back(job);
    }
    return jobs;
}

}  // namespace

const AxisKind& even_degrees() {
    for (const AxisKind& kind : axis_kinds()) {
        if (kind.name == "theta_deg") return kind;
    }
    return default_axis_kind(Quantity::incidence);
}

std::vector<Job> swatch_jobs(SwatchKind kind, const Material& material, const std::shared_ptr<const Light>& light) {
    Job job;
    job.material = material;
    job.light = light;
    switch (kind) {
        case SwatchKind::plane:
            return {plane_job(std::move(job))};
        case SwatchKind::palette:
            return palette_jobs(std::move(job));
        case SwatchKind::strip:
        case SwatchKind::sphere:
        case SwatchKind::bubble:
        case SwatchKind::disc:
        case SwatchKind::puddle:
        case SwatchKind::picks:
        case SwatchKind::contact_sheet:
        case SwatchKind::preview:
            break;
    }
    job.x = default_axis(quantity_of(material.mechanism));
    job.width = strip_width;
    return {job};
}

}  // namespace nacre
