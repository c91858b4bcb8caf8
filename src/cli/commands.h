#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "cli/console.h"

namespace nacre {

/// Exit codes, the same for every command.
enum ExitCode : int {
    exit_done = 0,
    exit_some_failed = 1,   ///< some LUTs failed and said why; the others were written
    exit_wrong_input = 2,   ///< the scene or the command line is wrong; nothing was written
    exit_io = 3,            ///< the disk or the system refused; no partial file
    exit_not_verified = 4,  ///< accuracy or verification not met
};

/// A command of the program: declares its options on a CLI11 subcommand and returns what runs it.
using Command = std::function<int(Console&)>;

Command add_bake_command(CLI::App& app);
Command add_swatch_command(CLI::App& app);
Command add_plan_command(CLI::App& app);
Command add_cost_command(CLI::App& app);
Command add_spectrum_command(CLI::App& app);
Command add_verify_command(CLI::App& app);
Command add_pick_command(CLI::App& app);
Command add_snippet_command(CLI::App& app);
Command add_figures_command(CLI::App& app);

}  // namespace nacre
