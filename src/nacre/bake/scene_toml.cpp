#include "nacre/bake/plan.h"
#include "nacre/bake/text.h"

namespace nacre {

std::string scene_toml(const PlannedLut& lut, const ColourSettings& colour) {
    const Job& job = lut.job;
    std::string text = "nacre = 1\n\n" + light_toml(job.light->settings);
    text += "\n[colour]\nspace = " + toml_string(colour.space) +
            "\ngamut = " + toml_string(name_of(gamut_words, colour.gamut)) + "\n";
    text += "\n[accuracy]\n";
    if (lut.wish.has_bound) text += "max_de00 = " + number_text(lut.wish.max_de00) + "\n";
    const bool is_sampled = needs_sampling(job.material.mechanism);
    if (job.light->settings.wavelengths) {
        text += "wavelengths = " + std::to_string(*job.light->settings.wavelengths) + "\n";
    } else if (!is_sampled) {
        text += "integral = " + toml_string(name_of(integral_words, job.integral)) + "\n";
    } else if (job.sampling.is_decided()) {
        const NodeCounts counts = job.sampling.node_counts();
        std::string list;
        for (const int count : counts) list += (list.empty() ? "" : ", ") + std::to_string(count);
        text += "nodes = [" + list + "]\n";
    }
    if (is_sampled && job.sampling.realisations > 1)
        text += "realisations = " + std::to_string(job.sampling.realisations) + "\n";
    text += "\n[material." + toml_string(job.material.name) + "]\n" + mechanism_toml(job.material.mechanism);
    text += "\n[lut." + toml_string(lut.name) + "]\nmaterial = " + toml_string(job.material.name) +
            "\nx = " + axis_toml(job.x) + "\n";
    if (job.y) text += "y = " + axis_toml(*job.y) + "\n";
    const bool has_angle = job.x.is_angle() || (job.y && job.y->is_angle());
    if (!has_angle) text += "angle_deg = " + number_text(job.angle_deg) + "\n";
    text += job.y ? "size = [" + std::to_string(job.width) + ", " + std::to_string(job.height) + "]\n"
                  : "size = " + std::to_string(job.width) + "\n";
    text += "format = " + toml_string(name_of(format_words, lut.format)) + "\n";
    return text;
}

}  // namespace nacre
