#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "support/folders.h"

namespace nacre::test {

/// What a run of the nacre program left behind.
struct ProgramResult {
    int exit_code = -1;  ///< 128 + signal if a signal ended it
    std::string out;
    std::string err;
};

struct ProgramOptions {
    std::filesystem::path folder;                                  ///< working directory; empty: this process's
    std::vector<std::pair<std::string, std::string>> environment;  ///< set on top of ours; OCIO is unset unless named
    std::function<void()> in_child;                                ///< runs in the child before the program starts
    std::filesystem::path out_file;                                ///< where standard output goes; empty: captured
};

/// Runs the program that this build made.
ProgramResult run_nacre(const std::vector<std::string>& arguments, const ProgramOptions& options = {});

/// Runs a line of the shell, in which `nacre` is the program that this build made.
ProgramResult run_shell(const std::string& command, ProgramOptions options = {});

}  // namespace nacre::test
