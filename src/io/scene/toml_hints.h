#pragma once

#include <string>
#include <string_view>

namespace nacre {

/// Whether bytes are text in UTF-16: a byte order mark, or a zero byte next to the first character.
bool is_utf16(std::string_view bytes);

/// What to write instead, of mistakes in TOML that are easily made: "a colour needs quotes, because # begins a comment;
/// write colour = "#22cc66" instead of colour = #22cc66". Empty for a line that has none of them.
/// @param line     where the parser stopped
/// @param message  the parser's
std::string toml_hint(std::string_view line, std::string_view message);

}  // namespace nacre
