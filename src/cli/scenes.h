#pragma once

#include <string>
#include <vector>

#include "cli/console.h"
#include "pipeline/decide.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// A request with OpenColorIO's colour spaces, that stops on a signal and sends warnings to the console.
/// @param ocio  --ocio
SceneRequest scene_request(const std::string& ocio, Console& console);

/// The options --set: "KEY=VALUE".
///
/// Throws Error for a word without "=", and for a value that is broken TOML.
std::vector<SceneEdit> scene_edits(const std::vector<std::string>& words);

/// Opens the scenes of a command line; with -v it says what is in them.
///
/// Throws Error if --only names what none of them has.
std::vector<LoadedScene> open_scenes(const std::vector<std::string>& paths, const SceneRequest& request,
                                     Console& console);

/// The options --accuracy (0: not given) and --effects (empty: not given).
AccuracyOverride accuracy_override(double max_de00, const std::string& effects);

/// A warning for every LUT whose bound is out of reach, or an error where the user gave the bound and does not take the
/// best there is. Returns the number of errors.
std::size_t report_out_of_reach(const std::vector<DecidedLut>& luts, bool best_effort, Console& console);

}  // namespace nacre
