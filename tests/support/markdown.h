#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace nacre::test {

/// A fenced block of a Markdown page: what stands between ```LANGUAGE and ```.
struct FencedBlock {
    std::string language;
    int line = 0;  ///< of its first line, counted from 1
    std::vector<std::string> lines;
};

/// A command of a `console` block and the output that the page shows below it.
struct ShownCommand {
    std::string command;
    int line = 0;
    std::vector<std::string> output;
};

/// A link `[text](target)` outside code.
struct Link {
    std::string target;
    int line = 0;
};

struct MarkdownPage {
    std::filesystem::path path;
    std::vector<std::string> lines;
    std::vector<FencedBlock> blocks;
    std::vector<Link> links;
    std::set<std::string> anchors;  ///< of its headings, as GitHub spells them: "## A `b` c" is "a-b-c"
};

MarkdownPage read_markdown(const std::filesystem::path& path);

/// The commands of a block: lines that begin with "$ ", each with the lines up to the next command.
std::vector<ShownCommand> commands_of(const FencedBlock& block);

std::vector<std::string> lines_of(const std::string& text);

/// True if a program printed what a page shows. They are compared line by line, except for what depends on the machine:
///   - a time (a number and us, ms, s or min) equals any other time;
///   - a share of the time in a table of effects ("simulated  24 %", "saves 79 %") equals any other share;
///   - decimal numbers of five digits and more may differ by a thousandth, because a search's last digits depend on the
///     compiler;
///   - spaces count as one, because the width of a column depends on the two above;
///   - the line "..." stands for any number of lines, or none.
bool shows_the_same(const std::vector<std::string>& shown, const std::vector<std::string>& printed);

}  // namespace nacre::test
