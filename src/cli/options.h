#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/console.h"
#include "nacre/base/where.h"

namespace nacre {

/// Where the value of an option goes; the type says what its text must be. A bool is a flag without a value.
using OptionTarget = std::variant<bool*, int*, double*, std::string*, std::vector<std::string>*, std::vector<double>*>;

/// One option of a command, or, if its name has no dash, the words that a command takes.
struct Option {
    std::string names;  ///< "-o,--output"; "SCENE"
    OptionTarget target;
    std::string help;
    std::string value_name{};            ///< "DIR"; of a flag and of words: empty
    bool is_required = false;            ///< of words
    bool shows_default = false;          ///< whether --help shows the value that the target has
    bool is_list = false;                ///< whether it takes several words at once, or one word with commas
    std::vector<std::string> allowed{};  ///< the words that it can be; empty: any
    std::optional<Allowed> range{};      ///< of a number
    std::vector<std::string> excludes{};
};

/// A command of the program.
struct Command {
    std::string name;
    std::string summary;
    std::vector<Option> options;
    std::string footer;                  ///< of --help, behind the options
    std::function<int(Console&)> run{};  ///< returns an ExitCode
};

/// What a command line asks for.
struct Asked {
    const Command* command = nullptr;  ///< null: nothing is left to do, --help or --version was printed
    ConsoleOptions console;
};

/// Reads a command line, and writes what it gives into the targets of the command's options.
///
/// This is the only file that knows CLI11.
/// @throws Error that names the option, quotes the value, and ends in "see nacre COMMAND --help"
Asked parse_command_line(int argc, const char* const* argv, const std::vector<Command>& commands);

}  // namespace nacre
