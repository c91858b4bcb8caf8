// A crystal of spheres, such as an opal: planes of spheres in a medium.
#include <algorithm>
#include <cmath>

#include "nacre/base/text.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/index_keys.h"
#include "nacre/scene/readers/mechanism_readers.h"

namespace nacre {
namespace {

constexpr Allowed allowed_diameter{10.0, 1e5, "nm"};
constexpr Allowed allowed_spacing{1.0, 1e5, "nm"};
constexpr Allowed allowed_planes{1, 10000};
// Of spacing over diameter. Touching spheres have 0.816; opals that are pressed flat stay well above this.
constexpr double least_spacing = 0.6;

// Where crystals are looked for: opals and colloidal crystals whose first order is visible.
constexpr FreeRange usual_material{1.0, 2.6};
constexpr FreeRange usual_diameter{120.0, 600.0};
constexpr FreeRange usual_planes{1.0, 100.0, FreeScale::whole};

// What either axis may use of the room between spacing and its least, so that two together do not exceed it: half of
// it, on a scale of ratios.
double room_per_axis(const Crystal& crystal) {
    return std::sqrt(std::max(1.0, crystal.spacing_nm / (least_spacing * crystal.diameter_nm)));
}

ReadMechanism read_crystal(const Table& table, const SceneContext& context) {
    const IndexReader& index = context.index;
    Crystal crystal;
    crystal.incident = read_incident(table, index);
    crystal.sphere = read_required_index(table, "sphere", index);
    crystal.medium = index.read_or(table, "medium", Index(1.0));
    crystal.diameter_nm = table.number("diameter_nm", allowed_diameter);
    if (const Value* spacing = table.find("spacing_nm")) {
        crystal.spacing_nm = table.checked_number("spacing_nm", *spacing, allowed_spacing);
        const double least_nm = least_spacing * crystal.diameter_nm;
        if (crystal.spacing_nm < least_nm && table.is_good()) {
            table.note(spacing->where, "spacing_nm = " + spacing->text() + " is too small for spheres of " +
                                           number_text(crystal.diameter_nm) + " nm; give at least " +
                                           number_text(least_spacing) + " of diameter_nm, " +
                                           significant_text(least_nm, 10) + " nm");
        }
    }
    crystal.planes = table.integer_or("planes", allowed_planes, crystal.planes);
    crystal.substrate = index.read_or(table, "substrate", crystal.medium);
    crystal.thickness_spread_nm = read_spread(table);
    return {crystal};
}

MechanismSearch crystal_search(const Table& table, const IndexReader& index) {
    if (const Value* spacing = table.find("spacing_nm")) {
        table.note(spacing->where,
                   "picks lead to touching spheres, whose spacing is sqrt(2/3) of diameter_nm; remove spacing_nm");
    }
    MechanismSearch search;
    Crystal crystal;
    crystal.incident = read_incident(table, index);
    crystal.thickness_spread_nm = read_spread(table);
    // Below the crystal there is more of what is between its spheres, unless the scene says otherwise.
    const bool has_substrate = table.find("substrate") != nullptr;
    if (has_substrate) crystal.substrate = index.read_or(table, "substrate", crystal.medium);
    search.start = crystal;
    FreeReader reader(table, index, search);
    reader.index("sphere", usual_material,
                 [](Mechanism& m, const Index& value) { std::get<Crystal>(m).sphere = value; });
    reader.index("medium", usual_material, [has_substrate](Mechanism& m, const Index& value) {
        auto& found = std::get<Crystal>(m);
        found.medium = value;
        if (!has_substrate) found.substrate = value;
    });
    reader.exchange({{"sphere", "medium"}});
    reader.number("diameter_nm", allowed_diameter, usual_diameter,
                  [](Mechanism& m, double value) { std::get<Crystal>(m).diameter_nm = value; });
    reader.whole_number("planes", allowed_planes, usual_planes,
                        [](Mechanism& m, int value) { std::get<Crystal>(m).planes = value; });
    return search;
}

std::vector<Parameter> crystal_parameters(const Mechanism& mechanism) {
    const auto& crystal = std::get<Crystal>(mechanism);
    std::vector<Parameter> parameters;
    const auto add = [&](std::string_view name, std::string_view description, const Allowed& allowed,
                         double Crystal::*member) {
        parameters.push_back({std::string(name), std::string(description), allowed,
                              [member](Mechanism& m, double value) { std::get<Crystal>(m).*member = value; }});
    };
    Allowed diameter = allowed_diameter;
    Allowed spacing = allowed_spacing;
    const bool has_spacing = crystal.spacing_nm > 0.0;
    if (has_spacing) {
        diameter.high = std::min(diameter.high, crystal.diameter_nm * room_per_axis(crystal));
        spacing.low = std::max(spacing.low, crystal.spacing_nm / room_per_axis(crystal));
    }
    add("diameter_nm", "diameter of the spheres", diameter, &Crystal::diameter_nm);
    if (has_spacing) add("spacing_nm", "spacing of the planes", spacing, &Crystal::spacing_nm);
    add("thickness_spread_nm", "spacing's spread from domain to domain", allowed_spread, &Crystal::thickness_spread_nm);
    add_index_parameters(
        "sphere.", " of the spheres", crystal.sphere,
        [](Mechanism& m) -> Index& { return std::get<Crystal>(m).sphere; }, parameters);
    add_index_parameters(
        "medium.", " of the medium", crystal.medium, [](Mechanism& m) -> Index& { return std::get<Crystal>(m).medium; },
        parameters);
    add_index_parameters(
        "substrate.", " of the substrate", crystal.substrate,
        [](Mechanism& m) -> Index& { return std::get<Crystal>(m).substrate; }, parameters);
    return parameters;
}

std::string crystal_toml(const Mechanism& mechanism) {
    const auto& crystal = std::get<Crystal>(mechanism);
    std::string text = "mechanism = \"crystal\"\nincident = " + index_toml(crystal.incident) +
                       "\nsphere = " + index_toml(crystal.sphere) + "\nmedium = " + index_toml(crystal.medium) +
                       "\ndiameter_nm = " + number_text(crystal.diameter_nm) + "\n";
    if (crystal.spacing_nm > 0.0) text += "spacing_nm = " + number_text(crystal.spacing_nm) + "\n";
    text += "planes = " + std::to_string(crystal.planes) + "\nsubstrate = " + index_toml(crystal.substrate) + "\n";
    if (crystal.thickness_spread_nm > 0.0)
        text += "thickness_spread_nm = " + number_text(crystal.thickness_spread_nm) + "\n";
    return text;
}

const Index& crystal_substrate(const Mechanism& mechanism) {
    return std::get<Crystal>(mechanism).substrate;
}

}  // namespace

const MechanismReader crystal_reader{
    .read = read_crystal,
    .search = crystal_search,
    .parameters = crystal_parameters,
    .toml = crystal_toml,
    .substrate = crystal_substrate,
    .warning = nullptr,
    .check_axis = nullptr,
    .refusals = {.base = not_refused,
                 .facets = not_refused,
                 .polarisation = not_refused,
                 .thickness_spread_nm = not_refused,
                 .orders = no_orders},
};

}  // namespace nacre
