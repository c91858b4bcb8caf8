#include "cli/report.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "nacre/base/text.h"
#include "nacre/lut/formats.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/catalogue.h"

namespace nacre {

std::string short_number(double value) {
    if (value == 0.0 || !std::isfinite(value)) return number_text(value);
    std::array<char, 32> text{};
    if (std::abs(value) < 1e-5) {
        std::snprintf(text.data(), text.size(), "%.1e", value);
        return text.data();
    }
    const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

std::string duration_text(double seconds) {
    if (seconds < 1e-3) return short_number(seconds * 1e6) + " us";
    return seconds < 1.0 ? short_number(seconds * 1e3) + " ms" : short_number(seconds) + " s";
}

std::string space_text(const ColourSpace& space, const LoadedScene& scene) {
    return space.name() + " (config " + scene.source.name + ")";
}

std::string width_text(const Job& job) {
    if (job.width <= largest_lut_size) return {};
    return "wider than " + std::to_string(largest_lut_size) + ", which is more than some phones and browsers take";
}

Json work_json(const Work& work) {
    Json effects = Json::object();
    for (const EffectRow& row : effect_rows()) {
        const EffectWork& effect = work.effects[static_cast<std::size_t>(row.effect)];
        if (effect == EffectWork{}) continue;
        effects[row.name] = {{"spectra", effect.spectra},
                             {"layers", effect.layers},
                             {"points", effect.points},
                             {"polarisations", effect.polarisations}};
    }
    return {{"exact_integrals", work.exact_integrals},
            {"spectra", work.spectra},
            {"samples", work.samples},
            {"texels", work.texels},
            {"probes", work.probes},
            {"references", work.references},
            {"effects", effects}};
}

}  // namespace nacre
