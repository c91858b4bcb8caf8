#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/lut/axis.h"
#include "nacre/material/mechanism.h"
#include "nacre/pick/mechanism_search.h"
#include "nacre/scene/readers/mechanism_reader.h"
#include "nacre/scene/scene_context.h"

namespace nacre {

/// Why a key that refines other mechanisms has no meaning for this one; empty: it has one. A reader that does not say
/// it of every key does not compile.
struct Refusal : std::string_view {
    using std::string_view::string_view;
    Refusal() = delete;
};
struct EffectRefusals {
    Refusal base;
    Refusal facets;  ///< tilt_deg and roughness
    Refusal polarisation;
    Refusal thickness_spread_nm;
    Refusal orders;
};

/// What scenes know of a mechanism. One row per mechanism, at the end of its own file; mechanism_reader.cpp lists them.
struct MechanismReader {
    ReadMechanism (*read)(const Table&, const SceneContext&);
    /// The same keys, of which any may be free; null if picks are read by `read`, or lead nowhere.
    MechanismSearch (*search)(const Table&, const IndexReader&);
    /// The numbers that may be axes; null: there are none.
    std::vector<Parameter> (*parameters)(const Mechanism&);
    std::string (*toml)(const Mechanism&);
    /// Through which light gets to a base; null if the mechanism has none.
    const Index& (*substrate)(const Mechanism&);
    /// See mechanism_warning(); null: never.
    std::string (*warning)(const Mechanism&, const LightSettings&);
    /// See check_axis() of mechanism_reader.h; null: every axis between allowed ends is right.
    void (*check_axis)(const Axis&, const Mechanism&, const Table&, const Where&);
    EffectRefusals refusals;
};

/// Refusals that several mechanisms share.
inline constexpr Refusal not_refused{""};
inline constexpr Refusal no_orders{"which has no diffraction orders"};
inline constexpr Refusal no_transmission{"which has no transmittance"};

extern const MechanismReader palette_reader;
extern const MechanismReader film_reader;
extern const MechanismReader stack_reader;
extern const MechanismReader grating_reader;
extern const MechanismReader crystal_reader;
extern const MechanismReader scatter_reader;
extern const MechanismReader measured_reader;

/// The row of a mechanism, which may also be given by its index in MechanismModel.
const MechanismReader& reader_of(const Mechanism& mechanism);
const MechanismReader& reader_at(std::size_t index);

// effects_reader.cpp reads base, tilt_deg, roughness and polarisation. It refuses them, thickness_spread_nm and orders
// where they have no meaning; where these two have one, the mechanism's own reader reads them.

Effects read_effects(const Table& table, const Mechanism& mechanism, const SceneContext& context);
std::vector<Parameter> effect_parameters(const Mechanism& mechanism);
std::string effects_toml(const Effects& effects);

}  // namespace nacre
