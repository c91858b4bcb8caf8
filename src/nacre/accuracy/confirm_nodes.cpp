// Whether the nodes that were chosen at a few probes do for the texels that are written.
//
// In: the survey, whose nodes the probes agreed on, and the size that was found with them. Band by band, the texels'
// colours are computed with the nodes and with twice as many; with the nodes themselves only where the survey's curve
// is far from these. Where they differ by more than nodes may, a resonance lies between the probes - a plasmon behind a
// gap, a mode of a cavity - and the count is doubled until they agree. Facets are left out: their mean is smoother than
// what it is the mean of.
#include "nacre/accuracy/confirm_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "nacre/accuracy/choose_nodes.h"
#include "nacre/accuracy/probes.h"
#include "nacre/colour/difference.h"
#include "nacre/lut/fetch.h"
#include "nacre/lut/sampler.h"

namespace nacre {
namespace {

// Texels that are looked at, at most, along either axis and in all. Chosen: a tenth of a second for a film.
constexpr int most_columns_looked_at = 1024;
constexpr int most_rows_looked_at = 17;
// Fewer say nothing that probes did not.
constexpr std::size_t fewest_texels = 6;
// Nodes are chosen so that they err by less than the tolerance at probes; between them by half as much again, and what
// is compared here errs too.
constexpr double tolerances = 2.0;

using PointsOfBands = std::array<std::vector<LutPoint>, band_least_cos_theta.size()>;

// Every n-th texel of a side, the ends among them.
std::vector<double> coordinates_of(int texels, int most) {
    const int count = std::min(texels, most);
    std::vector<double> coordinates;
    for (int i = 0; i < count; ++i) {
        const int texel =
            count == texels ? i : static_cast<int>(std::llround(static_cast<double>(i) * (texels - 1) / (count - 1)));
        coordinates.push_back(texels == 1 ? 0.0 : coordinate_of_texel(texel, texels));
    }
    return coordinates;
}

PointsOfBands points_of(const Job& job, const Candidate& size) {
    const bool has_incidence = quantity_of(job.material.mechanism) == Quantity::incidence;
    PointsOfBands points;
    for (const double y : coordinates_of(size.height, most_rows_looked_at)) {
        for (const double x : coordinates_of(size.width, most_columns_looked_at)) {
            const std::size_t band = has_incidence ? band_of(geometry_at(job, x, y).incidence) : 0;
            points[band].push_back({x, y});
        }
    }
    return points;
}

// The job without facets, and with few samples of uneven thicknesses, whose mean is about as smooth as that of all.
Job plain_job(const Job& job) {
    Job plain = job;
    plain.without.insert(facet_effects);
    plain.sampling.facets = nullptr;
    plain.sampling.thickness_samples = std::min(plain.sampling.thickness_samples, few_thickness_samples);
    return plain;
}

Colours colours_with(Job job, const std::shared_ptr<const SpectralNodes>& nodes, const std::vector<LutPoint>& points,
                     const AfterRow& after_step, Work& work) {
    job.sampling = with_nodes(std::move(job.sampling), nodes);
    Sampler sampler(job);
    Colours colours;
    for (const LutPoint& point : points) {
        colours.push_back(sampler.at(point.x, point.y));
        if (after_step) after_step();
    }
    work += sampler.work();
    return colours;
}

double largest_difference(const Colours& one, const Colours& other, double scale) {
    double largest = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) largest = std::max(largest, difference_at(one[i], other[i], scale));
    return largest;
}

// The texels at which a curve of the colours is furthest from `finer` ones, and these: only there the colours
// themselves need to be computed.
struct FarTexels {
    std::vector<LutPoint> points;
    Colours finer;
};

FarTexels far_from_curve(const ModelCurve& curve, const std::vector<LutPoint>& points, const Colours& finer,
                         double scale) {
    constexpr std::size_t most_texels = 8;  // chosen: a curve errs by less than nodes may
    std::vector<std::pair<double, std::size_t>> differences;
    for (std::size_t i = 0; i < points.size(); ++i)
        differences.emplace_back(difference_at(curve.at(points[i].x), finer[i], scale), i);
    const std::size_t count = std::min(most_texels, differences.size());
    std::partial_sort(differences.begin(), differences.begin() + static_cast<std::ptrdiff_t>(count), differences.end(),
                      std::greater<>());
    FarTexels far;
    for (std::size_t i = 0; i < count; ++i) {
        far.points.push_back(points[differences[i].second]);
        far.finer.push_back(finer[differences[i].second]);
    }
    return far;
}

}  // namespace

ConfirmedNodes confirm_nodes(const LutSurvey& survey, const Candidate& size, double most_error,
                             const AfterRow& after_step, Work& work) {
    const Job& job = survey.lut.job;
    ConfirmedNodes confirmed{job.sampling.counts().nodes, 0.0};
    if (job.light->settings.wavelengths || !samples_spectra(job.material.mechanism)) return confirmed;
    const bool is_given = survey.lut.request.sampling.nodes.front() > 0;
    const Job plain = plain_job(job);
    const bool is_plain =
        !effects_in(job).has_any(facet_effects) && plain.sampling.thickness_samples == job.sampling.thickness_samples;
    const PointsOfBands points = points_of(job, size);
    const double per_sample =
        effort_per_sample(job.material.mechanism, job.sampling.slices) * plain.sampling.thickness_samples;
    for (std::size_t band = 0; band < points.size(); ++band) {
        int& count = confirmed.counts[band];
        if (band > 0 && !is_given) count = std::max(count, confirmed.counts[band - 1]);
        // Of facets, those near grazing hardly count.
        if (points[band].size() < fewest_texels || (band > 0 && effects_in(job).has_any(facet_effects))) continue;
        const auto is_affordable = [&] {
            const double effort = per_sample * 2.0 * count * static_cast<double>(points[band].size());
            return 2 * count <= most_nodes && effort <= most_probe_effort;
        };
        if (!is_affordable()) continue;
        const double usual = tolerances * tolerances_of_band[band] * tolerance_of_nodes(survey.lut.request.max_de00);
        const double limit = std::min(usual, most_error);
        std::optional<Colours> colours;  // of all texels with `count` nodes
        while (is_affordable()) {
            Colours finer = colours_with(plain, survey.nodes->of(2 * count), points[band], after_step, work);
            FarTexels far{points[band], finer};
            if (is_plain && survey.curve && !colours)
                far = far_from_curve(*survey.curve, points[band], finer, survey.scale);
            if (!colours) colours = colours_with(plain, survey.nodes->of(count), far.points, after_step, work);
            const double error = largest_difference(*colours, far.finer, survey.scale);
            if (is_given || error <= limit) {
                if (is_plain) confirmed.error = std::max(confirmed.error, error);
                break;
            }
            confirmed.were_wrong = confirmed.were_wrong || error > usual;
            count *= 2;
            colours = std::move(finer);
        }
    }
    return confirmed;
}

}  // namespace nacre
