#include "nacre/lut/job.h"

#include <variant>

#include "nacre/base/words.h"
#include "nacre/optics/crystal.h"
#include "nacre/optics/palette.h"

namespace nacre {

Mechanism mechanism_at(const Job& job, double x, double y) {
    Mechanism mechanism = job.material.mechanism;
    if (!job.x.is_angle()) job.x.parameter.set(mechanism, job.x.parameter_value(x));
    if (job.y && !job.y->is_angle()) job.y->parameter.set(mechanism, job.y->parameter_value(y));
    return mechanism;
}

Mechanism simulated_at(const Job& job, double x, double y) {
    Mechanism mechanism = mechanism_at(job, x, y);
    remove(job.without, mechanism, job.light->settings.first_nm);
    return mechanism;
}

Geometry geometry_at(const Job& job, double x, double y) {
    if (job.x.is_angle()) return job.x.kind->geometry(x);
    if (job.y && job.y->is_angle()) return job.y->kind->geometry(y);
    return job.fixed;
}

EffectSet effects_in(const Job& job) {
    const double first_nm = job.light->settings.first_nm;
    EffectSet found;
    for (const double x : {0.0, 1.0}) {
        for (const double y : {0.0, 1.0}) {
            const Mechanism here = mechanism_at(job, x, y);
            for (const EffectRow& row : effect_rows()) {
                if (row.is_in(here, first_nm)) found.insert(row.effect);
            }
            if (!job.moves_material()) return found;
        }
    }
    return found;
}

std::string size_text(const Job& job) {
    return std::to_string(job.width) + " x " + std::to_string(job.height);
}

namespace {

// "48 nodes", "48/64 nodes", "471 wavelengths"; what is the same in all bands is said once.
std::string nodes_text(const Job& job) {
    if (job.light->settings.wavelengths) return std::to_string(*job.light->settings.wavelengths) + " wavelengths";
    std::string counts;
    int last = 0;
    for (const int count : job.sampling.counts().nodes) {
        if (count != last) counts += (counts.empty() ? "" : "/") + std::to_string(count);
        last = count;
    }
    return counts + " nodes";
}

}  // namespace

std::string integration_text(const Job& job) {
    const Mechanism& mechanism = job.material.mechanism;
    const bool is_sampled = samples_spectra(mechanism) || job.light->settings.wavelengths;
    std::string text = is_sampled ? nodes_text(job) : "exact";
    if (job.sampling.thickness_samples > 1) text += " x " + std::to_string(job.sampling.thickness_samples);
    if (is_sampled && std::holds_alternative<Crystal>(mechanism))
        text += " x " + std::to_string(job.sampling.slices) + " slices";
    if (job.sampling.radii > 1) text += " x " + std::to_string(job.sampling.radii) + " radii";
    return text;
}

}  // namespace nacre
