#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/console.h"
#include "io/ocio/colour_config.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/scene/plan.h"
#include "pipeline/baked_lut.h"

namespace nacre {

/// A scene with nothing left to go wrong but the disk: planned, its OpenColorIO config open, every space, display and
/// view found.
struct LoadedScene {
    std::string path;
    Plan plan;
    ColourSource source;
    ColourTransform transform;                       ///< XYZ D65 to the LUTs' colour space
    std::vector<ColourTransform> swatch_transforms;  ///< as many as the plan has swatches
    std::optional<ColourTransform> strip_transform;  ///< default display and view, if a LUT asks for a png
};

/// @param ocio         --ocio: wins over the scene's config, which wins over $OCIO
/// @param want_swatches  whether displays and views are needed
/// @param only         names of LUTs and swatches; empty: all
/// @param strict       whether a picked colour that cannot be had is an error
LoadedScene load_scene(const std::string& path, const std::string& ocio, bool want_swatches,
                       const std::vector<std::string>& only, bool strict, Console& console);

/// All of them; throws Error if two scenes would write one file, or if `only` names what none of them has.
std::vector<LoadedScene> load_scenes(const std::vector<std::string>& paths, const std::string& ocio, bool want_swatches,
                                     const std::vector<std::string>& only, bool strict, Console& console);

/// The space that a scene's LUTs are in. Linear Rec.709 is the default, and every config calls it something else.
/// @param where  for messages
ColourTransform target_transform(const ColourConfig& config, const ColourSettings& colour, const std::string& where);

}  // namespace nacre
