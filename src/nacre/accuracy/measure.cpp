// The error of a finished LUT, against the independent reference.
//
// In: the choice, the texels, and the numbers as they are in the file. Two comparisons make an upper estimate:
//   1. The numbers, fetched as a shader does, with the bake's own model. The choice did that everywhere; where it took
//      colours from a curve, the model itself is asked at the texels, in the middles between them, and where the choice
//      saw the largest errors.
//   2. The model with the reference: at the points at which the LUT errs most, at the corners, and at points that are
//      spread evenly. Where the reference is expensive there are fewer, the worst first. The numbers themselves are
//      compared there, too, whatever the first comparison says. What the choice saw twice as many nodes change of a
//      texel counts likewise: there are more texels than points.
#include "nacre/accuracy/measure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "nacre/accuracy/effort.h"
#include "nacre/accuracy/mechanism_traits.h"
#include "nacre/accuracy/reference.h"
#include "nacre/accuracy/scan.h"
#include "nacre/accuracy/trial.h"
#include "nacre/colour/difference.h"
#include "nacre/lut/gamut.h"
#include "nacre/lut/job.h"
#include "nacre/lut/sampler.h"

namespace nacre {
namespace {

// Evenly, whatever the size of the LUT: the plastic number's sequence (Roberts 2018), in 1D the golden ratio's.
LutPoint spread_point(int i, bool is_2d) {
    constexpr double golden = 0.61803398874989485;
    constexpr double plastic = 0.75487766624669276;
    const auto part = [](double value) { return value - std::floor(value); };
    if (!is_2d) return {part(0.5 + i * golden), 0.0};
    return {part(0.5 + i * plastic), part(0.5 + i * plastic * plastic)};
}

// XYZ as the colour space holds them.
template <typename ColourAt>
Image<Xyz> colours_of(const std::vector<LutPoint>& points, const Encoding& encoding, const ColourAt& colour_at) {
    Image<Xyz> colours(static_cast<int>(points.size()), 1);
    std::transform(points.begin(), points.end(), colours.begin(), colour_at);
    return encoding.keeps_colours ? colours : encoding.to_xyz(encoding.to_rgb(colours));
}

// Measuring may take so many reflectances of a film, half a millisecond to two, or so many times what the texels take.
// Chosen: with the choice itself it then takes less than ten times as long as the texels.
constexpr double always_affordable = 3e5;
constexpr double texels_affordable = 1.0;
// So many points there are in any case, and at most.
constexpr double fewest_points_judged = 12.0;
constexpr double most_points_judged = 128.0;
// That a curve of facets asks for (empirical).
constexpr double colours_of_facet_curve = 70.0;

double effort_of_texels(const Job& job) {
    return static_cast<double>(job.width) * static_cast<double>(job.height) * effort_per_colour(job);
}

}  // namespace

double measured_share(const Job& job) {
    const Mechanism mechanism = mechanism_at(job, 0.5, 0.5);
    const auto reference_cost = traits_of(mechanism).reference_cost;
    if (reference_cost == nullptr) return 1.0;
    // Facets' colours are kept as long as the material is the same; else each point asks for a curve of them.
    const bool has_facets = !mechanism.effects.relief.is_plane();
    const double colours =
        has_facets && job.moves_material() && job.sampling.facets == nullptr ? colours_of_facet_curve : 1.0;
    const double affordable = std::max(always_affordable, texels_affordable * effort_of_texels(job));
    const double points = affordable / (colours * reference_cost(job, mechanism));
    return std::clamp(points / most_points_judged, fewest_points_judged / most_points_judged, 1.0);
}

namespace {

struct JudgedCounts {
    std::size_t suspects;  // the worst first
    std::size_t spread;
};

// Suspects come first, but for a third of the points.
JudgedCounts judged_counts(const Job& job, std::size_t suspects) {
    const double points = measured_share(job) * most_points_judged;
    const auto taken = std::min(suspects, static_cast<std::size_t>(std::ceil(2.0 / 3.0 * points)));
    const double left = std::ceil(points) - static_cast<double>(taken);
    return {taken, static_cast<std::size_t>(std::clamp(left, 0.0, static_cast<double>(spread_points)))};
}

}  // namespace

double tolerance_of_reference(double max_de00) {
    constexpr double share = 0.01;  // chosen: it is seen in no digit that is told
    return share * max_de00;
}

namespace {

// The points at which the reference is asked, and what it says there.
struct Judged {
    std::vector<LutPoint> points;
    Image<Xyz> truth;  // in a row
};

// @param tolerance  of the reference, CIEDE2000
Judged judge(const Job& job, const Encoding& encoding, std::span<const LutPoint> suspects, double tolerance) {
    const bool is_2d = job.y.has_value();
    const JudgedCounts counts = judged_counts(job, suspects.size());
    suspects = suspects.first(counts.suspects);
    Judged judged{{suspects.begin(), suspects.end()}, {}};
    for (const double x : {0.0, 1.0}) {
        judged.points.push_back({x, 0.0});
        if (is_2d) judged.points.push_back({x, 1.0});
    }
    for (int i = 0; i < static_cast<int>(counts.spread); ++i) judged.points.push_back(spread_point(i, is_2d));
    // Towards grazing the reference takes ever more wavelengths, and begins where it ended.
    std::stable_sort(judged.points.begin(), judged.points.end(),
                     [](const LutPoint& one, const LutPoint& other) { return one.x > other.x; });
    const Reference reference(job, tolerance);
    judged.truth = colours_of(judged.points, encoding, [&](LutPoint point) { return reference.at(point.x, point.y); });
    return judged;
}

Measured compare(const Judged& judged, const Image<Rgb>& stored, const Encoding& encoding) {
    Image<Rgb> fetched(judged.truth.width(), 1);
    std::transform(judged.points.begin(), judged.points.end(), fetched.begin(),
                   [&](LutPoint point) { return fetch(stored, point); });
    const Image<Xyz> seen = encoding.to_xyz(fetched);
    Measured measured;
    measured.scale = brightness_scale(encoding.to_xyz(stored), display_scale(judged.truth));
    measured.reference_points = measured.work.references = judged.points.size();
    for (std::size_t i = 0; i < judged.points.size(); ++i) {
        const double error = difference_at(seen.data()[i], judged.truth.data()[i], measured.scale);
        if (error > measured.reached || std::isnan(error)) {
            measured.reached = error;
            measured.at = judged.points[i];
        }
    }
    return measured;
}

double largest_difference(const Image<Xyz>& one, const Image<Xyz>& other, double scale) {
    double largest = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i)
        largest = std::max(largest, difference_at(one.data()[i], other.data()[i], scale));
    return largest;
}

// What the bake's own model is from the truth, the largest at the points judged.
double error_of_model(const Job& job, const Judged& judged, const Encoding& encoding, double scale) {
    Sampler sampler(job);
    const Image<Xyz> model =
        colours_of(judged.points, encoding, [&](LutPoint point) { return sampler.at(point.x, point.y); });
    return largest_difference(model, judged.truth, scale);
}

// Where a curve stood for the model of a 1D LUT, the model itself is asked: in the middle between every two texels,
// where a linear filter errs most, at breakpoints, and where the choice saw the largest errors.
std::vector<LutPoint> points_without_curve(const ChosenLut& chosen) {
    const Job& job = chosen.lut.job;
    std::vector<LutPoint> points = chosen.worst;
    for (int i = 0; i + 1 < job.width; ++i) points.push_back({(i + 0.5) / (job.width - 1), 0.0});
    for (const double x : breakpoints(job, 0.0)) points.push_back({x, 0.0});
    return points;
}

// What a fetch at a texel is from what was baked.
double error_of_storage(const Image<Xyz>& texels, const Image<Rgb>& stored, const Encoding& encoding, double scale) {
    const Image<Xyz> meant = encoding.keeps_colours ? texels : encoding.to_xyz(encoding.to_rgb(texels));
    return largest_difference(encoding.to_xyz(stored), meant, scale);
}

// What fetches are from the model, the largest.
double error_of_fetches(const Job& job, const std::vector<LutPoint>& points, const Image<Rgb>& stored,
                        const Encoding& encoding, double scale) {
    Sampler sampler(job);
    const Image<Xyz> model = colours_of(points, encoding, [&](LutPoint point) { return sampler.at(point.x, point.y); });
    Image<Rgb> fetched(model.width(), 1);
    std::transform(points.begin(), points.end(), fetched.begin(), [&](LutPoint point) { return fetch(stored, point); });
    return largest_difference(encoding.to_xyz(fetched), model, scale);
}

}  // namespace

