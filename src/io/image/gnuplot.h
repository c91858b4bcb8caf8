#pragma once

#include <map>
#include <string>
#include <vector>

namespace nacre {

/// Contents by file name.
using NamedFiles = std::map<std::string, std::string>;

/// What gnuplot made of a script.
struct GnuplotResult {
    NamedFiles files;      ///< the pictures that were asked for
    std::string warnings;  ///< one line; empty if it said nothing
};

/// Runs `gnuplot SCRIPT` in a private temporary folder that holds `inputs`, and reads `outputs` (PNG) back.
///
/// It uses no shell, and neither the user's settings (~/.gnuplot) nor locale. The folder is always removed. May be
/// called from several threads.
/// @param inputs   the script and everything that it reads, by plain file names
/// @param script   one of the inputs
/// @param outputs  files that the script writes
/// @throws IoError in one line if gnuplot is missing, fails (with what it said), or leaves an output unwritten
GnuplotResult run_gnuplot(const NamedFiles& inputs, const std::string& script, const std::vector<std::string>& outputs);

}  // namespace nacre
