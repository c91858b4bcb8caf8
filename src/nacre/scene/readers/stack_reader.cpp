// A stack of layers on a substrate, written out (form = "layers") or as lamellae: films of one index with gaps between.
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "nacre/base/text.h"
#include "nacre/scene/catalogue.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/index_keys.h"
#include "nacre/scene/readers/layers_reader.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_films{1, 50000};
// Chosen: limits on the work that one scene may ask for. An irregular stack is computed hundreds of times.
constexpr double most_layers = 100000;
constexpr double most_irregular_layers = 1000;

// Where lamellae are looked for: those of beetles, butterflies and fish.
constexpr FreeRange usual_gap{1.0, 2.6};
constexpr FreeRange usual_lamella{20.0, 400.0};
constexpr FreeRange usual_films{1.0, 40.0, FreeScale::whole};

enum class StackForm { layers, lamellae };
constexpr std::array form_words{
    Word<StackForm>{"layers", StackForm::layers, "every layer written out"},
    Word<StackForm>{"lamellae", StackForm::lamellae, "films of one index with gaps between"},
};

// Sun's biological multilayer: films of one index with air between them.
std::vector<Layer> read_lamellae(const Table& table, const IndexReader& reader) {
    // So that one that is missing is not taken for the misspelling of another.
    for (const std::string_view known : {"film", "film_nm", "gap", "gap_nm", "films"}) table.find(known);
    Layer film;
    film.index = read_required_index(table, "film", reader);
    film.thickness_nm = read_thickness(table, "film_nm");
    Layer gap;
    gap.index = reader.read_or(table, "gap", Index(1.0));
    gap.thickness_nm = read_thickness(table, "gap_nm");
    Layer group;
    group.repeat = table.integer_or("films", allowed_films, 10);
    group.layers = {film, gap};
    return {group};
}

std::vector<Layer> read_form(const Table& table, const IndexReader& index, StackForm form, FreeReader* free) {
    if (form == StackForm::lamellae) return read_lamellae(table, index);
    const Value* layers = table.find("layers");
    if (layers == nullptr) {
        table.note_missing(
            "layers",
            "give [ { index, thickness_nm }, ... ] in the order in which light meets them, or [] for a bare surface");
        return {};
    }
    std::vector<Layer> read;
    attempt(table, layers->where, [&] { read = read_layers(table, *layers, index, free); });
    return read;
}

bool has_range(const Table& table, std::string_view key) {
    const Value* value = table.find(key);
    return value != nullptr && range_of(table, key, *value) != nullptr;
}

// @param free  of a search; null: everything is given
Stack stack_of(const Table& table, const IndexReader& index, FreeReader* free) {
    Stack stack;
    stack.incident = read_incident(table, index);
    const Value* word = table.find("form");
    const StackForm form = word == nullptr
                               ? StackForm::layers
                               : meaning_of(form_words, "form", table.checked_text("form", *word), table, word->where);
    stack.layers = read_form(table, index, form, free);
    if (free == nullptr || !has_range(table, "substrate"))
        stack.substrate = index.read_or(table, "substrate", stack.incident);
    stack.thickness_spread_nm = read_spread(table);
    const double layers = expanded_layers(stack.layers);
    const double most = stack.thickness_spread_nm > 0.0 ? most_irregular_layers : most_layers;
    if (layers > most && table.is_good()) {
        table.note_at(form == StackForm::lamellae ? "films" : "layers",
                      "the stack has " + limit_text(layers) + " layers, repeats counted; allowed " + limit_text(most) +
                          (most == most_layers ? "" : " with thickness_spread_nm"));
    }
    return stack;
}

ReadMechanism read_stack(const Table& table, const SceneContext& context) {
    return {stack_of(table, context.index, nullptr)};
}

Layer& lamella(Mechanism& mechanism, std::size_t which) {
    return std::get<Stack>(mechanism).layers.front().layers[which];
}