Measured measure(const Job& job, const Image<Rgb>& stored, const Encoding& encoding,
                 std::span<const LutPoint> suspects) {
    return compare(judge(job, encoding, suspects, tolerance_of_reference(AccuracyRequest::default_max_de00)), stored,
                   encoding);
}

Measured measure(const ChosenLut& chosen, const Image<Xyz>& texels, const Image<Rgb>& stored,
                 const Encoding& encoding) {
    Job job = chosen.lut.job;
    job.sampling.kept = std::make_shared<KeptSolvers>();
    const Judged judged = judge(job, encoding, chosen.worst, tolerance_of_reference(chosen.lut.request.max_de00));
    Measured measured = compare(judged, stored, encoding);
    measured.model_points = chosen.model_points;
    measured.of_texels = chosen.from_model;
    if (chosen.curve) {
        const std::vector<LutPoint> points = points_without_curve(chosen);
        const double of_fetches = error_of_fetches(job, points, stored, encoding, measured.scale);
        measured.of_texels =
            std::max(of_fetches / share_found_by_scan(job), error_of_storage(texels, stored, encoding, measured.scale));
        measured.model_points = points.size() + texels.size();
    }
    measured.of_model = std::max(error_of_model(job, judged, encoding, measured.scale), chosen.of_nodes);
    // The scene's own wavelengths are no model of the truth: what they err by was found by the true integral.
    const bool is_sampled = job.light->settings.wavelengths.has_value();
    const double in_all = is_sampled ? chosen.predicted.total : measured.of_texels + measured.of_model;
    if (measured.reached < in_all) measured.reached = in_all;  // not a number stays what it is
    measured.reached += chosen.predicted.spread;
    return measured;
}

