// Finds a material's mechanism, and lets that mechanism's own reader do the rest.
//
// A new mechanism has a reader file with its row (MechanismReader), and a line in row() below. The line is found by
// type: a mechanism without one does not compile, and the compiler's message names it.
#include "nacre/scene/readers/mechanism_reader.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "nacre/base/names.h"
#include "nacre/scene/readers/mechanism_readers.h"
#include "nacre/scene/readers/search_reader.h"

namespace nacre {
namespace {

template <typename Model>
constexpr const MechanismReader& row() {
    constexpr bool has_row = sizeof(Model) == 0;  // of no type
    static_assert(has_row, "this mechanism has no reader: give it a row in mechanism_reader.cpp");
    return palette_reader;
}
// clang-format off
template <> constexpr const MechanismReader& row<Palette>() { return palette_reader; }
template <> constexpr const MechanismReader& row<Film>() { return film_reader; }
template <> constexpr const MechanismReader& row<Stack>() { return stack_reader; }
template <> constexpr const MechanismReader& row<Grating>() { return grating_reader; }
template <> constexpr const MechanismReader& row<Crystal>() { return crystal_reader; }
template <> constexpr const MechanismReader& row<Scatter>() { return scatter_reader; }
template <> constexpr const MechanismReader& row<MeasuredSpectra>() { return measured_reader; }
// clang-format on

template <std::size_t... Index>
constexpr auto rows(std::index_sequence<Index...>) {
    return std::array{&row<std::variant_alternative_t<Index, MechanismModel>>()...};
}
constexpr auto all_readers = rows(std::make_index_sequence<std::variant_size_v<MechanismModel>>());

// Table::find() would offer the key for misspellings of others.
const Table::Entry* entry_of(const Table& table, std::string_view key) {
    const auto found = std::find_if(table.entries().begin(), table.entries().end(),
                                    [&](const Table::Entry& entry) { return entry.key == key; });
    return found == table.entries().end() ? nullptr : &*found;
}

bool has_picks(const Table& table) {
    return entry_of(table, "picks") != nullptr;
}

void refuse_tolerance(const Table& table) {
    const Table::Entry* tolerance = entry_of(table, "tolerance");
    if (tolerance == nullptr) return;
    tolerance->read = true;
    table.note(tolerance->key_where,
               "tolerance is of thicknesses that a search finds, and nothing is searched for here; give picks and a "
               "mechanism other than palette, or remove tolerance");
}

bool takes_picks(const MechanismReader& reader) {
    return reader.search != nullptr || &reader == &palette_reader;
}

}  // namespace

const MechanismReader& reader_at(std::size_t index) {
    return *all_readers[index];
}

const MechanismReader& reader_of(const Mechanism& mechanism) {
    return reader_at(mechanism.index());
}

std::vector<std::string> mechanisms_with_picks() {
    std::vector<std::string> known;
    const std::vector<std::string> names = mechanism_names();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (takes_picks(reader_at(i))) known.push_back(names[i]);
    }
    return known;
}

ReadMechanism read_mechanism(const Table& table, const SceneContext& context) {
    const std::vector<std::string> names = mechanism_names();
    const std::string name = table.text_or("mechanism", names.front());
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        table.fail_at("mechanism", "unknown mechanism " + in_quotes(name) + "; known: " + comma_separated(names));
    }
    const MechanismReader& reader = reader_at(static_cast<std::size_t>(found - names.begin()));
    if (reader.search != nullptr && has_picks(table)) {
        MechanismSearch search = reader.search(table, context.index);
        search.start.effects = read_effects(table, search.start, context);
        return find_mechanism(table, context, std::move(search));
    }
    if (!takes_picks(reader) && has_picks(table)) {
        table.fail_at("picks", "picks have no meaning for mechanism " + name + "; allowed for " +
                                   comma_separated(mechanisms_with_picks()));
    }
    refuse_tolerance(table);
    ReadMechanism read = reader.read(table, context);
    read.mechanism.effects = read_effects(table, read.mechanism, context);
    return read;
}

std::vector<Parameter> parameters_of(const Mechanism& mechanism) {
    const MechanismReader& reader = reader_of(mechanism);
    std::vector<Parameter> parameters;
    if (reader.parameters != nullptr) parameters = reader.parameters(mechanism);
    // Light has to get through the substrate to a base.
    if (mechanism.effects.base) {
        std::erase_if(parameters, [](const Parameter& parameter) {
            return parameter.name == "substrate.k" || parameter.name == "substrate.f0";
        });
    }
    for (Parameter& parameter : effect_parameters(mechanism)) parameters.push_back(std::move(parameter));
    return parameters;
}

std::string mechanism_toml(const Mechanism& mechanism) {
    return reader_of(mechanism).toml(mechanism) + effects_toml(mechanism.effects);
}

std::string mechanism_warning(const Mechanism& mechanism, const LightSettings& light) {
    const MechanismReader& reader = reader_of(mechanism);
    return reader.warning == nullptr ? "" : reader.warning(mechanism, light);
}

void check_axis(const Axis& axis, const Mechanism& mechanism, const Table& table, const Where& where) {
    const MechanismReader& reader = reader_of(mechanism);
    if (reader.check_axis != nullptr) reader.check_axis(axis, mechanism, table, where);
}

}  // namespace nacre
