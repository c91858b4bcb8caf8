#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/dense_model.h"

namespace nacre::reference {

/// How many scenes random_scenes() has; every tenth has a second axis.
inline constexpr int random_scene_count = 200;

/// Scenes as artists and their slips make them, named s000 to s199; the same ones everywhere, and each the same
/// whatever the others are.
///
/// Mostly two picks (as few as a constant material, up to four) at angles 0 to 85, at least 5 degrees apart; peaks
/// 380 to 720 nm, mostly moving to shorter waves; widths 15 to 300 nm, a few down to 3 nm; heights 0.05 to 1, some 0.
std::vector<SceneModel> random_scenes();

/// Size and format that a scene insists on.
struct FixedLut {
    int width = 256, height = 1;
    StoredAs format = StoredAs::half_float;
};

/// The scene file that says the same as a model: one material and one LUT of the model's name.
std::string scene_text(const SceneModel& scene, const std::optional<FixedLut>& fixed = std::nullopt);

}  // namespace nacre::reference
