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

namespace nacre {
namespace {

// What was chosen about effects, so that it is not chosen again.
std::string effects_toml(const Job& job) {
    if (effects_in(job).is_empty()) return {};
    std::string list;
    for (const EffectRow& row : effect_rows()) {
        if (job.without.has(row.effect)) list += (list.empty() ? "" : ", ") + toml_string(row.name);
    }
    return "effects = \"all\"\n" + (list.empty() ? std::string{} : "without = [" + list + "]\n");
}

std::string nodes_toml(const NodeCounts& nodes) {
    std::string list;
    for (const int count : nodes) list += (list.empty() ? "" : ", ") + std::to_string(count);
    return "nodes = [" + list + "]\n";
}

// How many points were chosen for the sums that the job has; nothing if it has none.
std::string sampling_toml(const Job& job) {
    const SpectralSampling& sampling = job.sampling;
    const Mechanism& mechanism = job.material.mechanism;
    const EffectSet simulated = effects_in(job).minus(job.without);
    std::string text;
    const auto add = [&](std::string_view key, int count) {
        text += std::string(key) + " = " + std::to_string(count) + "\n";
    };
    if (!job.light->settings.wavelengths && samples_spectra(mechanism) && sampling.is_decided())
        text += nodes_toml(sampling.counts().nodes);
    if (sampling.thickness_samples > 1) add("thickness_samples", sampling.thickness_samples);
    if (std::holds_alternative<Crystal>(mechanism)) add("slices", sampling.slices);
    if (simulated.has(Effect::base)) add("base_directions", sampling.base_directions);
    if (simulated.has(Effect::size_spread)) add("radii", sampling.radii);
    return text.empty() ? text : "\n[accuracy.sampling]\n" + text;
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

std::string scene_toml(const PlannedLut& lut) {
    const Job& job = lut.job;
    std::string text = "nacre = 1\n\n" + light_toml(job.light->settings);
    text += "\n[colour]\nspace = " + toml_string(lut.colour.space) +
            "\ngamut = " + toml_string(name_of(gamut_words, lut.colour.gamut)) + "\n";
    text += "\n[accuracy]\n";
    if (lut.request.has_bound) text += "max_de00 = " + number_text(lut.request.max_de00) + "\n";
    if (const auto& wavelengths = job.light->settings.wavelengths)
        text += "wavelengths = " + std::to_string(*wavelengths) + "\n";
    text += effects_toml(job);
    text += sampling_toml(job);
    text += "\n[material." + toml_string(job.material.name) + "]\n" + mechanism_toml(job.material.mechanism);
    text += "\n[lut." + toml_string(lut.name) + "]\nmaterial = " + toml_string(job.material.name) +
            "\nx = " + axis_toml(job.x) + "\n";
    if (is_transmittance(job.material.mechanism)) text += "quantity = \"transmittance\"\n";
    if (job.y) text += "y = " + axis_toml(*job.y) + "\n";
    if (!job.has_angle()) text += fixed_toml(job);
    text += job.y ? "size = [" + std::to_string(job.width) + ", " + std::to_string(job.height) + "]\n"
                  : "size = " + std::to_string(job.width) + "\n";
    text += "format = " + toml_string(name_of(format_words, lut.format)) + "\n";
    return text;
}

}  // namespace nacre
