#pragma once

#include <string>
#include <vector>

#include "nacre/bake/index.h"
#include "nacre/bake/mechanism.h"

namespace nacre {

// What mechanism.cpp has a row of per mechanism: its keys in a scene, the parameters that may be axes, and its TOML.

Palette read_palette(const Table& table);
std::vector<Parameter> palette_parameters(const Palette& palette);
std::string palette_toml(const Palette& palette);

Film read_film(const Table& table, const IndexReader& index);
std::vector<Parameter> film_parameters(const Film& film);
std::string film_toml(const Film& film);

Stack read_stack(const Table& table, const IndexReader& index);
std::vector<Parameter> stack_parameters(const Stack& stack);
std::string stack_toml(const Stack& stack);

}  // namespace nacre
