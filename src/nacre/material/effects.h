#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>

#include "nacre/material/mechanism.h"

namespace nacre {

/// The closed list of what refines the colour of a mechanism. Even where a scene asks for an effect, its difference may
/// be negligible.
enum class Effect {
    dispersion,
    absorption,
    polarisation,
    incoherent_layers,
    thickness_spread,
    base,
    tilt,
    roughness,
    higher_orders,
    size_spread,
};
inline constexpr std::size_t effect_count = 10;

/// A set of effects.
class EffectSet {
public:
    bool has(Effect effect) const { return (bits_ & bit(effect)) != 0; }
    EffectSet() = default;
    EffectSet(std::initializer_list<Effect> effects) {
        for (const Effect effect : effects) insert(effect);
    }
    void insert(Effect effect) { bits_ |= bit(effect); }
    void insert(const EffectSet& effects) { bits_ |= effects.bits_; }
    void erase(Effect effect) { bits_ &= ~bit(effect); }
    bool has_any(const EffectSet& effects) const { return (bits_ & effects.bits_) != 0; }
    /// Those that the other set has not.
    EffectSet minus(const EffectSet& other) const;
    bool is_empty() const { return bits_ == 0; }
    int size() const;
    friend bool operator==(const EffectSet&, const EffectSet&) = default;

private:
    static std::uint32_t bit(Effect effect) { return std::uint32_t{1} << static_cast<unsigned>(effect); }
    std::uint32_t bits_ = 0;
};

/// Those that are a mean over facets; a material has one of them at most.
inline const EffectSet facet_effects{Effect::tilt, Effect::roughness};
inline Effect facet_effect(const Relief& relief) {
    return relief.roughness > 0.0 ? Effect::roughness : Effect::tilt;
}

/// One row per effect: how to tell whether a mechanism has it, and how to take it away. A new effect is a row here, and
/// the code that simulates it.
struct EffectRow {
    Effect effect;
    std::string_view name;         ///< in scenes, plans and headers
    std::string_view description;  ///< half a line
    /// @param first_nm  where the light begins
    bool (*is_in)(const Mechanism&, double first_nm);
    /// Afterwards is_in() is false, and nothing of the effect is computed.
    void (*remove)(Mechanism&, double first_nm);
};

/// In the enumeration's order.
std::span<const EffectRow> effect_rows();
const EffectRow& row_of(Effect effect);

EffectSet effects_in(const Mechanism& mechanism, double first_nm);
void remove(const EffectSet& effects, Mechanism& mechanism, double first_nm);

/// The work spent on an effect, counted so that tests can show that an absent effect costs nothing.
struct EffectWork {
    std::uint64_t spectra = 0;        ///< computed because of it
    std::uint64_t layers = 0;         ///< affected layers times wavelengths
    std::uint64_t points = 0;         ///< of its quadrature
    std::uint64_t polarisations = 0;  ///< spectra of a second one
    friend bool operator==(const EffectWork&, const EffectWork&) = default;
};
using EffectWorks = std::array<EffectWork, effect_count>;

inline EffectWork& work_of(EffectWorks& works, Effect effect) {
    return works[static_cast<std::size_t>(effect)];
}

}  // namespace nacre
