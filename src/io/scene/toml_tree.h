#pragma once

#include <string>

#include "nacre/base/where.h"
#include "nacre/scene/table.h"

namespace nacre {

/// TOML text as a table, every value with line and column.
///
/// Limit: 64 levels of nesting. Throws Error for text that is not TOML.
/// @param name  what messages call it
Table parse_toml(const std::string& text, const std::string& name);

/// A single value: TOML, or a string without its quotes, such as #aa2244 or lin_p3d65.
///
/// Throws Error for text that begins like an array, a table or a quoted string and is none.
/// @param heading  of the table that the value is for
/// @param where    the place of the value, and of everything in it
Value parse_value(const std::string& text, const std::string& heading, const Where& where);

}  // namespace nacre
