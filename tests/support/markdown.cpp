#include "support/markdown.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <regex>
#include <span>
#include <sstream>

namespace nacre::test {
namespace {

std::string anchor_of(const std::string& heading) {
    std::string anchor;
    for (const char letter : heading) {
        const auto byte = static_cast<unsigned char>(letter);
        if (letter == ' ') anchor += '-';
        if (letter == '-' || letter == '_' || byte >= 0x80 || std::isalnum(byte) != 0)
            anchor += static_cast<char>(std::tolower(byte));
    }
    return anchor;
}

void read_links(const std::string& line, int number, std::vector<Link>& links) {
    static const std::regex code("`[^`]*`"), link(R"(\]\(([^)\s]+)\))");
    const std::string text = std::regex_replace(line, code, "code");
    for (auto it = std::sregex_iterator(text.begin(), text.end(), link); it != std::sregex_iterator(); ++it)
        links.push_back({(*it)[1], number});
}

// What depends on the machine is replaced by a word; see shows_the_same().
std::string comparable(const std::string& line) {
    static const std::regex time(R"(\b[0-9]+(\.[0-9]+)? (us|ms|s|min)\b)"), share(R"((simulated|saves) +[0-9]+ %)"),
        spaces(" +"), end(" $");
    std::string text = std::regex_replace(line, time, "TIME");
    text = std::regex_replace(text, share, "$1 SHARE");
    text = std::regex_replace(text, spaces, " ");
    return std::regex_replace(text, end, "");
}

std::size_t count_digits(const std::string& number) {
    return static_cast<std::size_t>(
        std::count_if(number.begin(), number.end(), [](unsigned char c) { return std::isdigit(c) != 0; }));
}

// Equal but for the last digits of long decimal numbers; see shows_the_same().
bool are_alike(const std::string& shown, const std::string& printed) {
    static const std::regex decimal(R"([0-9]+\.[0-9]+)");
    if (std::regex_replace(shown, decimal, "N") != std::regex_replace(printed, decimal, "N")) return false;
    auto other = std::sregex_iterator(printed.begin(), printed.end(), decimal);
    for (auto one = std::sregex_iterator(shown.begin(), shown.end(), decimal); one != std::sregex_iterator(); ++one) {
        const std::string a = one->str();
        const std::string b = (other++)->str();
        if (a == b) continue;
        constexpr std::size_t many = 5;
        constexpr double last_digits = 1e-3;
        if (count_digits(a) < many || count_digits(b) < many) return false;
        if (std::abs(std::stod(a) - std::stod(b)) > last_digits * std::stod(a)) return false;
    }
    return true;
}

bool matches(std::span<const std::string> shown, std::span<const std::string> printed) {
    if (shown.empty()) return printed.empty();
    if (shown.front() == "...") {
        for (std::size_t skipped = 0; skipped <= printed.size(); ++skipped) {
            if (matches(shown.subspan(1), printed.subspan(skipped))) return true;
        }
        return false;
    }
    return !printed.empty() && are_alike(comparable(shown.front()), comparable(printed.front())) &&
           matches(shown.subspan(1), printed.subspan(1));
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

MarkdownPage read_markdown(const std::filesystem::path& path) {
    MarkdownPage page;
    page.path = path;
    std::ifstream file(path);
    bool in_block = false;
    for (std::string line; std::getline(file, line);) {
        page.lines.push_back(line);
        const int number = static_cast<int>(page.lines.size());
        if (line.starts_with("```")) {
            in_block = !in_block;
            if (in_block) page.blocks.push_back({line.substr(3), number + 1, {}});
        } else if (in_block) {
            page.blocks.back().lines.push_back(line);
        } else if (line.starts_with("#")) {
            page.anchors.insert(anchor_of(line.substr(line.find_first_not_of("# "))));
        } else if (!line.starts_with("    ")) {
            read_links(line, number, page.links);
        }
    }
    return page;
}

std::vector<ShownCommand> commands_of(const FencedBlock& block) {
    std::vector<ShownCommand> commands;
    int number = block.line;
    for (const std::string& line : block.lines) {
        if (line.starts_with("$ "))
            commands.push_back({line.substr(2), number, {}});
        else if (!commands.empty())
            commands.back().output.push_back(line);
        ++number;
    }
    return commands;
}

bool shows_the_same(const std::vector<std::string>& shown, const std::vector<std::string>& printed) {
    return matches(shown, printed);
}

}  // namespace nacre::test
