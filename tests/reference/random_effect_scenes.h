#pragma once

#include <string>
#include <vector>

#include "nacre/material/mechanism.h"

namespace nacre::reference {

/// How many scenes random_effect_scenes() has.
inline constexpr int random_effect_scenes_count = 300;

/// A material with effects, under a light, and the bound that it is baked for. The LUT has the mechanism's default
/// axis.
struct EffectScene {
    std::string name;
    Mechanism mechanism;
    std::string illuminant = "D65";
    int observer_deg = 2;
    double max_de00 = 0.1;
};

/// Films, stacks, crystals, scattering layers, gratings and palettes, named e000 to e299; the same ones everywhere, and
/// each the same whatever the others are.
///
/// Everything that refines them is there by chance, and of every size from nothing to plenty, even in the logarithm:
/// bases of all kinds, tilt, spreads of thickness and radius, dispersion, absorption, thick layers, higher orders;
/// light of either polarisation and of both. Bounds 1, 0.3, 0.1 in turn. Layers are few and thin, so that all are
/// quick.
std::vector<EffectScene> random_effect_scenes();

}  // namespace nacre::reference
