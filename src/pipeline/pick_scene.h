#pragma once

#include <string>
#include <vector>

namespace nacre {

/// One pick, as a scene has it.
struct PickLine {
    std::string toml;     ///< "{ angle_deg = 0, colour = \"#3a6fd0\" }"
    std::string comment;  ///< behind it; may be empty
};

/// "[\n    { ... },  # comment\n]"
std::string picks_toml(const std::vector<PickLine>& picks);

/// A scene of one material and its swatches.
struct PickScene {
    std::string name;          ///< of the material
    std::string material;      ///< its lines, but for the picks
    std::string picks;         ///< the value of `picks`; empty: no such key
    std::string comments;      ///< lines above the material; may be empty
    bool has_colours = false;  ///< whether the picks are colours, so that a swatch can compare them
};

/// Its text, as nacre and its users read it.
std::string scene_text(const PickScene& scene);

}  // namespace nacre
