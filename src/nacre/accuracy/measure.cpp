// The error of a finished LUT, against the independent reference.
//
// In: the job, the numbers as they are in the file, and the points at which the search found the largest errors. The
// colours of those points, of the corners and of points that are spread evenly over the LUT are fetched as a shader
// does and compared with the reference. Where the reference is expensive, fewer points are compared, the worst first.
#include "nacre/accuracy/measure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "nacre/accuracy/mechanism_traits.h"
#include "nacre/accuracy/reference.h"
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

std::size_t part_of(std::size_t count, double share) {
    return static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
}

}  // namespace

double measured_share(const Job& job) {
    const Mechanism mechanism = mechanism_at(job, 0.5, 0.5);
    const auto reference_cost = traits_of(mechanism).reference_cost;
    const double cost = reference_cost != nullptr ? reference_cost(job, mechanism) : 1.0;
    // Empirical: the time to measure rises with the root of the cost only, up to a twelfth of the points.
    return cost <= 1.0 ? 1.0 : std::clamp(1.0 / std::sqrt(cost), 1.0 / 12.0, 1.0);
}

Measured measure(const Job& job, const Image<Rgb>& stored, const Encoding& encoding,
                 std::span<const LutPoint> suspects) {
    const bool is_2d = job.y.has_value();
    const double share = measured_share(job);
    suspects = suspects.first(part_of(suspects.size(), share));
    std::vector<LutPoint> points(suspects.begin(), suspects.end());
    for (const double x : {0.0, 1.0}) {
        points.push_back({x, 0.0});
        if (is_2d) points.push_back({x, 1.0});
    }
    const auto spread = static_cast<int>(part_of(spread_points, share));
    for (int i = 0; i < spread; ++i) points.push_back(spread_point(i, is_2d));

    const Reference reference(job);
    const auto count = static_cast<int>(points.size());
    Image<Xyz> truth(count, 1);
    std::transform(points.begin(), points.end(), truth.begin(),
                   [&](LutPoint point) { return reference.at(point.x, point.y); });
    if (!encoding.keeps_colours) truth = encoding.to_xyz(encoding.to_rgb(truth));
    Image<Rgb> fetched(count, 1);
    std::transform(points.begin(), points.end(), fetched.begin(), [&](LutPoint point) { return fetch(stored, point); });
    const Image<Xyz> seen = encoding.to_xyz(fetched);
    const double scale = brightness_scale(encoding.to_xyz(stored), display_scale(truth));

    Measured measured;
    measured.scale = scale;
    measured.work.references = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double error = difference_at(seen.data()[i], truth.data()[i], scale);
        if (error > measured.reached || std::isnan(error)) {
            measured.reached = error;
            measured.at = points[i];
        }
    }
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
    const double share = measured_share(job);
    work.references = part_of(suspects, share) + corners + part_of(spread_points, share);
    return work;
}

}  // namespace nacre
