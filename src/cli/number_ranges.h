#pragma once

#include <string>
#include <vector>

namespace nacre {

/// Numbers as a command line gives them: "20", or "0:90:5" for 0, 5, ... 90.
/// @param option  for messages: "--angle"
/// @throws Error for anything else, and for more numbers than a table of points may have rows
std::vector<double> numbers_in_ranges(const std::vector<std::string>& words, const std::string& option);

}  // namespace nacre
