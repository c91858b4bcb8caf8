#pragma once

#include <span>
#include <string>
#include <string_view>

namespace nacre {

/// The American spelling of a key that has one ("colour" -> "color"), which scenes may use as well; else empty.
std::string american_spelling(std::string_view key);

/// Whether two keys are the same or two spellings of one.
bool is_same_key(std::string_view a, std::string_view b);

/// The key that a person who wrote `wrong` may have meant: what the key is called elsewhere ("ior" -> "index"), or the
/// nearest name. Empty if there is none.
std::string meant_key(std::string_view wrong, std::span<const std::string> known);

}  // namespace nacre
