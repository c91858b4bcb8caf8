// The pages of the documentation, held to the program.
//
// In a Markdown page a block ```console shows a session: a line that begins with "$ " is a command, and the lines below
// it are what it prints to standard output. Warnings and progress go to standard error and are not shown. All commands
// of a page run in one folder, in their order, in which configs/ and luts/ are those of the repository; each must exit
// with 0. What depends on the machine is not compared: see shows_the_same(). A block ```toml that defines a material is
// a scene that nacre can plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/markdown.h"
#include "support/program.h"

namespace nacre::test {

void PrintTo(const MarkdownPage& page, std::ostream* out);  // gtest calls it
void PrintTo(const MarkdownPage& page, std::ostream* out) {
    *out << page.path.string();
}

namespace {

using Lines = std::vector<std::string>;

const std::filesystem::path root = NACRE_SOURCE_DIR;

// Of the project itself: not those of npm, which are there once the page was built.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (auto entry = std::filesystem::recursive_directory_iterator(folder); entry != end(entry); ++entry) {
        if (entry->path().filename() == "node_modules") {
            entry.disable_recursion_pending();
        } else {
            files.push_back(entry->path());
        }
    }
    return files;
}

std::vector<MarkdownPage> all_pages() {
    std::vector<MarkdownPage> pages{read_markdown(root / "README.md"), read_markdown(root / "CHANGELOG.md")};
    for (const char* folder : {"configs", "luts", "src", "tests"}) {
        for (const auto& file : files_below(root / folder)) {
            if (file.extension() == ".md") pages.push_back(read_markdown(file));
        }
    }
    std::sort(pages.begin(), pages.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return pages;
}

std::string place(const MarkdownPage& page, int line) {
    return std::filesystem::relative(page.path, root).string() + ":" + std::to_string(line);
}

std::string joined(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

// ---- What counts as the same output

TEST(ShownOutput, IsNotTheSameWithAnotherNumber) {
    EXPECT_TRUE(shows_the_same({"a.exr  512 x 1 half  dE00 0.069"}, {"a.exr  512 x 1 half  dE00 0.069"}));
    EXPECT_FALSE(shows_the_same({"a.exr  512 x 1 half  dE00 0.069"}, {"a.exr  512 x 1 half  dE00 0.068"}));
    EXPECT_FALSE(shows_the_same({"25 % of texels"}, {"26 % of texels"}));
}

TEST(ShownOutput, MayDifferInTimesAndSharesOfTime) {
    EXPECT_TRUE(shows_the_same({"morpho  465 us"}, {"morpho  1.4 ms"}));
    EXPECT_TRUE(shows_the_same({"tilt  simulated   4 %  asked for"}, {"tilt  simulated  17 %  asked for"}));
    EXPECT_FALSE(shows_the_same({"morpho  465 us"}, {"morpho  465 nm"}));
}

TEST(ShownOutput, MayDifferInTheLastDigitsOfLongNumbers) {
    EXPECT_TRUE(shows_the_same({"index = 1.5715, thickness_nm = 370.52"}, {"index = 1.5713, thickness_nm = 370.59"}));
    EXPECT_FALSE(shows_the_same({"index = 1.5715"}, {"index = 1.5765"}));
    EXPECT_FALSE(shows_the_same({"index = 1.571"}, {"index = 1.572"}));
    EXPECT_FALSE(shows_the_same({"index = 1.5715"}, {"glass = 1.5715"}));
}

TEST(ShownOutput, MayLeaveOutLinesAtThreeDots) {
    EXPECT_TRUE(shows_the_same({"a", "...", "d"}, {"a", "b", "c", "d"}));
    EXPECT_TRUE(shows_the_same({"a", "..."}, {"a"}));
    EXPECT_FALSE(shows_the_same({"a", "...", "d"}, {"a", "b", "c"}));
    EXPECT_FALSE(shows_the_same({"a"}, {"a", "b"}));
}

// ---- Every page

class Documentation : public testing::TestWithParam<MarkdownPage> {};

TEST_P(Documentation, ShowsWhatItsCommandsPrint) {
    const TemporaryFolder folder;
    std::filesystem::create_directory_symlink(root / "configs", folder.path() / "configs");
    std::filesystem::create_directory_symlink(root / "luts", folder.path() / "luts");
    for (const FencedBlock& block : GetParam().blocks) {
        if (block.language != "console") continue;
        for (const ShownCommand& shown : commands_of(block)) {
            SCOPED_TRACE(place(GetParam(), shown.line) + ": " + shown.command);
            const ProgramResult result = run_shell(shown.command, {folder.path(), {}, {}, {}});
            EXPECT_EQ(result.exit_code, 0) << result.err;
            EXPECT_TRUE(shows_the_same(shown.output, lines_of(result.out)))
                << "the page shows:\n"
                << joined(shown.output) << "the program prints:\n"
                << result.out;
        }
    }
}

TEST_P(Documentation, ShowsScenesThatCanBePlanned) {
    const TemporaryFolder folder;
    std::filesystem::copy(root / "configs/scenes/gold_beetle.csv", folder.path() / "gold_beetle.csv");
    for (const FencedBlock& block : GetParam().blocks) {
        const std::string text = joined(block.lines);
        if (block.language != "toml" || text.find("[material.") == std::string::npos) continue;
        SCOPED_TRACE(place(GetParam(), block.line));
        const ProgramResult result = run_nacre({"plan", folder.file("scene.toml", text)});
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
}

TEST_P(Documentation, HasLinksThatLeadSomewhere) {
    for (const Link& link : GetParam().links) {
        if (link.target.find("://") != std::string::npos) continue;
        SCOPED_TRACE(place(GetParam(), link.line) + ": " + link.target);
        const std::size_t hash = link.target.find('#');
        const std::string file = link.target.substr(0, hash);
        const std::filesystem::path path = file.empty() ? GetParam().path : GetParam().path.parent_path() / file;
        EXPECT_TRUE(std::filesystem::exists(path));
        if (hash == std::string::npos) continue;
        EXPECT_TRUE(read_markdown(path).anchors.contains(link.target.substr(hash + 1)));
    }
}

std::string name_of_page(const testing::TestParamInfo<MarkdownPage>& info) {
    std::string name = std::filesystem::relative(info.param.path, root).replace_extension().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '/' || c == '.' || c == '-'; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Page, Documentation, testing::ValuesIn(all_pages()), name_of_page);

// ---- The pages on mechanisms

// Whether a line begins like this and contains the word.
bool has_line(const Lines& lines, const std::string& begin, const std::string& word) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
        return line.substr(0, begin.size()) == begin && line.find(word) != std::string::npos;
    });
}

