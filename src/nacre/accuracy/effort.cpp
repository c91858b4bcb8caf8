// How much work a search may take.
//
// Work is counted in reflectances of a single film (one angle, one wavelength), so that every machine finds the same
// LUT. In: a job whose sampling is chosen. A colour takes as many reflectances as it has nodes and samples, each as
// expensive as its layers are many. A mean over facets takes what its sum does, too.
#include "nacre/accuracy/effort.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "nacre/accuracy/mechanism_traits.h"
#include "nacre/lut/sampler.h"
#include "nacre/material/effects.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {
namespace {

// Some ten seconds of the machine in configs/accuracy.md.
constexpr double most_search_effort = 1e9;
// What a curve, and what the texels of one LUT, may take of it: a search needs several LUTs.
constexpr double effort_share_of_curve = 0.25;
constexpr double effort_share_of_lut = 0.25;

// What a term or a facet of a mean takes (measured), and so many there are about.
struct MeanEffort {
    Effect effect;
    double per_point;
    double points;
};
constexpr std::array mean_efforts{MeanEffort{Effect::tilt, 0.2, 200.0}, MeanEffort{Effect::roughness, 4.0, 150.0}};

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

double effort_per_mean(const Job& job) {
    const EffectSet effects = effects_in(job).minus(job.without);
    double effort = 0.0;
    for (const MeanEffort& mean : mean_efforts) {
        if (effects.has(mean.effect)) effort += mean.per_point * mean.points;
    }
    return effort;
}

Effort::Effort(const Job& job) {
    const double per_mean = effort_per_mean(job);
    const bool is_closed_form = traits_of(job.material.mechanism).is_closed_form;
    if (is_closed_form && per_mean == 0.0) return;
    const double per_texel = effort_per_colour(job) + per_mean;
    most_curve_colours_ = effort_share_of_curve * most_search_effort / per_texel;
    if (!is_closed_form) per_sample_ = effort_per_sample(job.material.mechanism, job.sampling.slices);
    if (!job.y) return;
    constexpr double fewest = 1 << 13;  // 128 x 64 (empirical)
    const auto most = static_cast<double>(most_texels_);
    most_texels_ =
        static_cast<std::int64_t>(std::clamp(effort_share_of_lut * most_search_effort / per_texel, fewest, most));
}

double Effort::spent(const Work& work) const {
    double effort = static_cast<double>(work.samples) * per_sample_;
    for (const MeanEffort& mean : mean_efforts)
        effort += mean.per_point * static_cast<double>(work.effects[static_cast<std::size_t>(mean.effect)].points);
    return effort;
}

bool Effort::is_spent(const Work& work) const {
    return spent(work) > most_search_effort;
}

bool Effort::is_far_beyond(const Work& work) const {
    constexpr double far = 2.0;  // empirical
    return spent(work) > far * most_search_effort;
}

}  // namespace nacre
