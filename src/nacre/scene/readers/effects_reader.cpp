// The keys that refine every mechanism. Which of them have a meaning for which mechanism is in the mechanisms' rows.
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/readers/base_reader.h"
#include "nacre/scene/readers/index_keys.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_tilt{0.0, 60.0, "degrees"};  // shadows are left out (facets.h); beyond this they rule
constexpr Allowed allowed_roughness{0.0, 1.0};
constexpr Allowed allowed_base_reflectance{0.0, 1.0};

struct PolarisationChoice {
    Polarisation polarisation;
    bool both;
    friend bool operator==(const PolarisationChoice&, const PolarisationChoice&) = default;
};
constexpr std::array polarisation_words{
    Word<PolarisationChoice>{"mean", {Polarisation::mean, false}, "unpolarised light"},
    Word<PolarisationChoice>{"s", {Polarisation::s, false}, "electric field across the plane of light and eye"},
    Word<PolarisationChoice>{"p", {Polarisation::p, false}, "electric field in the plane of light and eye"},
    Word<PolarisationChoice>{"both", {Polarisation::mean, true}, "a LUT of s and a LUT of p"},
};

// A key that refines some mechanisms, and where their rows refuse it.
struct EffectKey {
    std::string_view key;
    Refusal EffectRefusals::*refusal;
};
constexpr std::array effect_keys{
    EffectKey{"base", &EffectRefusals::base},
    EffectKey{"tilt_deg", &EffectRefusals::facets},
    EffectKey{"roughness", &EffectRefusals::facets},
    EffectKey{"polarisation", &EffectRefusals::polarisation},
    EffectKey{"thickness_spread_nm", &EffectRefusals::thickness_spread_nm},
    EffectKey{"orders", &EffectRefusals::orders},
};

std::string mechanisms_that_know(const EffectKey& key) {
    std::vector<std::string> known;
    const std::vector<std::string> names = mechanism_names();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if ((reader_at(i).refusals.*key.refusal).empty()) known.push_back(names[i]);
    }
    return comma_separated(known);
}

// A key that another mechanism knows is no misspelling: the message says why this one does not know it.
void refuse_others_keys(const Table& table, const Mechanism& mechanism) {
    const EffectRefusals& refusals = reader_of(mechanism).refusals;
    for (const Table::Entry& entry : table.entries()) {
        for (const EffectKey& key : effect_keys) {
            const Refusal& refusal = refusals.*key.refusal;
            if (key.key != entry.key || refusal.empty()) continue;
            entry.read = true;
            table.note(entry.key_where, entry.key + " has no meaning for mechanism " +
                                            std::string(mechanism_name(mechanism)) + ", " + std::string(refusal) +
                                            "; allowed for " + mechanisms_that_know(key));
        }
    }
}

// Light that goes down to a base must come back through the substrate, whose thickness nobody gives.
void check_substrate(const Table& table, const Mechanism& mechanism, const IndexReader& index) {
    const auto substrate_of = reader_of(mechanism).substrate;
    if (substrate_of == nullptr) return;
    const double k = largest_k(substrate_of(mechanism), index.first_nm, index.last_nm);
    if (k <= transparent_k) return;
    table.note_at("base", "base lies below a substrate that absorbs, k = " + significant_text(k, 4) +
                              ", so nothing comes back from it; give a substrate with k up to " +
                              number_text(transparent_k));
}

Relief read_relief(const Table& table) {
    Relief relief;
    relief.tilt_deg = table.number_or("tilt_deg", allowed_tilt, 0.0);
    relief.roughness = table.number_or("roughness", allowed_roughness, 0.0);
    if (relief.tilt_deg > 0.0 && relief.roughness > 0.0)
        table.note_at("roughness", std::string(two_reliefs) + "; remove one of them");
    return relief;
}

}  // namespace

Effects read_effects(const Table& table, const Mechanism& mechanism, const SceneContext& context) {
    refuse_others_keys(table, mechanism);
    const EffectRefusals& refusals = reader_of(mechanism).refusals;
    Effects effects;
    if (refusals.base.empty()) effects.base = read_base(table, context);
    if (effects.base) check_substrate(table, mechanism, context.index);
    if (refusals.facets.empty()) effects.relief = read_relief(table);
    if (refusals.polarisation.empty()) {
        const auto choice = read_word(table, "polarisation", "polarisation", polarisation_words);
        effects.polarisation = choice.polarisation;
        effects.both_polarisations = choice.both;
    }
    return effects;
}

std::vector<Parameter> effect_parameters(const Mechanism& mechanism) {
    std::vector<Parameter> parameters;
    if (reader_of(mechanism).refusals.facets.empty()) {
        parameters.push_back({"tilt_deg", "tilt of the facets", allowed_tilt,
                              [](Mechanism& m, double value) { m.effects.relief.tilt_deg = value; }});
        parameters.push_back({"roughness", "roughness", allowed_roughness,
                              [](Mechanism& m, double value) { m.effects.relief.roughness = value; }});
    }
    const auto& base = mechanism.effects.base;
    if (base && std::holds_alternative<GreyBase>(*base)) {
        parameters.push_back({"base.reflectance", "reflectance of the base", allowed_base_reflectance,
                              [](Mechanism& m, double value) { m.effects.base = GreyBase{value}; }});
    }
    return parameters;
}

std::string effects_toml(const Effects& effects) {
    std::string text;
    if (effects.base) text += "base = " + base_toml(*effects.base) + "\n";
    const Relief& relief = effects.relief;
    if (relief.tilt_deg > 0.0) text += "tilt_deg = " + number_text(relief.tilt_deg) + "\n";
    if (relief.roughness > 0.0) text += "roughness = " + number_text(relief.roughness) + "\n";
    const std::string_view choice = name_of(polarisation_words, {effects.polarisation, effects.both_polarisations});
    if (choice != polarisation_words.front().name) text += "polarisation = " + toml_string(choice) + "\n";
    return text;
}

}  // namespace nacre
