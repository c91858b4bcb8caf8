#pragma once

#include <string>
#include <vector>

#include "nacre/material/mechanism.h"
#include "nacre/optics/layered.h"
#include "nacre/scene/readers/free_reader.h"
#include "nacre/scene/readers/index_reader.h"

namespace nacre {

/// `layers`: layers { index, thickness_nm, incoherent } and groups { repeat, layers }, nested at most 16 deep. In a
/// group index and thickness_nm may be { from, to }.
/// @param free  where picks are to be met: numbers may be left to this search, with { from, to }, or in a group { from,
/// to, free = true }, or as an end of a graded one; thicknesses also by leaving them out. null: there are none
std::vector<Layer> read_layers(const Table& table, const Value& value, const IndexReader& index, FreeReader* free);

/// As a value in TOML; reads back as the same layers.
std::string layers_toml(const std::vector<Layer>& layers);

/// Thickness, n and k of every layer of a stack that is not graded: "layers[1].layers[0].thickness_nm". Of long stacks
/// the first 200.
void add_layer_parameters(const std::vector<Layer>& layers, std::vector<Parameter>& parameters);

}  // namespace nacre
