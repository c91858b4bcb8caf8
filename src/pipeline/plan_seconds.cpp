// How long a bake will take, without baking.
//
// In: a job with everything decided. A few texels, spread evenly, are computed twice: the first time with what is
// prepared for them (solvers, a base's factors, Mie's series), the second time without. From both, and how often a LUT
// prepares something, follows the time of all texels. Measuring takes as long as the colours that it asks the reference
// for: two of them are timed, in the same way.
#include "pipeline/plan_seconds.h"

#include <algorithm>
#include <array>
#include <vector>

#include "nacre/accuracy/measure.h"
#include "nacre/accuracy/reference.h"
#include "nacre/lut/axis_kinds.h"
#include "nacre/lut/sampler.h"
#include "nacre/shade/prepared_colour.h"
#include "pipeline/thread_clock.h"

namespace nacre {
namespace {

// Texels that are timed. Chosen: times are then repeated to a tenth.
constexpr int timed_columns = 32;
constexpr int timed_columns_of_row = 16;
constexpr int timed_rows = 3;

double seconds_since(double begin) {
    return thread_seconds() - begin;
}

// The middles of so many equal parts of an axis, at texels.
std::vector<double> places(int texels, int most) {
    const int count = std::min(texels, most);
    std::vector<double> result;
    for (int i = 0; i < count; ++i) result.push_back(coordinate_of_texel((2 * i + 1) * texels / (2 * count), texels));
    return result;
}

double once_through(const Job& job, const std::vector<double>& columns, const std::vector<double>& rows) {
    double begin = thread_seconds();
    Sampler sampler(job);
    sampler.at(columns.front(), rows.back());
    double seconds = seconds_since(begin);
    const double columns_per_place = static_cast<double>(job.width) / static_cast<double>(columns.size());
    const double rows_per_place = static_cast<double>(job.height) / static_cast<double>(rows.size());
    const auto of_row = [&](double y) {
        begin = thread_seconds();
        for (const double x : columns) sampler.at(x, y);
        return seconds_since(begin);
    };
    for (const double y : rows) {
        const double first = of_row(y);
        const double again = std::min(of_row(y), first);
        seconds += rows_per_place * (first + (columns_per_place - 1.0) * again);
    }
    return seconds;
}

// Without facets, over the angle alone. @pre the material is the same at all texels but for its relief
Job flat_job(Job job) {
    job.material.mechanism = simulated_at(job, 0.0, 0.0);
    job.material.mechanism.effects.relief = {};
    job.sampling.facets.reset();
    job.x = default_axis();
    job.y.reset();
    return job;
}

}  // namespace

double seconds_of_texels(const Job& job) {
    const std::vector<double> columns = places(job.width, job.y ? timed_columns_of_row : timed_columns);
    const std::vector<double> rows = places(job.height, timed_rows);
    return once_through(job, columns, rows);
}

double seconds_of_facets(const Job& job) {
    if (job.sampling.facets == nullptr) return 0.0;
    // Each interval of the curve took about as many colours; some of them are timed.
    constexpr std::size_t most_intervals = 12;
    const std::vector<double> borders = job.sampling.facets->colour().borders();
    const std::size_t intervals = borders.size() - 1;
    const std::size_t count = std::min(intervals, most_intervals);
    std::vector<double> middles;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t interval = (2 * i + 1) * intervals / (2 * count);
        middles.push_back(0.5 * (borders[interval] + borders[interval + 1]));
    }
    const Job flat = flat_job(job);
    const double colours = static_cast<double>(job.sampling.facets->colour().colours()) / static_cast<double>(count);
    Work work;
    PreparedColour prepared = prepare_colour(flat.material.mechanism, flat.sampling, *flat.light);
    const auto all = [&] {
        const double begin = thread_seconds();
        for (const double s : middles) colour_at(prepared, Incidence::from_sqrt_cos(s), work);
        return seconds_since(begin);
    };
    const double first = all();
    return first + (colours - 1.0) * std::min(all(), first);
}

namespace {

// The colours that the independent reference is asked for. Facets ask for a curve of them, which is kept as long as the
// material is the same.
struct ReferenceColours {
    Job job;  // without facets
    double count = 0.0;
};

ReferenceColours reference_colours(const ChosenLut& chosen) {
    constexpr double colours_of_facet_curve = 70.0;  // of the reference's, empirical as in accuracy/measure.cpp
    const Job& job = chosen.lut.job;
    ReferenceColours colours{job, static_cast<double>(bake_work(job, chosen.worst.size()).references)};
    if (!effects_in(job).has_any(facet_effects)) return colours;
    if (job.sampling.facets != nullptr) return {flat_job(job), colours_of_facet_curve};
    colours.job.material.mechanism.effects.relief = {};
    colours.count *= job.moves_material() ? colours_of_facet_curve : 1.0;
    return colours;
}

double seconds_of_measuring(const ChosenLut& chosen, const Execution& execution) {
    struct Timed {
        double x;
        double share;  // of an even axis
    };
    // Grazing is one of them, because it may take a hundred times the wavelengths there.
    constexpr std::array<Timed, 3> timed{{{0.06, 0.12}, {0.4, 0.44}, {0.75, 0.44}}};
    const ReferenceColours colours = reference_colours(chosen);
    execution.may_stop();
    const Reference reference(colours.job, tolerance_of_reference(chosen.lut.request.max_de00));
    double first = 0.0;
    double mean = 0.0;
    // Of a material that is the same everywhere, the second colours find everything prepared; of another at every point
    // only the wavelengths.
    for (const bool is_prepared : {false, true}) {
        mean = 0.0;
        for (const Timed& point : timed) {
            const double begin = thread_seconds();
            reference.at(point.x, 1.0 - point.x);
            const double seconds = seconds_since(begin);
            mean += point.share * seconds;
            first += is_prepared ? 0.0 : seconds;
        }
    }
    return first + std::max(colours.count - static_cast<double>(timed.size()), 0.0) * mean;
}

}  // namespace

double seconds_of_bake(const DecidedLut& lut, const Execution& execution) {
    // Colour space, gamut, header, manifest and encoding (empirical, on the machine in configs/accuracy.md): they
    // count in the smallest LUTs only.
    constexpr double of_any = 2.5e-4;
    constexpr double of_a_texel = 1e-7;
    const Job& job = lut.lut.lut.job;
    const double texels = static_cast<double>(job.width) * job.height;
    double computing = seconds_of_texels(job);
    constexpr double once_is_enough = 1e-2;
    if (computing < once_is_enough) computing = std::min(computing, seconds_of_texels(job));
    const double measuring = lut.space().has_inverse() ? seconds_of_measuring(lut.lut, execution) : 0.0;
    return of_any + of_a_texel * texels + computing + measuring;
}

}  // namespace nacre
