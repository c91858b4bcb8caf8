#pragma once

#include <string>
#include <variant>
#include <vector>

namespace nacre {

/// A value of a TOML text, and where it stands: for editors, which change single values and leave the rest alone.
struct TomlPlace {
    /// From the top: "material.morpho.picks[0].peak_nm". Keys with other characters than letters, digits, _ and - are
    /// in quotes.
    std::string path;
    /// Nothing for an array or a table.
    std::variant<std::monostate, bool, double, std::string> value;
    /// From 1, columns in characters; the end is the place behind the value. Of a table under a heading, the heading.
    int line = 0, column = 0, end_line = 0, end_column = 0;
};

/// Every value, tables and arrays too, in the order of their paths' parents before their children.
///
/// Throws Error as parse_toml() does.
/// @param name  what messages call the text
std::vector<TomlPlace> toml_places(const std::string& text, const std::string& name);

}  // namespace nacre