ClippingLoss clipping_loss(const Image<Rgb>& stored, const Encoding& encoding, double scale, double bound) {
    std::vector<Rgb> negative;
    for (const Rgb& texel : stored) {
        if (std::min({texel.r, texel.g, texel.b}) < 0.0) negative.push_back(texel);
    }
    ClippingLoss loss;
    if (negative.empty()) return loss;
    Image<Rgb> kept(static_cast<int>(negative.size()), 1);
    std::copy(negative.begin(), negative.end(), kept.begin());
    Image<Rgb> clipped(kept.width(), 1);
    std::transform(kept.begin(), kept.end(), clipped.begin(), clip_to_gamut);
    const Image<Xyz> meant = encoding.to_xyz(kept);
    const Image<Xyz> seen = encoding.to_xyz(clipped);
    for (std::size_t i = 0; i < meant.size(); ++i) {
        const double change = difference_at(meant.data()[i], seen.data()[i], scale);
        if (change > bound) ++loss.texels;
        loss.de00 = std::max(loss.de00, change);
    }
    return loss;
}

namespace {

// Reflectances of all texels.
std::uint64_t samples_of(const Job& job) {
    const auto samples = static_cast<std::uint64_t>(job.sampling.thickness_samples);
    const auto texels = static_cast<std::uint64_t>(job.width) * static_cast<std::uint64_t>(job.height);
    if (job.light->settings.wavelengths)
        return texels * static_cast<std::uint64_t>(*job.light->settings.wavelengths) * samples;
    const NodeCounts counts = job.sampling.counts().nodes;
    std::uint64_t sum = 0;
    for (int row = 0; row < job.height; ++row) {
        for (int column = 0; column < job.width; ++column) {
            const Geometry geometry =
                geometry_at(job, coordinate_of_texel(column, job.width), coordinate_of_texel(row, job.height));
            sum += static_cast<std::uint64_t>(counts[band_of(geometry.incidence)]) * samples;
        }
    }
    return sum;
}

}  // namespace

Work bake_work(const Job& job, std::size_t suspects) {
    Work work;
    work.texels = static_cast<std::uint64_t>(job.width) * static_cast<std::uint64_t>(job.height);
    const bool is_integrated = traits_of(job.material.mechanism).is_closed_form && !job.light->settings.wavelengths;
    (is_integrated ? work.exact_integrals : work.spectra) = work.texels;
    if (work.spectra > 0) work.samples = samples_of(job);
    const std::size_t corners = job.y ? 4 : 2;
    const JudgedCounts counts = judged_counts(job, suspects);
    work.references = counts.suspects + corners + counts.spread;
    return work;
}

}  // namespace nacre