TEST(MechanismPages, NameEveryMechanism) {
    const Lines first_page = read_markdown(root / "configs/README.md").lines;
    const Lines page = read_markdown(root / "configs/mechanisms.md").lines;
    const Lines listed = lines_of(run_nacre({"list", "mechanisms"}).out);
    EXPECT_FALSE(listed.empty());
    for (const std::string& line : listed) {
        const std::string name = line.substr(0, line.find(' '));
        EXPECT_TRUE(has_line(first_page, "| `mechanism` |", name)) << "configs/README.md: " << name;
        EXPECT_TRUE(has_line(page, "| [", name)) << "configs/mechanisms.md: " << name;
    }
}

TEST(MechanismPages, NameEveryMechanismThatPicksCanLeadTo) {
    const std::string refusal = run_nacre({"pick", "#123@0", "--mechanism", "scatter"}).err;
    const std::string before = "allowed for palette, ";
    const std::size_t found = refusal.find(before);
    ASSERT_NE(found, std::string::npos) << refusal;
    const Lines page = read_markdown(root / "configs/picking.md").lines;
    const Lines help = lines_of(run_nacre({"pick", "--help"}).out);
    std::string names = lines_of(refusal.substr(found + before.size())).front() + ", ";
    for (; !names.empty(); names.erase(0, names.find(", ") + 2)) {
        const std::string name = names.substr(0, names.find(", "));
        EXPECT_TRUE(has_line(page, "| " + name + " |", "")) << "configs/picking.md: " << name;
        EXPECT_TRUE(has_line(help, "  " + name + " ", "")) << "nacre pick --help: " << name;
    }
}

// ---- The page about the code

// `scene/plan.h` is in src/nacre; `plan.h` alone may be in any folder of src and tests. NAME stands for a name that the
// reader chooses.
TEST(PageAboutTheCode, NamesFilesThatExist) {
    std::set<std::string> names;
    for (const char* folder : {"src", "tests"}) {
        for (const auto& file : files_below(root / folder)) names.insert(file.filename().string());
    }
    const auto exists = [&](const std::string& file) {
        for (const auto& folder : {root, root / "src", root / "src/nacre"}) {
            if (std::filesystem::exists(folder / file)) return true;
        }
        return names.contains(file);
    };
    const std::regex path("`([\\w./-]*\\w\\.(h|cpp|cmake|txt|json|md|sh|awk|yml|toml|glsl|hlsl))`");
    const MarkdownPage page = read_markdown(root / "src/README.md");
    int named = 0;
    for (std::size_t i = 0; i < page.lines.size(); ++i) {
        const std::string& line = page.lines[i];
        for (auto it = std::sregex_iterator(line.begin(), line.end(), path); it != std::sregex_iterator(); ++it) {
            const std::string file = (*it)[1];
            if (file.find("NAME") != std::string::npos) continue;
            EXPECT_TRUE(exists(file)) << place(page, static_cast<int>(i) + 1) << ": " << file;
            ++named;
        }
    }
    EXPECT_GT(named, 0);
}

// ---- The first page

TEST(Readme, IsOnePage) {
    EXPECT_LE(read_markdown(root / "README.md").lines.size(), 150U);
}

TEST(Readme, ShowsASessionFromAPickToATexture) {
    std::string commands;
    for (const FencedBlock& block : read_markdown(root / "README.md").blocks) {
        for (const ShownCommand& shown : commands_of(block)) commands += shown.command + "\n";
    }
    for (const char* command : {"nacre pick ", "nacre swatch ", "nacre bake "})
        EXPECT_NE(commands.find(command), std::string::npos) << command;
}

}  // namespace
}  // namespace nacre::test
