#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/lut.h"
#include "reference/scene.h"

/// Random scenes, the same ones everywhere, and each the same whatever the others are.
namespace nacre::reference {

/// Palettes as artists and their slips make them, named s000 to s199; every tenth has a second axis.
///
/// Mostly two picks (as few as a constant material, up to four) at angles 0 to 85, at least 5 degrees apart; peaks
/// 380 to 720 nm, mostly moving to shorter waves; widths 15 to 300 nm, a few down to 3 nm; heights 0.05 to 1, some 0.
inline constexpr int random_palettes_count = 200;
std::vector<ModelScene> random_palettes();

/// Films and stacks, named l000 to l199; every twelfth has a thickness as second axis.
///
/// Films on glass, on metal and free, some of them to 50 um thick; stacks of 1 to 40 layers, some of equal periods;
/// constant and dispersive media, a quarter absorbing; air, and some prisms, in front. Bounds 1, 0.1, 0.02 in turn.
inline constexpr int random_layers_count = 200;
std::vector<ModelScene> random_layers();

/// Films, stacks, crystals, scattering layers, gratings and palettes, named e000 to e299.
///
/// Everything that refines them is there by chance, and of every size from nothing to plenty, even in the logarithm:
/// bases of all kinds, tilt, spreads of thickness and radius, dispersion, absorption, thick layers, higher orders;
/// light of either polarisation and of both. Bounds 1, 0.3, 0.1 in turn. Layers are few and thin, so that all are
/// quick.
inline constexpr int random_effects_count = 300;
std::vector<ModelScene> random_effects();

/// Layers in which light goes to and fro, named r000 to r399; the kind is the number modulo five.
///
/// Air gaps of 100 to 1200 nm between a prism and a metal; dielectrics between metals; mirrors around a defect; long
/// stacks with the edge of their band in sight; films of 0 to 20 um. A third has a base, a spread or a tilt.
inline constexpr int random_resonators_count = 400;
std::vector<ModelScene> random_resonators();

/// The same material's transmittance, named after it: NAME_t. Nothing of what is not made of layers; a base is gone.
std::optional<ModelScene> seen_through(ModelScene scene);

/// "s007"
std::string numbered(char kind, int index);

/// Size and format that a scene requests.
struct FixedLut {
    int width = 256, height = 1;
    StoredAs format = StoredAs::half_float;
};

/// The scene file that says the same as a palette, film or stack: one material and one LUT of the scene's name.
std::string scene_text(const ModelScene& scene, const std::optional<FixedLut>& fixed = std::nullopt);

}  // namespace nacre::reference
