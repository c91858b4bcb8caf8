#pragma once

#include "cli/options.h"

namespace nacre {

/// Exit codes, the same for every command.
enum ExitCode : int {
    exit_done = 0,
    exit_some_failed = 1,   ///< some LUTs failed and said why; the others were written
    exit_wrong_input = 2,   ///< the scene or the command line is wrong; nothing was written
    exit_io = 3,            ///< the disk or the system refused; no partial file
    exit_not_verified = 4,  ///< accuracy or verification not met
};

Command init_command();
Command bake_command();
Command swatch_command();
Command plan_command();
Command cost_command();
Command spectrum_command();
Command verify_command();
Command pick_command();
Command list_command();
Command snippet_command();
Command figures_command();

}  // namespace nacre
