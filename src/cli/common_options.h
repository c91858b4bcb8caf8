#pragma once

#include <string>
#include <vector>

#include "cli/options.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// Options that several commands share.
Option scenes_option(std::vector<std::string>& scenes);
Option only_option(std::vector<std::string>& names);
Option ocio_option(std::string& file);
/// --space, --display and --view.
std::vector<Option> colour_options(ColourOverride& asked);
Option threads_option(int& threads);
Option strict_option(bool& is_strict);
Option set_option(std::vector<std::string>& edits);
/// @param bound  stays 0 if it is not given
Option accuracy_option(double& bound);
/// @param word  stays empty if it is not given
Option effects_option(std::string& word);

}  // namespace nacre
