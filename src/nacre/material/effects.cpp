#include "nacre/material/effects.h"

#include <algorithm>
#include <bit>
#include <map>
#include <memory>

namespace nacre {
namespace {

// Where an index without dispersion is taken: luminance is largest there.
constexpr double middle_nm = 555.0;

bool is_even(const Index& index) {
    return !index.is_dispersive();
}

bool is_lossless(const Index& index) {
    return index.is_constant() ? index.constant.imag() == 0.0 : index.curve->is_lossless();
}

// Whether any index of such a role is not as it is without the effect.
bool any_index(const Mechanism& mechanism, bool only_layers, bool (*is_plain)(const Index&)) {
    bool found = false;
    for_each_index(mechanism, [&](const Index& index, IndexRole role) {
        if (!only_layers || role == IndexRole::layer) found = found || !is_plain(index);
    });
    return found;
}

bool has_dispersion(const Mechanism& mechanism, double) {
    return any_index(mechanism, false, is_even);
}
void remove_dispersion(Mechanism& mechanism, double) {
    for_each_index(mechanism, [](Index& index, IndexRole) {
        if (!index.is_dispersive()) return;
        const IndexCurve& curve = *index.curve;
        index = Index(curve.at(std::clamp(middle_nm, curve.first_nm, curve.last_nm)));
    });
}

bool has_absorption(const Mechanism& mechanism, double) {
    return any_index(mechanism, true, is_lossless);
}
void remove_absorption(Mechanism& mechanism, double) {
    std::map<const IndexCurve*, Index> lossless;  // the same material stays the same
    for_each_index(mechanism, [&](Index& index, IndexRole role) {
        if (role != IndexRole::layer || is_lossless(index)) return;
        if (index.is_constant()) {
            index.constant.imag(0.0);
            return;
        }
        Index& without = lossless[index.curve.get()];
        if (without.is_constant()) {
            IndexCurve curve = *index.curve;
            curve.k = 0.0;
            without = Index(std::make_shared<const IndexCurve>(std::move(curve)));
        }
        index = without;
    });
}

bool has_two_polarisations(const Mechanism& mechanism, double) {
    return row_of(mechanism).has_polarisations && mechanism.effects.polarisation == Polarisation::mean;
}
void remove_polarisation(Mechanism& mechanism, double) {
    mechanism.effects.polarisation = Polarisation::s;
}

bool has_incoherent_layers(const Mechanism& mechanism, double) {
    const auto* stack = std::get_if<Stack>(&mechanism);
    return stack != nullptr && std::any_of(stack->layers.begin(), stack->layers.end(),
                                           [](const Layer& layer) { return layer.is_incoherent; });
}
// Nothing comes back from what is under a thick layer.
void remove_incoherent_layers(Mechanism& mechanism, double) {
    auto& stack = std::get<Stack>(mechanism);
    const auto thick =
        std::find_if(stack.layers.begin(), stack.layers.end(), [](const Layer& layer) { return layer.is_incoherent; });
    stack.substrate = thick->index;
    stack.layers.erase(thick, stack.layers.end());
    mechanism.effects.base.reset();
}

bool has_thickness_spread(const Mechanism& mechanism, double) {
    return thickness_spread_nm(mechanism) > 0.0;
}
void remove_thickness_spread(Mechanism& mechanism, double) {
    if (double* spread_nm = row_of(mechanism).thickness_spread_nm(mechanism)) *spread_nm = 0.0;
}

bool has_base(const Mechanism& mechanism, double) {
    return mechanism.effects.base.has_value();
}
void remove_base(Mechanism& mechanism, double) {
    mechanism.effects.base.reset();
}

bool has_tilt(const Mechanism& mechanism, double) {
    return mechanism.effects.relief.tilt_deg > 0.0;
}
void remove_tilt(Mechanism& mechanism, double) {
    mechanism.effects.relief.tilt_deg = 0.0;
}

bool has_roughness(const Mechanism& mechanism, double) {
    return mechanism.effects.relief.roughness > 0.0;
}
void remove_roughness(Mechanism& mechanism, double) {
    mechanism.effects.relief.roughness = 0.0;
}

bool has_higher_orders(const Mechanism& mechanism, double first_nm) {
    const auto* grating = std::get_if<Grating>(&mechanism);
    return grating != nullptr && counted_orders(*grating, first_nm).size() > 1;
}
void remove_higher_orders(Mechanism& mechanism, double first_nm) {
    auto& grating = std::get<Grating>(mechanism);
    grating.orders = {counted_orders(grating, first_nm).front()};
}

bool has_size_spread(const Mechanism& mechanism, double) {
    const auto* scatter = std::get_if<Scatter>(&mechanism);
    return scatter != nullptr && scatter->radius_spread > 0.0;
}
void remove_size_spread(Mechanism& mechanism, double) {
    std::get<Scatter>(mechanism).radius_spread = 0.0;
}

constexpr std::array<EffectRow, effect_count> all_effect_rows{{
    {Effect::dispersion, "dispersion", "indices that depend on the wavelength", has_dispersion, remove_dispersion},
    {Effect::absorption, "absorption", "layers or particles that absorb light", has_absorption, remove_absorption},
    {Effect::polarisation, "polarisation", "s and p computed separately and averaged", has_two_polarisations,
     remove_polarisation},
    {Effect::incoherent_layers, "incoherent_layers", "layers too thick for interference", has_incoherent_layers,
     remove_incoherent_layers},
    {Effect::thickness_spread, "thickness_spread", "the mean over random thicknesses", has_thickness_spread,
     remove_thickness_spread},
    {Effect::base, "base", "light from below the layers", has_base, remove_base},
    {Effect::tilt, "tilt", "the mean over facets", has_tilt, remove_tilt},
    {Effect::roughness, "roughness", "the mean over GGX facets", has_roughness, remove_roughness},
    {Effect::higher_orders, "higher_orders", "diffraction orders beyond the first", has_higher_orders,
     remove_higher_orders},
    {Effect::size_spread, "size_spread", "the mean over radii", has_size_spread, remove_size_spread},
}};

}  // namespace

EffectSet EffectSet::minus(const EffectSet& other) const {
    EffectSet rest = *this;
    rest.bits_ &= ~other.bits_;
    return rest;
}

int EffectSet::size() const {
    return std::popcount(bits_);
}

std::span<const EffectRow> effect_rows() {
    return all_effect_rows;
}

const EffectRow& row_of(Effect effect) {
    return all_effect_rows[static_cast<std::size_t>(effect)];
}

EffectSet effects_in(const Mechanism& mechanism, double first_nm) {
    EffectSet found;
    for (const EffectRow& row : all_effect_rows) {
        if (row.is_in(mechanism, first_nm)) found.insert(row.effect);
    }
    return found;
}

void remove(const EffectSet& effects, Mechanism& mechanism, double first_nm) {
    if (effects.is_empty()) return;
    for (const EffectRow& row : all_effect_rows) {
        if (effects.has(row.effect) && row.is_in(mechanism, first_nm)) row.remove(mechanism, first_nm);
    }
}

}  // namespace nacre
