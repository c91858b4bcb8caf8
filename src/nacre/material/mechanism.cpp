#include "nacre/material/mechanism.h"

#include <array>

namespace nacre {
namespace {

void no_indices(MechanismModel&, const VisitIndex&) {}
double* no_spread(MechanismModel&) {
    return nullptr;
}

template <typename Model>
double* spread_of(MechanismModel& model) {
    return &std::get<Model>(model).thickness_spread_nm;
}

void visit_layers(std::vector<Layer>& layers, const VisitIndex& visit) {
    for (Layer& layer : layers) {
        if (layer.repeat > 0) {
            visit_layers(layer.layers, visit);
            continue;
        }
        visit(layer.index, IndexRole::layer);
        if (layer.last_index) visit(*layer.last_index, IndexRole::layer);
    }
}

void visit_film(MechanismModel& model, const VisitIndex& visit) {
    auto& film = std::get<Film>(model);
    visit(film.incident, IndexRole::incident);
    visit(film.index, IndexRole::layer);
    visit(film.substrate, IndexRole::substrate);
}

void visit_stack(MechanismModel& model, const VisitIndex& visit) {
    auto& stack = std::get<Stack>(model);
    visit(stack.incident, IndexRole::incident);
    visit_layers(stack.layers, visit);
    visit(stack.substrate, IndexRole::substrate);
}

void visit_grating(MechanismModel& model, const VisitIndex& visit) {
    auto& grating = std::get<Grating>(model);
    if (grating.coat) visit(*grating.coat, IndexRole::substrate);
}

void visit_crystal(MechanismModel& model, const VisitIndex& visit) {
    auto& crystal = std::get<Crystal>(model);
    visit(crystal.incident, IndexRole::incident);
    visit(crystal.sphere, IndexRole::layer);
    visit(crystal.medium, IndexRole::layer);
    visit(crystal.substrate, IndexRole::substrate);
}

void visit_scatter(MechanismModel& model, const VisitIndex& visit) {
    auto& scatter = std::get<Scatter>(model);
    visit(scatter.medium, IndexRole::incident);
    visit(scatter.particle, IndexRole::layer);
}

constexpr std::array<MechanismRow, std::variant_size_v<MechanismModel>> all_mechanism_rows{{
    {"palette", "picked bands of reflectance, and what lies between them", Quantity::incidence, false, false,
     no_indices, no_spread},
    {"film", "one layer on a substrate", Quantity::incidence, true, true, visit_film, spread_of<Film>},
    {"stack", "any number of layers on a substrate", Quantity::incidence, true, true, visit_stack, spread_of<Stack>},
    {"grating", "parallel grooves", Quantity::grating_u, false, false, visit_grating, no_spread},
    {"crystal", "planes of spheres, such as an opal", Quantity::incidence, true, true, visit_crystal,
     spread_of<Crystal>},
    {"scatter", "spheres that scatter light once", Quantity::cos_scatter, false, true, visit_scatter, no_spread},
    {"measured", "measured spectra at several angles", Quantity::incidence, false, false, no_indices, no_spread},
}};

static_assert(all_mechanism_rows.back().visit_indices != nullptr, "material/mechanism.cpp: one row per mechanism");

}  // namespace

std::span<const MechanismRow> mechanism_rows() {
    return all_mechanism_rows;
}

const MechanismRow& row_of(const Mechanism& mechanism) {
    return all_mechanism_rows[mechanism.index()];
}

std::vector<std::string> mechanism_names() {
    std::vector<std::string> names;
    for (const MechanismRow& row : all_mechanism_rows) names.emplace_back(row.name);
    return names;
}

double thickness_spread_nm(const Mechanism& mechanism) {
    // The row only finds the number.
    const double* spread_nm = row_of(mechanism).thickness_spread_nm(const_cast<Mechanism&>(mechanism));
    return spread_nm == nullptr ? 0.0 : *spread_nm;
}

void for_each_index(Mechanism& mechanism, const VisitIndex& visit) {
    row_of(mechanism).visit_indices(mechanism, visit);
    if (!mechanism.effects.base) return;
    if (auto* metal = std::get_if<MetalBase>(&*mechanism.effects.base)) visit(metal->metal, IndexRole::substrate);
    if (auto* pigment = std::get_if<PigmentBase>(&*mechanism.effects.base))
        visit(pigment->pigment, IndexRole::substrate);
}

void for_each_index(const Mechanism& mechanism, const std::function<void(const Index&, IndexRole)>& visit) {
    // The visitor does not change it.
    for_each_index(const_cast<Mechanism&>(mechanism),
                   VisitIndex([&](Index& index, IndexRole role) { visit(index, role); }));
}

}  // namespace nacre
