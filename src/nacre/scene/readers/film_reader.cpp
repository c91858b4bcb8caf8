// A film: one layer on a substrate.
#include "nacre/base/text.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/index_keys.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

// Where thicknesses are looked for. Thicker films show so many orders that they look white.
constexpr FreeRange usual_thickness{0.0, 1500.0};

ReadMechanism read_film(const Table& table, const SceneContext& context) {
    const IndexReader& index = context.index;
    Film film;
    film.incident = read_incident(table, index);
    film.index = read_required_index(table, "index", index);
    film.thickness_nm = read_thickness(table, "thickness_nm");
    film.substrate = index.read_or(table, "substrate", film.incident);
    film.thickness_spread_nm = read_spread(table);
    return {film};
}

std::vector<Parameter> film_parameters(const Mechanism& mechanism) {
    const auto& film = std::get<Film>(mechanism);
    std::vector<Parameter> parameters;
    parameters.push_back({"thickness_nm", "thickness", allowed_thickness,
                          [](Mechanism& m, double value) { std::get<Film>(m).thickness_nm = value; }});
    parameters.push_back({"thickness_spread_nm", "spread of the thickness", allowed_spread,
                          [](Mechanism& m, double value) { std::get<Film>(m).thickness_spread_nm = value; }});
    add_index_parameters(
        "", "", film.index, [](Mechanism& m) -> Index& { return std::get<Film>(m).index; }, parameters);
    add_index_parameters(
        "substrate.", " of the substrate", film.substrate,
        [](Mechanism& m) -> Index& { return std::get<Film>(m).substrate; }, parameters);
    return parameters;
}

std::string film_toml(const Mechanism& mechanism) {
    const auto& film = std::get<Film>(mechanism);
    std::string text = "mechanism = \"film\"\nincident = " + index_toml(film.incident) +
                       "\nindex = " + index_toml(film.index) + "\nthickness_nm = " + number_text(film.thickness_nm) +
                       "\nsubstrate = " + index_toml(film.substrate) + "\n";
    if (film.thickness_spread_nm > 0.0) text += "thickness_spread_nm = " + number_text(film.thickness_spread_nm) + "\n";
    return text;
}

MechanismSearch film_search(const Table& table, const IndexReader& index) {
    MechanismSearch search;
    Film film;
    film.incident = read_incident(table, index);
    film.thickness_spread_nm = read_spread(table);
    search.start = film;
    FreeReader reader(table, index, search);
    reader.index("index", usual_index, [](Mechanism& m, const Index& value) { std::get<Film>(m).index = value; });
    reader.number("thickness_nm", allowed_thickness, usual_thickness,
                  [](Mechanism& m, double value) { std::get<Film>(m).thickness_nm = value; });
    reader.index("substrate", usual_substrate,
                 [](Mechanism& m, const Index& value) { std::get<Film>(m).substrate = value; });
    return search;
}

const Index& film_substrate(const Mechanism& mechanism) {
    return std::get<Film>(mechanism).substrate;
}

}  // namespace

const MechanismReader film_reader{
    .read = read_film,
    .search = film_search,
    .parameters = film_parameters,
    .toml = film_toml,
    .substrate = film_substrate,
    .warning = nullptr,
    .check_axis = nullptr,
    .refusals = {.base = not_refused,
                 .facets = not_refused,
                 .polarisation = not_refused,
                 .thickness_spread_nm = not_refused,
                 .orders = no_orders},
};

}  // namespace nacre
