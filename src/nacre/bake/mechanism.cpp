#include "nacre/bake/mechanism.h"

#include <array>

#include "nacre/bake/mechanism_readers.h"
#include "nacre/bake/names.h"

namespace nacre {
namespace {

// One row per mechanism: its name in a scene and how it is read.
struct MechanismRow {
    std::string_view name;
    Mechanism (*read)(const Table&, const IndexReader&);
};
constexpr std::array mechanism_rows{
    MechanismRow{"palette", [](const Table& table, const IndexReader&) -> Mechanism { return read_palette(table); }},
    MechanismRow{"film",
                 [](const Table& table, const IndexReader& index) -> Mechanism { return read_film(table, index); }},
    MechanismRow{"stack",
                 [](const Table& table, const IndexReader& index) -> Mechanism { return read_stack(table, index); }},
};

static_assert(mechanism_rows.size() == std::variant_size_v<Mechanism>, "one row per mechanism, in Mechanism's order");

}  // namespace

std::vector<Parameter> parameters_of(const Mechanism& mechanism) {
    struct Visitor {
        std::vector<Parameter> operator()(const Palette& palette) const { return palette_parameters(palette); }
        std::vector<Parameter> operator()(const Film& film) const { return film_parameters(film); }
        std::vector<Parameter> operator()(const Stack& stack) const { return stack_parameters(stack); }
    };
    return std::visit(Visitor{}, mechanism);
}

std::string_view mechanism_name(const Mechanism& mechanism) {
    return mechanism_rows[mechanism.index()].name;
}

Mechanism read_mechanism(const Table& table, const IndexReader& index) {
    const std::string name = table.text_or("mechanism", mechanism_rows.front().name);
    std::vector<std::string> known;
    for (const MechanismRow& row : mechanism_rows) {
        if (row.name == name) return row.read(table, index);
        known.emplace_back(row.name);
    }
    table.fail_at("mechanism", "unknown mechanism " + in_quotes(name) + "; known: " + comma_separated(known));
}

std::string mechanism_toml(const Mechanism& mechanism) {
    struct Visitor {
        std::string operator()(const Palette& palette) const { return palette_toml(palette); }
        std::string operator()(const Film& film) const { return film_toml(film); }
        std::string operator()(const Stack& stack) const { return stack_toml(stack); }
    };
    return std::visit(Visitor{}, mechanism);
}

}  // namespace nacre
