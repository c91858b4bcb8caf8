#include "io/scene/variants.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "support/folders.h"

namespace nacre {
namespace {

// "ruby: key = value; key = value\n" of each variant.
std::string text_of(const std::vector<Variant>& variants) {
    std::string text;
    for (const Variant& variant : variants) {
        text += variant.name + ":";
        for (const SceneEdit& edit : variant.edits) text += " " + edit_text(edit) + ";";
        text += "\n";
    }
    return text;
}

std::string message_of(const std::string& scene) {
    try {
        read_variants(parse_scene(scene, "s.toml"));
    } catch (const Error& error) {
        return error.what();
    }
    return "was accepted";
}

TEST(Variants, OfATableMayWriteKeysInQuotesWithDotsOrAsHeadings) {
    const Table scene = parse_scene(
        "[variants]\nplain = {}\nruby = { \"material.hero.picks[0].colour\" = \"#aa2244\", material.hero.shape = 0.5 "
        "}\n"
        "gold.accuracy.max_de00 = 1\ngold.\"material.hero.picks[1]\" = { angle_deg = 55 }\n"
        "[variants.teal.material.hero]\nshape = 0.25\n",
        "s.toml");
    const std::vector<Variant> variants = read_variants(scene);
    EXPECT_EQ(text_of(variants),
              "plain:\n"
              "ruby: material.hero.picks[0].colour = \"#aa2244\"; material.hero.shape = 0.5;\n"
              "gold: accuracy.max_de00 = 1; material.hero.picks[1] = { angle_deg = 55 };\n"
              "teal: material.hero.shape = 0.25;\n");
    EXPECT_EQ(variants[1].where.text(), "s.toml:3:1");
    EXPECT_EQ(variants[1].edits[1].where.text(), "s.toml:3:77");
    EXPECT_TRUE(read_variants(parse_scene("[material.m]\n", "s.toml")).empty());
}

TEST(Variants, OfACsvTakeValuesAsSetDoesAndLeaveOutEmptyFields) {
    const test::TemporaryFolder folder;
    const test::CurrentFolder here(folder.path());
    folder.file("parts/looks.csv",
                "# looks\nname,material.hero.picks[0].colour,\"material.hero.picks[1]\",accuracy.max_de00\n"
                "teal,#118877,,0.5\n amber , \"#dd8811\" ,\"{ angle_deg = 60, colour = \"\"#804000\"\" }\"\n");
    folder.file("parts/s.toml", "variants = \"looks.csv\"\n");
    const std::vector<Variant> variants = read_variants(read_scene_file("parts/s.toml"));
    EXPECT_EQ(text_of(variants),
              "teal: material.hero.picks[0].colour = \"#118877\"; accuracy.max_de00 = 0.5;\n"
              "amber: material.hero.picks[0].colour = \"#dd8811\"; material.hero.picks[1] = { angle_deg = 60, colour = "
              "\"#804000\" };\n");
    EXPECT_EQ(variants[0].where.text(), "parts/looks.csv:3:1");
    EXPECT_EQ(variants[0].edits[1].where.text(), "parts/looks.csv:3:15");
}

TEST(Variants, ThatAreNoneSayWhatIsAllowed) {
    const test::TemporaryFolder folder;
    const test::CurrentFolder here(folder.path());
    folder.file("empty.csv", "name,a\n");
    folder.file("column.csv", "look,a\nruby,1\n");
    folder.file("wide.csv", "name,a\nruby,1,2\n");
    folder.file("name.csv", "name,a\na/b,1\n");
    folder.file("broken.csv", "name,a\nruby,[1\n");
    for (const auto& [scene, message] : std::vector<std::pair<std::string, std::string>>{
             {"variants = 3", "s.toml:1:12: variants = 3 is a whole number; give the name of a CSV file, or a table"},
             {"[variants]", "s.toml:1:1 [variants]: there are no variants; write NAME = { \"KEY\" = VALUE }"},
             {"[variants]\nruby = 3", "s.toml:2:8 [variants]: ruby = 3 is a whole number; give a table"},
             {"variants = \"no.csv\"", "s.toml:1:12: no.csv: cannot be opened: No such file or directory"},
             {"variants = \"empty.csv\"", "empty.csv: has no variants; give a heading and a row for each"},
             {"variants = \"column.csv\"",
              "column.csv:1: the first column is \"look\"; it has to be name, and the others keys such as "
              "material.hero.picks[0].colour"},
             {"variants = \"wide.csv\"", "wide.csv:2: has 3 columns; the heading has 2"},
             {"variants = \"broken.csv\"",
              "broken.csv:2:6: not TOML: Error while parsing array: encountered end-of-file"}}) {
        EXPECT_EQ(message_of(scene), message);
    }
    for (const std::string scene : {"[variants]\n\"a/b\" = {}", "variants = \"name.csv\""}) {
        EXPECT_NE(message_of(scene).find("the name \"a/b\" cannot be the name of a file"), std::string::npos)
            << message_of(scene);
    }
}

}  // namespace
}  // namespace nacre
