// All mistakes of a scene in one message.
//
// Reading goes on after a mistake, so that one run reports them all. Two rules keep mistakes from causing others:
// - A number that is missing or wrong is noted, and reading continues with an allowed number (Table::number()). Any
//   other mistake ends the part that is being read: attempt() notes it and returns false.
// - Checks that compare several keys, and everything that is made of what was read, wait until Table::is_good() says
//   that each key is right by itself. A LUT of a material with a mistake says nothing about that material.
#include "nacre/scene/mistakes.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "nacre/scene/table.h"

namespace nacre {
namespace {

std::tuple<const std::string&, int, int> place_of(const Mistake& mistake) {
    return {mistake.where.file, mistake.where.line, mistake.where.column};
}

std::vector<std::string> lines_by_place(std::vector<Mistake> mistakes) {
    std::stable_sort(mistakes.begin(), mistakes.end(),
                     [](const Mistake& a, const Mistake& b) { return place_of(a) < place_of(b); });
    std::vector<std::string> lines;
    std::set<std::string> known;
    for (Mistake& mistake : mistakes) {
        if (known.insert(mistake.text).second) lines.push_back(std::move(mistake.text));
    }
    return lines;
}

}  // namespace

void throw_mistakes(const Table& table) {
    std::vector<Mistake> mistakes;
    table.collect_mistakes(mistakes);
    throw_lines(lines_by_place(std::move(mistakes)));
}

std::vector<std::string> noted_warnings(const Table& table) {
    std::vector<Mistake> warnings;
    table.collect_warnings(warnings);
    return lines_by_place(std::move(warnings));
}

void throw_lines(const std::vector<std::string>& lines) {
    if (lines.empty()) return;
    std::string message = lines.front();
    for (std::size_t i = 1; i < std::min(lines.size(), most_shown_mistakes); ++i) message += "\n" + lines[i];
    if (lines.size() > most_shown_mistakes)
        message += "\n... and " + std::to_string(lines.size() - most_shown_mistakes) + " more";
    throw Error(message);
}

}  // namespace nacre
