#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/loaded_scene.h"
#include "nacre/accuracy/settle.h"
#include "nacre/lut/planned_lut.h"

namespace nacre {

/// One LUT of one scene with what was decided about it.
struct SettledTask {
    const LoadedScene* scene = nullptr;
    const PlannedLut* asked = nullptr;
    SettledLut lut;
    double seconds = 0.0;  ///< what deciding took, of one thread
    std::string failure;   ///< why nothing could be decided; empty if it could
};

/// Replaces the bound of every LUT by --accuracy, if that is given (> 0).
///
/// Throws Error if a bound is binding in a colour space in which errors cannot be known.
/// @param effects  --effects: "auto" or "all"; empty: what the scene says
void override_accuracy(std::vector<LoadedScene>& scenes, double max_de00, const std::string& effects);

/// Decides size, format and integral of the tasks' LUTs, on several threads.
/// @param threads  0: one per core
void settle_all(std::vector<SettledTask>& tasks, int threads, Console& console);

/// Those whose bound is out of reach: a warning each, or an error where the user gave the bound and does not take the
/// best there is. Returns the number of errors.
std::size_t report_out_of_reach(const std::vector<SettledTask>& tasks, bool best_effort, Console& console);

/// Declares --accuracy; `value` stays 0 if it is not given.
void add_accuracy_option(CLI::App& app, double& value);
/// Declares --strict.
void add_strict_option(CLI::App& app, bool& is_strict);
/// Declares --effects; `word` stays empty if it is not given.
void add_effects_option(CLI::App& app, std::string& word);

}  // namespace nacre
