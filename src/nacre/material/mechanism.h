#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "nacre/base/where.h"
#include "nacre/material/geometry.h"
#include "nacre/material/relief.h"
#include "nacre/optics/base.h"
#include "nacre/optics/crystal.h"
#include "nacre/optics/grating.h"
#include "nacre/optics/layered.h"
#include "nacre/optics/measured_spectra.h"
#include "nacre/optics/palette.h"
#include "nacre/optics/polarisation.h"
#include "nacre/optics/response.h"
#include "nacre/optics/scatter.h"

namespace nacre {

/// Refinements of a mechanism, if the scene asks for them. (Others are numbers of the mechanism itself: the spread of a
/// stack's thicknesses, the orders of a grating.)
struct Effects {
    std::optional<Base> base;  ///< below the layers; none: black
    Relief relief;
    Polarisation polarisation = Polarisation::mean;
    bool both_polarisations = false;            ///< whether a LUT becomes two, of s and of p
    Observed observed = Observed::reflectance;  ///< a LUT's, not a material's; transmittance: of layers without a base
    friend bool operator==(const Effects&, const Effects&) = default;
};

/// The closed list of what makes the colour of a material. Each room that treats mechanisms differently has one table
/// with one row per alternative; tables that are arrays have this order. src/README.md lists the tables, and the
/// compiler names each that lacks a row.
using MechanismModel = std::variant<Palette, Film, Stack, Grating, Crystal, Scatter, MeasuredSpectra>;

/// A mechanism, and what refines it.
struct Mechanism : MechanismModel {
    using MechanismModel::MechanismModel;
    using MechanismModel::operator=;

    Effects effects;

    friend bool operator==(const Mechanism& a, const Mechanism& b) {
        return static_cast<const MechanismModel&>(a) == static_cast<const MechanismModel&>(b) && a.effects == b.effects;
    }
};

/// A named mechanism, and where the scene defines it.
struct Material {
    std::string name;
    Mechanism mechanism;
    Where where;
};

/// A number of a mechanism that a LUT may have as its axis.
struct Parameter {
    /// "shape", "picks[0].width_nm"; without an index, "width_nm", it sets that of all picks at once. Of two parameters
    /// that set the same number, the names are equal, or one is "...]." and the other: this is how a LUT whose axes do
    /// so is refused (plan_lut.cpp).
    std::string name;
    std::string description;  ///< for axis labels: "width of pick 0"
    Allowed allowed;
    std::function<void(Mechanism&, double)> set;
};

/// What an index of a mechanism is of.
enum class IndexRole { incident, layer, substrate };
using VisitIndex = std::function<void(Index&, IndexRole)>;

/// What the other rooms ask of a mechanism as such.
struct MechanismRow {
    std::string_view name;         ///< in a scene: "palette"
    std::string_view description;  ///< half a line
    Quantity quantity;             ///< what its colour depends on besides its own numbers
    bool is_layered;               ///< made of layers: film, stack, crystal
    bool has_polarisations;        ///< whether s and p may differ
    /// Every index that it has, without those of its base.
    void (*visit_indices)(MechanismModel&, const VisitIndex&);
    /// Its standard deviation of thicknesses; null: it has none.
    double* (*thickness_spread_nm)(MechanismModel&);
};

/// In MechanismModel's order; the first is the default.
std::span<const MechanismRow> mechanism_rows();
const MechanismRow& row_of(const Mechanism& mechanism);

/// The names in a scene, in MechanismModel's order.
std::vector<std::string> mechanism_names();

inline std::string_view mechanism_name(const Mechanism& mechanism) {
    return row_of(mechanism).name;
}
inline Quantity quantity_of(const Mechanism& mechanism) {
    return row_of(mechanism).quantity;
}
inline bool is_transmittance(const Mechanism& mechanism) {
    return mechanism.effects.observed == Observed::transmittance;
}
inline bool is_layered(const Mechanism& mechanism) {
    return row_of(mechanism).is_layered;
}

/// Standard deviation of its thicknesses; 0 for what has none.
double thickness_spread_nm(const Mechanism& mechanism);

/// Every index that a mechanism has; its base's too.
void for_each_index(Mechanism& mechanism, const VisitIndex& visit);
void for_each_index(const Mechanism& mechanism, const std::function<void(const Index&, IndexRole)>& visit);

}  // namespace nacre
