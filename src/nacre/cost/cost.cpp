#include "nacre/cost/cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <variant>

#include "nacre/base/image.h"
#include "nacre/base/text.h"
#include "nacre/base/words.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/light.h"
#include "nacre/colour/observer.h"
#include "nacre/colour/spectral_nodes.h"
#include "nacre/cost/baselines.h"
#include "nacre/cost/effect_cost.h"
#include "nacre/lut/axis_kinds.h"
#include "nacre/lut/bake.h"
#include "nacre/lut/fetch.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/lut/sampler.h"
#include "nacre/material/effects.h"
#include "nacre/material/geometry.h"
#include "nacre/material/mechanism.h"
#include "nacre/optics/palette.h"
#include "nacre/shade/spectral_sampling.h"

namespace nacre {
namespace {

constexpr int integral_size = 1024;  // large enough to show the error of an integral
constexpr int mistake_size = 256;
constexpr std::array fixed_sizes{32, 64, 128, 256, 512, 1024};
constexpr std::array bounds{5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002};
constexpr std::array node_counts{12, 16, 24, 32, 48, 64, 128};
constexpr std::array sum_steps_nm{1, 2, 5, 10, 20};

using Store = std::function<double(double)>;

void store(Image<Rgb>& image, const Store& stored) {
    for (Rgb& texel : image) texel = {stored(texel.r), stored(texel.g), stored(texel.b)};
}

// sRGB's curve in 8 bits, as hardware decodes it before it filters (IEC 61966-2-1).
double in_8_bits(double linear) {
    const double clipped = std::clamp(linear, 0.0, 1.0);
    const double encoded = clipped <= 0.0031308 ? 12.92 * clipped : 1.055 * std::pow(clipped, 1.0 / 2.4) - 0.055;
    const double code = std::round(encoded * 255.0) / 255.0;
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

// The colours of a tilted or rough material begin with those of its facets: who has not decided on anything has no
// curve of them yet.
Job without_facets(Job job) {
    job.sampling.facets.reset();
    return job;
}

// Every texel's lobe through a baseline. The mechanism's own part is that of the real bake.
Image<Xyz> bake_with(const Job& job, const Baseline& baseline) {
    Image<Xyz> image(job.width, job.height);
    Sampler sampler(job);
    for (int row = 0; row < job.height; ++row) {
        const double y = coordinate_of_texel(row, job.height);
        for (int column = 0; column < job.width; ++column)
            image.at(column, row) = baseline.to_xyz(sampler.lobe_at(coordinate_of_texel(column, job.width), y));
    }
    return image;
}

class Cases {
public:
    Cases(const PlannedLut& lut, const Encoding& encoding, double bound, const AfterRow& after_step)
        : lut_(lut), encoding_(encoding), bound_(bound), after_step_(after_step) {
        lut_.request = {};
        lut_.request.max_de00 = bound;
        lut_.job.light = without_wavelengths(lut.job.light);
        // The baselines have every effect.
        lut_.request.may_drop_effects = false;
        const ChosenLut chosen = choose_lut(lut_, encoding, after_step);
        lut_.request.may_drop_effects = true;
        height_ = chosen.lut.job.height;
        lut_.job.sampling = chosen.lut.job.sampling;
    }

    std::vector<CostCase> all() {
        add_integrals();
        add_fixed_sizes();
        add_mistakes();
        add_effects();
        add_choices();
        return std::move(cases_);
    }

private:
    Job sized(int width) const {
        Job job = lut_.job;
        job.width = width;
        job.height = height_;
        return job;
    }

    CostCase& add(CostFamily family, std::string label, Job job, PixelFormat format) {
        CostCase& cost = cases_.emplace_back();
        cost.family = family;
        cost.label = std::move(label);
        cost.axis = job.x.is_angle() ? std::string(job.x.kind->name) : job.x.parameter.name;
        cost.format = std::string(name_of(format_words, format));
        cost.bytes = static_cast<std::size_t>(job.width) * static_cast<std::size_t>(job.height) *
                     (format == PixelFormat::half_float ? 6 : 12);
        cost.sampled_for = bound_;
        cost.needs_sampling = samples_spectra(job.material.mechanism) || !effects_in(job).is_empty();
        cost.job = std::move(job);
        cost.make = [&encoding = encoding_, job = without_facets(cost.job), format] {
            return stored_lut(job, format, encoding);
        };
        return cost;
    }

    // Whose every colour is one band: the baselines of bands know no facets.
    bool is_bare_palette() const {
        return std::holds_alternative<Palette>(lut_.job.material.mechanism) &&
               !effects_in(lut_.job).has_any(facet_effects);
    }

    void add_baseline(std::string label, std::shared_ptr<const Baseline> baseline) {
        CostCase& cost = add(CostFamily::integral, std::move(label), sized(integral_size), PixelFormat::single_float);
        cost.make = [&encoding = encoding_, job = cost.job, baseline = std::move(baseline)] {
            Image<Rgb> image = encoding.to_rgb(bake_with(job, *baseline));
            store(image, [&](double value) { return encoding.stored(value, PixelFormat::single_float); });
            return image;
        };
    }

    // A film or stack at the wavelengths of a baseline.
    Job sampled(Job job, SpectralNodes nodes) const {
        job.sampling.nodes.fill(std::make_shared<const SpectralNodes>(std::move(nodes)));
        job.sampling.incoherent_layers.clear();
        return without_facets(std::move(job));
    }

    void add_nodes(std::string label, SpectralNodes nodes) {
        CostCase& cost = add(CostFamily::integral, std::move(label), sized(integral_size), PixelFormat::single_float);
        cost.needs_sampling = false;
        cost.make = [&encoding = encoding_, job = sampled(cost.job, std::move(nodes))] {
            return stored_lut(job, PixelFormat::single_float, encoding);
        };
    }

    // Sampled spectra: nodes by product integration, and the baselines.
    void add_samplings() {
        const Light& light = *lut_.job.light;
        add(CostFamily::integral, "chosen nodes", sized(integral_size), PixelFormat::single_float);
        for (const int count : node_counts)
            add_nodes(std::to_string(count) + " nodes", make_spectral_nodes(light.weights, count));
        for (const int step_nm : sum_steps_nm)
            add_nodes(std::to_string(step_nm) + " nm sum", sum_nodes(light, step_nm));
        if (light.settings.observer == Observer::cie1931_2deg) add_nodes("Wyman fit at 5 nm", fit_nodes(light, false));
        add_nodes("Wyman single-lobe fit at 5 nm", fit_nodes(light, true));
        add_nodes("three wavelengths", three_wavelengths_nodes(light));
    }

    void add_integrals() {
        const Mechanism& mechanism = lut_.job.material.mechanism;
        if (samples_spectra(mechanism)) return add_samplings();
        if (!is_bare_palette()) {
            add(CostFamily::integral, "exact integral", sized(integral_size), PixelFormat::single_float);
            return;
        }
        const Light& light = *lut_.job.light;
        add(CostFamily::integral, "exact integral", sized(integral_size), PixelFormat::single_float);
        for (const int step_nm : sum_steps_nm)
            add_baseline(std::to_string(step_nm) + " nm sum", make_sum_baseline(light, step_nm));
        if (light.settings.observer == Observer::cie1931_2deg)
            add_baseline("Wyman fit at 5 nm", make_fit_baseline(light, false));
        add_baseline("Wyman single-lobe fit at 5 nm", make_fit_baseline(light, true));
        add_baseline("three wavelengths", make_three_wavelengths_baseline());
    }

    void add_fixed_sizes() {
        if (!lut_.job.x.is_angle()) return;
        for (const AxisKind& kind : axis_kinds()) {
            if (kind.quantity != lut_.job.x.kind->quantity) continue;
            for (const PixelFormat format : {PixelFormat::half_float, PixelFormat::single_float}) {
                for (const int size : fixed_sizes) {
                    Job job = sized(size);
                    job.x.kind = &kind;
                    add(CostFamily::fixed_size, std::to_string(size), std::move(job), format);
                }
            }
        }
    }

    void add_coarse_sum() {
        const Light& light = *lut_.job.light;
        CostCase& cost = add(CostFamily::mistake, "5 nm sum", sized(mistake_size), PixelFormat::half_float);
        std::function<Image<Xyz>()> colours =
            [job = cost.job, baseline = std::shared_ptr<const Baseline>(make_sum_baseline(light, 5))] {
                return bake_with(job, *baseline);
            };
        if (samples_spectra(cost.job.material.mechanism))
            colours = [job = sampled(cost.job, sum_nodes(light, 5))] { return bake(job); };
        cost.needs_sampling = false;
        cost.make = [&encoding = encoding_, colours = std::move(colours)] {
            Image<Rgb> image = encoding.to_rgb(colours());
            store(image, [&](double value) { return encoding.stored(value, PixelFormat::half_float); });
            return image;
        };
    }

    void add_mistakes() {
        add(CostFamily::mistake, "none of these", sized(mistake_size), PixelFormat::half_float);
        const Mechanism& mechanism = lut_.job.material.mechanism;
        if (samples_spectra(mechanism) || is_bare_palette()) add_coarse_sum();
        {
            CostCase& cost =
                add(CostFamily::mistake, "8-bit sRGB texture", sized(mistake_size), PixelFormat::half_float);
            cost.format = "8 bit";
            cost.bytes /= 2;
            cost.make = [&encoding = encoding_, job = without_facets(cost.job)] {
                Image<Rgb> image = encoding.to_rgb(bake(job));
                store(image, in_8_bits);
                return image;
            };
        }
        {
            CostCase& cost =
                add(CostFamily::mistake, "half texel missing", sized(mistake_size), PixelFormat::half_float);
            cost.fetch_at = [width = cost.job.width, height = cost.job.height](LutPoint point) {
                const auto shifted = [](double coordinate, int size) {
                    return size < 2 ? coordinate : std::clamp((coordinate * size - 0.5) / (size - 1), 0.0, 1.0);
                };
                return LutPoint{shifted(point.x, width), shifted(point.y, height)};
            };
        }
        if (!lut_.job.x.is_angle() || lut_.job.x.kind->quantity != Quantity::incidence) return;
        Job cosine = sized(mistake_size);
        const auto kinds = axis_kinds();
        cosine.x.kind =
            &*std::find_if(kinds.begin(), kinds.end(), [](const AxisKind& k) { return k.name == "cos_theta"; });
        add(CostFamily::mistake, "cosine axis", std::move(cosine), PixelFormat::half_float);
    }

    // As fine as the integrals, so that only the effect changes the colour.
    void add_effects() {
        const EffectSet named = effects_in(lut_.job);
        if (named.is_empty()) return;
        add(CostFamily::effect, "every effect", sized(integral_size), PixelFormat::single_float);
        for (const EffectRow& row : effect_rows()) {
            if (!named.has(row.effect)) continue;
            CostCase& cost = add(CostFamily::effect, "without " + std::string(row.name), sized(integral_size),
                                 PixelFormat::single_float);
            cost.make = [&encoding = encoding_, job = without_effect(cost.job, row.effect)] {
                return stored_lut(job, PixelFormat::single_float, encoding);
            };
        }
    }

    void add_choices() {
        std::vector<double> all(bounds.begin(), bounds.end());
        if (std::find(all.begin(), all.end(), bound_) == all.end()) all.push_back(bound_);
        std::sort(all.begin(), all.end(), std::greater<>());
        for (const double bound : all) {
            lut_.request.max_de00 = bound;
            const ChosenLut chosen = choose_lut(lut_, encoding_, after_step_);
            CostCase& cost = add(CostFamily::choice, number_text(bound), chosen.lut.job, chosen.lut.format);
            cost.bound = cost.sampled_for = bound;
            cost.is_reached = chosen.is_reached;
            cost.predicted = chosen.predicted.total;
        }
    }

    PlannedLut lut_;
    const Encoding& encoding_;
    double bound_;
    const AfterRow& after_step_;
    int height_ = 1;
    std::vector<CostCase> cases_;
};

}  // namespace

std::vector<CostCase> cost_cases(const PlannedLut& lut, const Encoding& encoding, double bound,
                                 const AfterRow& after_step) {
    return Cases(lut, encoding, bound, after_step).all();
}

Image<Rgb> stored_lut(const Job& job, PixelFormat format, const Encoding& encoding) {
    Image<Rgb> image = encoding.to_rgb(bake(job));
    store(image, [&](double value) { return encoding.stored(value, format); });
    return image;
}

}  // namespace nacre
