#pragma once

#include <string>
#include <vector>

#include "reference/dense_layers.h"

namespace nacre::reference {

/// How many scenes random_layers() has; every twelfth has a thickness as second axis.
inline constexpr int random_layers_count = 200;

/// A scene and the bound that it is baked for.
struct BoundedLayers {
    LayersModel model;
    double max_de00 = 0.1;
};

/// Films and stacks, named l000 to l199; the same ones everywhere, and each the same whatever the others are.
///
/// Films on glass, on metal and free, some of them to 50 um thick; stacks of 1 to 40 layers, some of equal periods;
/// constant and dispersive media, a quarter absorbing; air, and some prisms, in front. Bounds 1, 0.1, 0.02 in turn.
std::vector<BoundedLayers> random_layers();

/// The scene file that says the same as a model: one material and one LUT of the model's name.
std::string scene_text(const LayersModel& model);

}  // namespace nacre::reference
