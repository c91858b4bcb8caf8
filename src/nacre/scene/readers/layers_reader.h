#pragma once

#include <string>
#include <vector>

#include "nacre/material/mechanism.h"
#include "nacre/optics/layered.h"
#include "nacre/scene/readers/index_reader.h"

namespace nacre {

/// `layers`: layers { index, thickness_nm, incoherent } and groups { repeat, layers }, nested at most 16 deep. In a
/// group index and thickness_nm may be { from, to }.
std::vector<Layer> read_layers(const Table& table, const Value& value, const IndexReader& index);

/// As a value in TOML; reads back as the same layers.
std::string layers_toml(const std::vector<Layer>& layers);

/// Thickness, n and k of every layer of a stack that is not graded: "layers[1].layers[0].thickness_nm". Of long stacks
/// the first 200.
void add_layer_parameters(const std::vector<Layer>& layers, std::vector<Parameter>& parameters);

}  // namespace nacre
