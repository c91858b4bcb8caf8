// How much work a search may take.
//
// Work is counted in reflectances of a single film (one angle, one wavelength), so that every machine finds the same
// LUT. In: a job whose sampling is chosen. A colour takes as many reflectances as it has nodes and samples, each as
// expensive as its layers are many.
#include "nacre/accuracy/effort.h"

#include <algorithm>
#include <array>

#include "nacre/accuracy/mechanism_traits.h"
#include "nacre/lut/sampler.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {
namespace {

// Some ten seconds of the machine in configs/accuracy.md.
constexpr double most_search_effort = 1e9;
// What a curve, and what the texels of one LUT, may take of it: a search needs several LUTs.
constexpr double effort_share_of_curve = 0.25;
constexpr double effort_share_of_lut = 0.25;

// Reflectances that one colour takes, on average over the axes.
double samples_per_colour(const Job& job) {
    if (!is_layered(job.material.mechanism)) {
        Sampler sampler(job);
        sampler.at(0.5, 0.5);
        return 1.0 + static_cast<double>(sampler.work().samples);
    }
    // Bands of angles by their share of the default axis: differences of the square roots of their least cosines.
    constexpr std::array<double, band_least_cos_theta.size()> share{0.45, 0.33, 0.16, 0.06};
    const NodeCounts counts = job.sampling.counts().nodes;
    double nodes = 1.0;
    for (std::size_t band = 0; band < counts.size(); ++band) nodes += share[band] * counts[band];
    return nodes * job.sampling.thickness_samples;
}

}  // namespace

double effort_per_colour(const Job& job) {
    if (traits_of(job.material.mechanism).is_closed_form) return 1.0;
    return samples_per_colour(job) * effort_per_sample(job.material.mechanism, job.sampling.slices);
}

Effort::Effort(const Job& job) {
    if (traits_of(job.material.mechanism).is_closed_form) return;
    per_sample_ = effort_per_sample(job.material.mechanism, job.sampling.slices);
    const double per_texel = effort_per_colour(job);
    most_curve_colours_ = effort_share_of_curve * most_search_effort / per_texel;
    if (!job.y) return;
    constexpr double fewest = 1 << 13;  // 128 x 64 (empirical)
    const auto most = static_cast<double>(most_texels_);
    most_texels_ =
        static_cast<std::int64_t>(std::clamp(effort_share_of_lut * most_search_effort / per_texel, fewest, most));
}

bool Effort::is_spent(const Work& work) const {
    return static_cast<double>(work.samples) * per_sample_ > most_search_effort;
}

bool Effort::is_far_beyond(const Work& work) const {
    constexpr double far = 2.0;  // empirical
    return static_cast<double>(work.samples) * per_sample_ > far * most_search_effort;
}

}  // namespace nacre
