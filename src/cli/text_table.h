#pragma once

#include <string>
#include <vector>

namespace nacre {

/// Lines of columns that stand under each other, two spaces apart. The first row is the heading; no trailing blanks.
/// @param right_aligned  per column; columns beyond it are left-aligned
std::vector<std::string> table_lines(const std::vector<std::vector<std::string>>& rows,
                                     const std::vector<bool>& right_aligned = {});

}  // namespace nacre
