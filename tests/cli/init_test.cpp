// The first scene that `nacre init` writes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program.h"

namespace nacre::test {
namespace {

ProgramResult run(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
    return run_nacre(arguments, {folder.path(), {}, {}, {}});
}

TEST(Init, WritesASceneThatBakesWithoutWarnings) {
    const TemporaryFolder folder;
    const ProgramResult written = run(folder, {"init"});
    ASSERT_EQ(written.exit_code, 0) << written.err;
    EXPECT_EQ(written.out, "first.toml: written; look at it with nacre swatch first.toml -o out\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"first.toml"});
    const ProgramResult baked = run(folder, {"bake", "first.toml", "-o", "out", "--strict"});
    EXPECT_EQ(baked.exit_code, 0);
    EXPECT_EQ(baked.err, "");
    for (const char* file : {"first.exr", "first.json", "first.preview.png", "first_picks.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / file)) << file;
}

// A # without a space behind it switches a line off.
TEST(Init, LinesThatItLeavesOutMakeASceneToo) {
    const TemporaryFolder folder;
    ASSERT_EQ(run(folder, {"init", "hero"}).exit_code, 0);
    std::istringstream lines(file_bytes(folder.path() / "hero.toml"));
    std::string all;
    int used = 0;
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 120u) << line;
        const std::size_t hash = line.find_first_not_of(' ');
        const bool is_off = hash + 1 < line.size() && line[hash] == '#' && line[hash + 1] != ' ';
        if (is_off) line.erase(hash, 1);
        used += is_off ? 1 : 0;
        all += line + "\n";
    }
    EXPECT_EQ(used, 12);
    folder.file("all.toml", all);
    const ProgramResult plan = run(folder, {"plan", "all.toml", "--json"});
    ASSERT_EQ(plan.exit_code, 0) << plan.err;
    const auto luts = nlohmann::json::parse(plan.out)["luts"];
    ASSERT_EQ(luts.size(), 2u);
    EXPECT_EQ(luts[0]["lut"], "hero");
    EXPECT_EQ(luts[0]["max_de00"], 0.5);
    EXPECT_EQ(luts[1]["mechanism"], "film");
}

TEST(Init, TakesANameOrAPath) {
    const TemporaryFolder folder;
    EXPECT_EQ(nlohmann::json::parse(run(folder, {"init", "scenes/blue-wing.toml", "--json"}).out)["file"],
              "scenes/blue-wing.toml");
    const std::string scene = file_bytes(folder.path() / "scenes/blue-wing.toml");
    EXPECT_NE(scene.find("[material.blue-wing]"), std::string::npos);
    EXPECT_EQ(scene.find("NAME"), std::string::npos);
    EXPECT_EQ(run(folder, {"plan", "scenes/blue-wing.toml"}).exit_code, 0);
}

TEST(Init, OverwritesNothing) {
    const TemporaryFolder folder;
    folder.file("first.toml", "mine");
    const ProgramResult result = run(folder, {"init"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err,
              "nacre: first.toml: exists already, and nacre does not overwrite a scene; give another name, as in nacre "
              "init first2\n");
    EXPECT_EQ(file_bytes(folder.path() / "first.toml"), "mine");
}

TEST(Init, RefusesANameThatAMaterialCannotHave) {
    const TemporaryFolder folder;
    const ProgramResult result = run(folder, {"init", "my wing"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(
        result.err,
        "nacre: the name \"my wing\" cannot be that of a material; give 1 to 80 characters out of A-Z a-z 0-9 _ - "
        "that do not begin with -\n");
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace nacre::test
