#pragma once

#include <functional>
#include <string>

#include "io/ocio/colour_config.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/scene/plan.h"

namespace nacre {

/// Which OpenColorIO config a scene is baked with.
/// @param ocio  --ocio: wins over the scene's config, which wins over $OCIO
ColourConfigChoice config_choice(const ColourSettings& colour, const std::string& scene_path, const std::string& ocio);

/// scene_files(), with colours read by the scene's config. It is opened when the first colour is asked for.
/// @param after_step  called every few steps of a search for what picks ask for; what it throws ends it
SceneFiles scene_files_with_colours(const std::string& scene_path, const std::string& ocio,
                                    const std::function<void()>& after_step = {});

}  // namespace nacre