void read_free_substrate(FreeReader& reader) {
    reader.index("substrate", usual_substrate,
                 [](Mechanism& m, const Index& value) { std::get<Stack>(m).substrate = value; });
}

void read_free_lamellae(FreeReader& reader, bool is_irregular) {
    reader.index("film", usual_index, [](Mechanism& m, const Index& value) { lamella(m, 0).index = value; });
    reader.number("film_nm", allowed_thickness, usual_lamella,
                  [](Mechanism& m, double value) { lamella(m, 0).thickness_nm = value; });
    reader.index("gap", usual_gap, [](Mechanism& m, const Index& value) { lamella(m, 1).index = value; });
    reader.number("gap_nm", allowed_thickness, usual_lamella,
                  [](Mechanism& m, double value) { lamella(m, 1).thickness_nm = value; });
    reader.exchange({{"film", "gap"}, {"film_nm", "gap_nm"}});
    const Allowed allowed = is_irregular ? Allowed{1, most_irregular_layers / 2} : allowed_films;
    reader.whole_number("films", allowed, usual_films,
                        [](Mechanism& m, int value) { std::get<Stack>(m).layers.front().repeat = value; });
    read_free_substrate(reader);
}

// Layers, of which any number may be free; or lamellae: two materials, their thicknesses, how often they repeat.
MechanismSearch stack_search(const Table& table, const IndexReader& index) {
    MechanismSearch search;
    if (table.find("layers") != nullptr) {
        FreeReader reader(table, index, search);
        search.start = stack_of(table, index, &reader);
        if (has_range(table, "substrate")) read_free_substrate(reader);
        return search;
    }
    if (table.text_or("form", "lamellae") != "lamellae") {
        table.fail_at("form",
                      "picks lead to lamellae of two alternating materials; give form = \"lamellae\", or all layers");
    }
    Stack stack;
    stack.incident = read_incident(table, index);
    stack.layers.resize(1);
    stack.layers.front().repeat = 1;
    stack.layers.front().layers.resize(2);
    stack.thickness_spread_nm = read_spread(table);
    search.start = stack;
    FreeReader reader(table, index, search);
    read_free_lamellae(reader, stack.thickness_spread_nm > 0.0);
    return search;
}

std::vector<Parameter> stack_parameters(const Mechanism& mechanism) {
    const auto& stack = std::get<Stack>(mechanism);
    std::vector<Parameter> parameters;
    if (expanded_layers(stack.layers) <= most_irregular_layers) {
        parameters.push_back({"thickness_spread_nm", "spread of the thicknesses", allowed_spread,
                              [](Mechanism& m, double value) { std::get<Stack>(m).thickness_spread_nm = value; }});
    }
    add_index_parameters(
        "substrate.", " of the substrate", stack.substrate,
        [](Mechanism& m) -> Index& { return std::get<Stack>(m).substrate; }, parameters);
    add_layer_parameters(stack.layers, parameters);
    return parameters;
}

std::string stack_toml(const Mechanism& mechanism) {
    const auto& stack = std::get<Stack>(mechanism);
    std::string text = "mechanism = \"stack\"\nincident = " + index_toml(stack.incident) +
                       "\nlayers = " + layers_toml(stack.layers) + "\nsubstrate = " + index_toml(stack.substrate) +
                       "\n";
    if (stack.thickness_spread_nm > 0.0)
        text += "thickness_spread_nm = " + number_text(stack.thickness_spread_nm) + "\n";
    return text;
}

const Index& stack_substrate(const Mechanism& mechanism) {
    return std::get<Stack>(mechanism).substrate;
}

}  // namespace

const MechanismReader stack_reader{
    .read = read_stack,
    .search = stack_search,
    .parameters = stack_parameters,
    .toml = stack_toml,
    .substrate = stack_substrate,
    .warning = nullptr,
    .check_axis = nullptr,
    .refusals = {.base = not_refused,
                 .facets = not_refused,
                 .polarisation = not_refused,
                 .thickness_spread_nm = not_refused,
                 .orders = no_orders},
};

}  // namespace nacre
