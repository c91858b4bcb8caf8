#pragma once

#include "cli/console.h"
#include "pipeline/execution.h"

namespace nacre {

/// Work on this process's threads: ends when a signal asks for it, and draws the console's progress bar.
/// @param threads  0: one per core
Execution execution_on(int threads, Console& console);

}  // namespace nacre
