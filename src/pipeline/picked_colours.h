#pragma once

#include <functional>
#include <string>

#include "nacre/lut/colour_settings.h"
#include "nacre/lut/colour_spaces.h"
#include "nacre/scene/plan.h"

namespace nacre {

/// Which colour config a scene is baked with.
/// @param config  of the front end (--ocio): wins over the scene's, which wins over the provider's default
ColourConfigChoice config_choice(const ColourSettings& colour, const std::string& scene_path,
                                 const std::string& config);

/// scene_files(), with colours read by the scene's config. It is opened when the first colour is asked for.
/// @param config      of the front end, see config_choice()
/// @param after_step  called every few steps of a search for what picks ask for; what it throws ends it
SceneFiles scene_files_with_colours(const std::string& scene_path, const std::string& config,
                                    const OpenColourSpaces& open_colours, const std::function<void()>& after_step = {});

}  // namespace nacre
