#pragma once

#include <string>
#include <vector>

#include "nacre/material/mechanism.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/scene/scene_context.h"

namespace nacre {

// What mechanism.cpp has a row of per mechanism: its keys in a scene, the parameters that may be axes, and its TOML.

Palette read_palette(const Table& table, const SceneContext& context);
/// peak_nm, width_nm and height of a pick.
Lobe read_lobe(const Table& pick);
std::vector<Parameter> palette_parameters(const Palette& palette);
std::string palette_toml(const Palette& palette);

// Those that picks may lead to have a search beside their reader: the same keys, of which any may be free.

Film read_film(const Table& table, const IndexReader& index);
MechanismSearch film_search(const Table& table, const IndexReader& index);
std::vector<Parameter> film_parameters(const Film& film);
std::string film_toml(const Film& film);

Stack read_stack(const Table& table, const IndexReader& index);
/// Of lamellae: two materials, their thicknesses, how often they repeat. Layers that are given are all fixed.
MechanismSearch stack_search(const Table& table, const IndexReader& index);
std::vector<Parameter> stack_parameters(const Stack& stack);
std::string stack_toml(const Stack& stack);

Grating read_grating(const Table& table, const IndexReader& index);
MechanismSearch grating_search(const Table& table, const IndexReader& index);
std::vector<Parameter> grating_parameters(const Grating& grating);
std::string grating_toml(const Grating& grating);

Crystal read_crystal(const Table& table, const IndexReader& index);
MechanismSearch crystal_search(const Table& table, const IndexReader& index);
std::vector<Parameter> crystal_parameters(const Crystal& crystal);
std::string crystal_toml(const Crystal& crystal);

Scatter read_scatter(const Table& table, const IndexReader& index);
std::vector<Parameter> scatter_parameters(const Scatter& scatter);
std::string scatter_toml(const Scatter& scatter);

MeasuredSpectra read_measured(const Table& table, const SpectraReader& read_spectra);
std::string measured_toml(const MeasuredSpectra& spectra);

// Of every mechanism: base, tilt_deg, polarisation, each refused where it has no meaning.

Effects read_effects(const Table& table, const Mechanism& mechanism, const SceneContext& context);
std::vector<Parameter> effect_parameters(const Mechanism& mechanism);
std::string effects_toml(const Effects& effects);

// Pieces that readers of layers share.

inline constexpr Allowed allowed_thickness{0.0, 1e8, "nm"};
inline constexpr Allowed allowed_spread{0.0, 1e4, "nm"};
/// Air if the key is missing. Throws Error for a medium that absorbs.
Index read_incident(const Table& table, const IndexReader& reader);
/// thickness_spread_nm; 0 if it is missing.
double read_spread(const Table& table);
Index read_required_index(const Table& table, std::string_view key, const IndexReader& reader);
/// `prefix` + "n" and "k", of an index that is a number.
void add_index_parameters(const std::string& prefix, const std::string& of_what, const Index& index,
                          const std::function<Index&(Mechanism&)>& find, std::vector<Parameter>& parameters);

}  // namespace nacre
