#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// One value of a YAML file, and its place.
struct YamlNode {
    enum class Kind { nothing, text, list, map };

    Kind kind = Kind::nothing;
    int line = 0;                   ///< where the value begins, from 1
    int text_line = 0;              ///< of a text: its first line, which for a block is the one behind "key: |"
    std::string text;               ///< of a text, as YAML means it; numbers are texts too
    std::vector<std::string> keys;  ///< of a map: one for each item, all different
    std::vector<YamlNode> items;    ///< of a list or a map

    /// The value of a key of a map; null if there is none.
    const YamlNode* find(std::string_view key) const;
};

/// A text of the user for a message: control characters, line ends among them, become blanks.
std::string printable(std::string_view text);

/// Reads the one document of a YAML file, through yaml-cpp.
///
/// Line ends of any system and a byte order mark are accepted. So are tabs, which YAML forbids as indentation: there
/// they count to the next multiple of eight columns, as editors show them; elsewhere as one blank.
///
/// Throws Error for text that is not YAML, and for things that only a hostile file has: aliases, more than 32 levels,
/// more than 10 000 values, keys that are not words, a second document, zero bytes.
/// @param name  what messages call the file
YamlNode parse_yaml(std::string_view text, const std::string& name);

}  // namespace nacre
