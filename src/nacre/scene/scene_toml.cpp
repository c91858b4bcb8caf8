#include "nacre/base/text.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/plan.h"
#include "nacre/scene/readers/axis_reader.h"
#include "nacre/scene/readers/light_reader.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/shade/integral.h"

namespace nacre {
namespace {

// Whatever else was chosen about effects, so that it is not chosen again.
std::string sampling_toml(const Job& job) {
    std::string text;
    const SpectralSampling& sampling = job.sampling;
    if (sampling.realisations > 1) text += "realisations = " + std::to_string(sampling.realisations) + "\n";
    if (std::holds_alternative<Crystal>(job.material.mechanism))
        text += "slices = " + std::to_string(sampling.slices) + "\n";
    const EffectSet effects = effects_in(job);
    if (effects.is_empty()) return text;
    const auto is_in = [&](Effect effect) { return effects.has(effect) && !job.without.has(effect); };
    if (is_in(Effect::base)) text += "base_directions = " + std::to_string(sampling.hemisphere) + "\n";
    if (is_in(Effect::size_spread)) text += "radii = " + std::to_string(sampling.sizes) + "\n";
    text += "effects = \"all\"\n";
    if (job.without.is_empty()) return text;
    std::string list;
    for (const EffectRow& row : effect_rows()) {
        if (job.without.has(row.effect)) list += (list.empty() ? "" : ", ") + toml_string(row.name);
    }
    return text + "without = [" + list + "]\n";
}

std::string fixed_toml(const Job& job) {
    switch (quantity_of(job.material.mechanism)) {
        case Quantity::grating_u:
            return "grating_u = " + number_text(job.fixed.grating_u) + "\n";
        case Quantity::cos_scatter:
            return "cos_scatter = " + number_text(job.fixed.cos_scatter) + "\n";
        case Quantity::incidence:
            break;
    }
    return "angle_deg = " + number_text(job.fixed.incidence.theta_deg) + "\n";
}

}  // namespace

std::string scene_toml(const PlannedLut& lut, const ColourSettings& colour) {
    const Job& job = lut.job;
    std::string text = "nacre = 1\n\n" + light_toml(job.light->settings);
    text += "\n[colour]\nspace = " + toml_string(colour.space) +
            "\ngamut = " + toml_string(name_of(gamut_words, colour.gamut)) + "\n";
    text += "\n[accuracy]\n";
    if (lut.wish.has_bound) text += "max_de00 = " + number_text(lut.wish.max_de00) + "\n";
    const bool is_palette = std::holds_alternative<Palette>(job.material.mechanism);
    if (job.light->settings.wavelengths) {
        text += "wavelengths = " + std::to_string(*job.light->settings.wavelengths) + "\n";
    } else if (is_palette) {
        text += "integral = " + toml_string(name_of(integral_words, job.integral)) + "\n";
    } else if (samples_spectra(job.material.mechanism) && job.sampling.is_decided()) {
        const NodeCounts counts = job.sampling.node_counts();
        std::string list;
        for (const int count : counts) list += (list.empty() ? "" : ", ") + std::to_string(count);
        text += "nodes = [" + list + "]\n";
    }
    text += sampling_toml(job);
    text += "\n[material." + toml_string(job.material.name) + "]\n" + mechanism_toml(job.material.mechanism);
    text += "\n[lut." + toml_string(lut.name) + "]\nmaterial = " + toml_string(job.material.name) +
            "\nx = " + axis_toml(job.x) + "\n";
    if (job.y) text += "y = " + axis_toml(*job.y) + "\n";
    const bool has_angle = job.x.is_angle() || (job.y && job.y->is_angle());
    if (!has_angle) text += fixed_toml(job);
    text += job.y ? "size = [" + std::to_string(job.width) + ", " + std::to_string(job.height) + "]\n"
                  : "size = " + std::to_string(job.width) + "\n";
    text += "format = " + toml_string(name_of(format_words, lut.format)) + "\n";
    return text;
}

}  // namespace nacre
