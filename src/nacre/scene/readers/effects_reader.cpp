#include <array>
#include <cstddef>
#include <utility>

#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/readers/base_reader.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_tilt{0.0, 60.0, "degrees"};
constexpr Allowed allowed_reflectance{0.0, 1.0};

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

constexpr std::size_t mechanism_count = std::variant_size_v<MechanismModel>;

// A key that refines some mechanisms and means nothing for others: why, in MechanismModel's order; empty: it is known.
struct EffectKey {
    std::string_view key;
    std::array<std::string_view, mechanism_count> refusal;
};
constexpr std::string_view no_orders = "which has no diffraction orders";
constexpr std::string_view no_transmission = "which does not say what it lets through";
// palette, film, stack, grating, crystal, scatter, measured
constexpr std::array effect_keys{
    EffectKey{"base",
              {no_transmission, "", "", "which lets nothing through", "", "which is only what its particles scatter",
               no_transmission}},
    EffectKey{
        "tilt_deg",
        {"", "", "", "whose colour does not depend on an angle to facets", "", "whose particles have no facets", ""}},
    EffectKey{"polarisation",
              {"which is of unpolarised light", "", "", "whose orders are of scalar theory", "", "",
               "which is of the light that it was measured with"}},
    EffectKey{"thickness_spread_nm",
              {"which has no layers", "", "", "which has no layers", "",
               "which has no layers (radius_spread is of its particles)", "which was measured with its spread"}},
    EffectKey{"orders", {no_orders, no_orders, no_orders, "", no_orders, no_orders, no_orders}},
};

template <std::size_t... I>
std::array<std::string_view, mechanism_count> mechanism_names(std::index_sequence<I...>) {
    return {mechanism_name(std::variant_alternative_t<I, MechanismModel>())...};
}

bool is_known(std::string_view key, const Mechanism& mechanism) {
    for (const EffectKey& row : effect_keys) {
        if (row.key == key) return row.refusal[mechanism.index()].empty();
    }
    return false;
}

std::string mechanisms_that_know(const EffectKey& row) {
    const auto names = mechanism_names(std::make_index_sequence<mechanism_count>());
    std::vector<std::string> known;
    for (std::size_t i = 0; i < mechanism_count; ++i) {
        if (row.refusal[i].empty()) known.emplace_back(names[i]);
    }
    return comma_separated(known);
}

// A key that another mechanism knows is no misspelling: the message says why it is none of this one's.
void refuse_others_keys(const Table& table, const Mechanism& mechanism) {
    for (const Table::Entry& entry : table.entries()) {
        for (const EffectKey& row : effect_keys) {
            if (row.key != entry.key || is_known(row.key, mechanism)) continue;
            table.fail(entry.key_where,
                       entry.key + " means nothing for mechanism " + std::string(mechanism_name(mechanism)) + ", " +
                           std::string(row.refusal[mechanism.index()]) + "; known for " + mechanisms_that_know(row));
        }
    }
}

const Index* substrate_of(const Mechanism& mechanism) {
    if (const auto* film = std::get_if<Film>(&mechanism)) return &film->substrate;
    if (const auto* stack = std::get_if<Stack>(&mechanism)) return &stack->substrate;
    if (const auto* crystal = std::get_if<Crystal>(&mechanism)) return &crystal->substrate;
    return nullptr;
}

// Light that goes down to a base must come back through the substrate, whose thickness nobody gives.
void check_substrate(const Table& table, const Mechanism& mechanism, const IndexReader& index) {
    const Index* substrate = substrate_of(mechanism);
    if (substrate == nullptr) return;
    const double k = largest_k(*substrate, index.first_nm, index.last_nm);
    if (k <= transparent_k) return;
    table.fail_at("base", "base lies below a substrate that absorbs, k = " + significant_text(k, 4) +
                              ", so nothing comes back from it; allowed is a substrate with k up to " +
                              number_text(transparent_k));
}

}  // namespace

Effects read_effects(const Table& table, const Mechanism& mechanism, const SceneContext& context) {
    refuse_others_keys(table, mechanism);
    Effects effects;
    if (is_known("base", mechanism)) effects.base = read_base(table, context);
    if (effects.base) check_substrate(table, mechanism, context.index);
    if (is_known("tilt_deg", mechanism)) effects.tilt_deg = table.number_or("tilt_deg", allowed_tilt, 0.0);
    if (is_known("polarisation", mechanism)) {
        const auto choice = read_word(table, "polarisation", "polarisation", polarisation_words);
        effects.polarisation = choice.polarisation;
        effects.both_polarisations = choice.both;
    }
    return effects;
}

std::vector<Parameter> effect_parameters(const Mechanism& mechanism) {
    std::vector<Parameter> parameters;
    if (is_known("tilt_deg", mechanism)) {
        parameters.push_back({"tilt_deg", "tilt of the facets", allowed_tilt,
                              [](Mechanism& m, double value) { m.effects.tilt_deg = value; }});
    }
    const auto& base = mechanism.effects.base;
    if (base && std::holds_alternative<GreyBase>(*base)) {
        parameters.push_back({"base.reflectance", "reflectance of the base", allowed_reflectance,
                              [](Mechanism& m, double value) { m.effects.base = GreyBase{value}; }});
    }
    return parameters;
}

std::string effects_toml(const Effects& effects) {
    std::string text;
    if (effects.base) text += "base = " + base_toml(*effects.base) + "\n";
    if (effects.tilt_deg > 0.0) text += "tilt_deg = " + number_text(effects.tilt_deg) + "\n";
    const std::string_view choice = name_of(polarisation_words, {effects.polarisation, effects.both_polarisations});
    if (choice != polarisation_words.front().name) text += "polarisation = " + toml_string(choice) + "\n";
    return text;
}

}  // namespace nacre
