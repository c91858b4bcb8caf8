#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// The candidates that a person who typed `wanted` may have meant, nearest first.
///
/// Distance: Levenshtein's, letters of either case equal (ASCII), counted as at most 1 when one of the two names is
/// part of the other ("rec709" and "lin_rec709"). A candidate is offered when its distance is at most 2, or a third of
/// the longer name; a more distant one would not help. Equally near ones are in order of their edits, then in the given
/// order; the same name is offered once.
///
/// @param max_count  length of the answer at most; the answer may be empty
std::vector<std::string> nearest_names(std::string_view wanted, std::span<const std::string> candidates,
                                       std::size_t max_count = 3);

/// What follows "known: ": the nearest names, or the first few of all if no name is near.
std::string known_like(std::string_view wanted, std::span<const std::string> known);

/// "name" with its quotes, as every message shows the user's words: cut after 60 bytes, control characters as "?".
std::string in_quotes(std::string_view name);

/// "a, b, c"
std::string comma_separated(std::span<const std::string> names);

}  // namespace nacre
