#include "nacre/accuracy/measure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "nacre/accuracy/reference.h"
#include "nacre/accuracy/trial.h"

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

}  // namespace

Measured measure(const Job& job, const Image<Rgb>& stored, const Encoding& encoding,
                 std::span<const LutPoint> suspects) {
    const bool is_2d = job.y.has_value();
    std::vector<LutPoint> points(suspects.begin(), suspects.end());
    for (const double x : {0.0, 1.0}) {
        points.push_back({x, 0.0});
        if (is_2d) points.push_back({x, 1.0});
    }
    for (int i = 0; i < spread_points; ++i) points.push_back(spread_point(i, is_2d));

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

Work bake_work(const Job& job, std::size_t suspects) {
    Work work;
    work.texels = static_cast<std::uint64_t>(job.width) * static_cast<std::uint64_t>(job.height);
    const bool is_layered = needs_sampling(job.material.mechanism);
    const auto& wavelengths = job.light->settings.wavelengths;
    (is_layered || wavelengths        ? work.spectra
     : job.integral == Integral::fast ? work.fast_integrals
                                      : work.exact_integrals) = work.texels;
    const int nodes = wavelengths ? *wavelengths : job.sampling.node_count();
    work.samples = work.spectra * static_cast<std::uint64_t>(nodes * job.sampling.realisations);
    const std::size_t corners = job.y ? 4 : 2;
    work.references = suspects + corners + spread_points;
    return work;
}

}  // namespace nacre
