#include "nacre/scene/readers/mechanism_reader.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "nacre/base/names.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

// One row per mechanism, in MechanismModel's order: how it is read, and how it is looked for if there are picks.
struct MechanismReader {
    Mechanism (*read)(const Table&, const SceneContext&);
    MechanismSearch (*search)(const Table&, const IndexReader&) = nullptr;
};
constexpr std::array mechanism_readers{
    MechanismReader{
        [](const Table& table, const SceneContext& context) -> Mechanism { return read_palette(table, context); }},
    MechanismReader{
        [](const Table& table, const SceneContext& context) -> Mechanism { return read_film(table, context.index); },
        film_search},
    MechanismReader{
        [](const Table& table, const SceneContext& context) -> Mechanism { return read_stack(table, context.index); },
        stack_search},
    MechanismReader{
        [](const Table& table, const SceneContext& context) -> Mechanism { return read_grating(table, context.index); },
        grating_search},
    MechanismReader{
        [](const Table& table, const SceneContext& context) -> Mechanism { return read_crystal(table, context.index); },
        crystal_search},
    MechanismReader{[](const Table& table, const SceneContext& context) -> Mechanism {
        return read_scatter(table, context.index);
    }},
    MechanismReader{[](const Table& table, const SceneContext& context) -> Mechanism {
        return read_measured(table, context.read_spectra);
    }},
};

static_assert(mechanism_readers.size() == std::variant_size_v<MechanismModel>, "one row per mechanism");

// Table::find() would offer the key for misspellings of others.
bool has_picks(const Table& table) {
    return std::any_of(table.entries().begin(), table.entries().end(),
                       [](const Table::Entry& entry) { return entry.key == "picks"; });
}

}  // namespace

std::vector<Parameter> parameters_of(const Mechanism& mechanism) {
    struct Visitor {
        std::vector<Parameter> operator()(const Palette& palette) const { return palette_parameters(palette); }
        std::vector<Parameter> operator()(const Film& film) const { return film_parameters(film); }
        std::vector<Parameter> operator()(const Stack& stack) const { return stack_parameters(stack); }
        std::vector<Parameter> operator()(const Grating& grating) const { return grating_parameters(grating); }
        std::vector<Parameter> operator()(const Crystal& crystal) const { return crystal_parameters(crystal); }
        std::vector<Parameter> operator()(const Scatter& scatter) const { return scatter_parameters(scatter); }
        std::vector<Parameter> operator()(const MeasuredSpectra&) const { return {}; }
    };
    std::vector<Parameter> parameters = std::visit(Visitor{}, mechanism);
    // Light has to get through the substrate to a base.
    if (mechanism.effects.base) {
        std::erase_if(parameters, [](const Parameter& parameter) { return parameter.name == "substrate.k"; });
    }
    for (Parameter& parameter : effect_parameters(mechanism)) parameters.push_back(std::move(parameter));
    return parameters;
}

Mechanism read_mechanism(const Table& table, const SceneContext& context) {
    const std::vector<std::string> names = mechanism_names();
    const std::string name = table.text_or("mechanism", names.front());
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        table.fail_at("mechanism", "unknown mechanism " + in_quotes(name) + "; known: " + comma_separated(names));
    }
    const MechanismReader& reader = mechanism_readers[static_cast<std::size_t>(found - names.begin())];
    if (reader.search != nullptr && has_picks(table)) {
        MechanismSearch search = reader.search(table, context.index);
        search.start.effects = read_effects(table, search.start, context);
        return find_mechanism(table, context, std::move(search));
    }
    if (reader.search == nullptr && found != names.begin() && has_picks(table)) {
        table.fail_at("picks", "picks mean nothing for " + name + "; known for palette, film, stack, grating, crystal");
    }
    Mechanism mechanism = reader.read(table, context);
    mechanism.effects = read_effects(table, mechanism, context);
    return mechanism;
}

std::string mechanism_toml(const Mechanism& mechanism) {
    struct Visitor {
        std::string operator()(const Palette& palette) const { return palette_toml(palette); }
        std::string operator()(const Film& film) const { return film_toml(film); }
        std::string operator()(const Stack& stack) const { return stack_toml(stack); }
        std::string operator()(const Grating& grating) const { return grating_toml(grating); }
        std::string operator()(const Crystal& crystal) const { return crystal_toml(crystal); }
        std::string operator()(const Scatter& scatter) const { return scatter_toml(scatter); }
        std::string operator()(const MeasuredSpectra& spectra) const { return measured_toml(spectra); }
    };
    return std::visit(Visitor{}, mechanism) + effects_toml(mechanism.effects);
}

}  // namespace nacre
