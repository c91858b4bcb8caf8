// The choice of two LUTs that go together.
//
// In: the LUTs of a reflectance and of a transmittance that are asked for with the same words. Each is chosen alone
// first. Then both are chosen once more, with all that was left open given: the larger of both widths, heights and
// counts of every sum, the finer format, and only those effects left out that either does without. Where their numbers
// agree texel by texel, so does what a shader fetches between texels.
#include "nacre/accuracy/choose_pair.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "nacre/accuracy/measure.h"
#include "nacre/base/image.h"

namespace nacre {
namespace {

SamplingCounts more_of(SamplingCounts one, const SamplingCounts& other) {
    for (std::size_t band = 0; band < one.nodes.size(); ++band)
        one.nodes[band] = std::max(one.nodes[band], other.nodes[band]);
    for (int SamplingCounts::*count : {&SamplingCounts::thickness_samples, &SamplingCounts::base_directions,
                                       &SamplingCounts::radii, &SamplingCounts::slices})
        one.*count = std::max(one.*count, other.*count);
    return one;
}

// All that either needs.
AccuracyRequest common_request(const ChosenLut& one, const ChosenLut& other) {
    const Job& a = one.lut.job;
    const Job& b = other.lut.job;
    AccuracyRequest request = one.lut.request;
    request.width = std::max(a.width, b.width);
    if (a.y) request.height = std::max(a.height, b.height);
    const bool is_half = one.lut.format == PixelFormat::half_float && other.lut.format == PixelFormat::half_float;
    request.format = is_half ? PixelFormat::half_float : PixelFormat::single_float;
    request.sampling = more_of(a.sampling.counts(), b.sampling.counts());
    request.may_drop_effects = false;
    request.without = a.without.minus(a.without.minus(b.without));
    return request;
}

// Whether the other one of the pair needs no more of anything.
bool has_all(const ChosenLut& alone, const AccuracyRequest& request) {
    const Job& job = alone.lut.job;
    return job.width == request.width && (!job.y || job.height == request.height) &&
           alone.lut.format == request.format && job.sampling.counts() == request.sampling &&
           job.without == request.without;
}

// @param alone  chosen by itself: it knows what was asked, and why its effects are left out
ChosenLut with_request(const ChosenLut& alone, const AccuracyRequest& request, const Encoding& encoding,
                       const AfterRow& after_step) {
    if (has_all(alone, request)) return alone;
    PlannedLut lut = alone.lut;
    lut.request = request;
    ChosenLut chosen = choose_lut(lut, encoding, after_step);
    chosen.lut.request = alone.lut.request;
    chosen.effects = alone.effects;
    for (EffectChoice& effect : chosen.effects) effect.is_simulated = !request.without.has(effect.effect);
    chosen.is_reached = alone.is_reached;  // it has all that it needs alone
    chosen.limiting_factor = alone.limiting_factor;
    chosen.work += alone.work;
    return chosen;
}

// The error of a LUT that is thought to keep its bound, once it is baked, in bounds.
double share_of_bound(const ChosenLut& chosen, const Encoding& encoding) {
    if (!encoding.to_xyz || !chosen.is_reached || !chosen.lut.request.has_bound) return 0.0;
    const Image<Xyz> texels = bake(chosen.lut.job);
    Image<Rgb> stored = encoding.to_rgb(texels);
    for (Rgb& texel : stored) {
        for (double Rgb::*component : {&Rgb::r, &Rgb::g, &Rgb::b})
            texel.*component = encoding.stored(texel.*component, chosen.lut.format);
    }
    return measure(chosen, texels, stored, encoding).reached / chosen.lut.request.max_de00;
}

}  // namespace

ChosenPair choose_pair(const std::array<PlannedLut, 2>& luts, const Encoding& encoding, const AfterRow& after_step) {
    constexpr int most_times = 4;  // as a LUT is baked at most
    std::optional<ChosenPair> best;
    double least = 0.0;
    Care care;
    for (int times = 0; times < most_times; ++times) {
        const ChosenPair alone{choose_lut(luts[0], encoding, after_step, care),
                               choose_lut(luts[1], encoding, after_step, care)};
        const AccuracyRequest request = common_request(alone[0], alone[1]);
        ChosenPair pair{with_request(alone[0], request, encoding, after_step),
                        with_request(alone[1], request, encoding, after_step)};
        const double first = share_of_bound(pair[0], encoding);
        const double second = share_of_bound(pair[1], encoding);
        const ChosenLut& worse = first < second ? pair[1] : pair[0];
        const double share = std::max(first, second);
        if (share > 1.0) care = more_care(care, worse, share * worse.lut.request.max_de00);
        if (!best || share < least) {
            best = std::move(pair);
            least = share;
        }
        if (!(share > 1.0)) break;
    }
    return std::move(*best);
}

}  // namespace nacre
