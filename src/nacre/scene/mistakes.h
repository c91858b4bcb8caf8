#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "nacre/base/error.h"
#include "nacre/base/where.h"

namespace nacre {

class Table;

/// A mistake of the user's at a known place of a scene.
class SceneError : public Error {
public:
    SceneError(Where where, const std::string& text) : Error(text), where_(std::move(where)) {}
    const Where& where() const { return where_; }

private:
    Where where_;
};

/// One line of a message, and where it belongs among the others.
struct Mistake {
    Where where;
    std::string text;
};

/// How many mistakes one message lists. Chosen: a screenful.
inline constexpr std::size_t most_shown_mistakes = 20;

/// Throws one Error with everything that was noted in a table and the tables in it: a line each, by file, line and
/// column, every text once, at most 20 lines and the number of those left out. Does nothing if nothing was noted.
void throw_mistakes(const Table& table);

/// What was noted by Table::warn() in a table and the tables in it: a line each, in the same order, every text once.
std::vector<std::string> noted_warnings(const Table& table);

/// Throws one Error of these lines, of which it shows as many; does nothing if there are none.
void throw_lines(const std::vector<std::string>& lines);

}  // namespace nacre
