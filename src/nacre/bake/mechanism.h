#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nacre/bake/table.h"
#include "nacre/optics/layered.h"
#include "nacre/optics/palette.h"

namespace nacre {

struct IndexReader;

/// What makes a material's colour: the closed list. A new mechanism is a file under optics/, an alternative here and a
/// row in mechanism.cpp; the compiler names every visitor that lacks it.
using Mechanism = std::variant<Palette, Film, Stack>;

/// A material of a scene.
struct Material {
    std::string name;
    Mechanism mechanism;
    Where where;
};

/// A number of a mechanism that a LUT may have as its axis.
struct Parameter {
    std::string name;         ///< "shape", "picks[0].width_nm"; without an index: of all picks at once
    std::string description;  ///< for axis labels: "width of pick 0"
    Allowed allowed;
    std::function<void(Mechanism&, double)> set;
};

/// Every numeric parameter that a mechanism has, in the order in which they are offered.
std::vector<Parameter> parameters_of(const Mechanism& mechanism);

/// The name in a scene: "palette".
std::string_view mechanism_name(const Mechanism& mechanism);

/// Reads `mechanism` and that mechanism's keys. Throws Error for anything that is wrong or unknown.
/// @param index  reads what materials are made of, and knows which wavelengths they are needed at
Mechanism read_mechanism(const Table& table, const IndexReader& index);

/// What the user wrote so as to get this mechanism: the lines below a [material.NAME] heading, in TOML.
std::string mechanism_toml(const Mechanism& mechanism);

}  // namespace nacre
