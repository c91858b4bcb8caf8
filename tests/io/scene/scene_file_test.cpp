#include "io/scene/scene_file.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "io/scene/csv_table.h"
#include "nacre/base/error.h"
#include "support/folders.h"

namespace nacre {
namespace {

TEST(SceneFile, ValuesKeepTheirPlaceAndTheOrderInWhichTheyWereWritten) {
    const Table table = parse_scene("z = 1\n\n[material.b]\nx = 2.5\n[material.a]\n", "s.toml");
    ASSERT_EQ(table.entries().size(), 2u);
    EXPECT_EQ(table.entries()[0].key, "z");
    EXPECT_EQ(table.entries()[0].value.where.text(), "s.toml:1:5");
    const Table* materials = table.table("material");
    ASSERT_NE(materials, nullptr);
    EXPECT_EQ(materials->entries()[0].key, "b");
    EXPECT_EQ(materials->entries()[0].key_where.line, 3);
    EXPECT_EQ(materials->table("b")->path(), "material.b");
}

TEST(SceneFile, NestingHasALimitAndNoCrash) {
    const std::string deep = "a = " + std::string(200, '[') + std::string(200, ']') + "\n";
    EXPECT_THROW(parse_scene(deep, "s.toml"), Error);
    const std::string deeper = "a = " + std::string(100000, '[');
    EXPECT_THROW(parse_scene(deeper, "s.toml"), Error);
    std::string dotted = "a";
    for (int i = 0; i < 100000; ++i) dotted += ".a";
    EXPECT_THROW(parse_scene(dotted + " = 1\n", "s.toml"), Error);
    EXPECT_THROW(parse_scene("[" + dotted + "]\n", "s.toml"), Error);
}

TEST(SceneFile, SceneOfALutIsAFixedPoint) {
    const std::string text =
        "[material.\"m.1\"]\nshape = 0.3\npicks = [ { angle_deg = 0.1, peak_nm = 460, width_nm = 70, height = 0.25 }, "
        "{ angle_deg = 40, peak_nm = 395.5, width_nm = 60, height = 1e-3 } ]\n"
        "[light]\nilluminant = { name = \"lamp\", wavelength_nm = [300, 555.5, 900], power = [0.1, 1, 3] }\nobserver = "
        "\"cie1964_10deg\"\n"
        "adapt = \"none\"\nrange_nm = [400, 700]\n[accuracy]\nwavelengths = 77\n[colour]\nspace = \"a \\\"b\\\" \\\\ "
        "c\"\ngamut = \"clip\"\n"
        "[lut.\"x.y\"]\nx = { parameter = \"picks[1].peak_nm\", from = 400, to = 500 }\ny = { parameter = \"shape\", "
        "from = 1, to = 0 }\n"
        "size = [4, 8]\nangle_deg = 33.3\nformat = \"float\"\n";
    const Plan plan = plan_scene(parse_scene(text, "s"), scene_files());
    ASSERT_EQ(plan.luts.size(), 1u);
    const std::string once = scene_toml(plan.luts[0]);
    const Plan again = plan_scene(parse_scene(once, "header"), scene_files());
    EXPECT_EQ(scene_toml(again.luts[0]), once);
    EXPECT_EQ(again.light->settings.power, plan.light->settings.power);
    EXPECT_EQ(again.light->settings.first_nm, 400);
    EXPECT_EQ(again.luts[0].job.fixed.incidence.theta_deg, 33.3);
    EXPECT_EQ(again.luts[0].job.width, 4);
    EXPECT_EQ(again.luts[0].job.y->from, 1.0);
    EXPECT_EQ(std::get<Palette>(again.luts[0].job.material.mechanism),
              std::get<Palette>(plan.luts[0].job.material.mechanism));
    EXPECT_EQ(again.colour.space, "a \"b\" \\ c");
}

// The keys of a material, in their order.
std::vector<std::string> keys_of(const Table& scene, const std::string& material) {
    std::vector<std::string> keys;
    for (const Table::Entry& entry : scene.table("material")->table(material)->entries()) keys.push_back(entry.key);
    return keys;
}

std::vector<std::string> materials_of(const Table& scene) {
    std::vector<std::string> names;
    for (const Table::Entry& entry : scene.table("material")->entries()) names.push_back(entry.key);
    return names;
}

std::string message_of(const std::string& path) {
    try {
        read_scene_file(path);
    } catch (const Error& error) {
        return error.what();
    }
    return "was accepted";
}

TEST(SceneFile, IncludesWhatAPatternMatchesInTheOrderOfNames) {
    const test::TemporaryFolder folder;
    for (const std::string name : {"b", "a", "c"}) {
        folder.file("p[1]/" + name + ".toml", "[material." + name + "]\nshape = 1\n");
        folder.file("p[1]/" + name + ".txt", "no TOML");
    }
    folder.file("p[1]/[x].toml", "[material.literal]\nshape = 1\n");
    const test::CurrentFolder here(folder.path());
    folder.file("s.toml", "include = \"p[[]1]/?.toml\"\n[material.z]\n");
    EXPECT_EQ(materials_of(read_scene_file("s.toml")), (std::vector<std::string>{"a", "b", "c", "z"}));
    folder.file("p[1]/s.toml", "include = [\"[ab].toml\", \"[x].toml\"]\n");
    EXPECT_EQ(materials_of(read_scene_file("p[1]/s.toml")), (std::vector<std::string>{"a", "b", "literal"}))
        << "the folder of the scene is no pattern, and neither is the name of a file that there is";
    folder.file("p[1]/all.toml", "include = \"*[bl].toml\"\n[material.self]\n");
    EXPECT_EQ(materials_of(read_scene_file("p[1]/all.toml")), (std::vector<std::string>{"b", "self"}))
        << "a pattern does not match the scene itself";
}

TEST(SceneFile, PatternThatMatchesNothingIsAMistake) {
    const test::TemporaryFolder folder;
    const test::CurrentFolder here(folder.path());
    folder.file("s.toml", "include = [ \"parts/*.toml\" ]\n");
    EXPECT_EQ(message_of("s.toml"), "s.toml:1:13: include of \"parts/*.toml\" matches no file");
}

TEST(SceneFile, OverridesAnIncludedFileKeyByKeyIfItSaysSo) {
    const test::TemporaryFolder folder;
    const test::CurrentFolder here(folder.path());
    folder.file("base.toml",
                "nacre = 1\n[light]\nilluminant = \"A\"\nadapt = \"cat16\"\n"
                "[material.a]\nshape = 0.5\nbase = { grey = 0.5 }\n[material.b]\nshape = 0.5\n");
    const std::string own =
        "[light]\nilluminant = \"D50\"\n[material.a]\nbase = { rgb = [1, 1, 1] }\ntilt_deg = 3\n[material.c]\n";
    folder.file("s.toml", "nacre = 1\ninclude = { file = \"base.toml\", override = true }\n" + own);
    const Table scene = read_scene_file("s.toml");
    EXPECT_EQ(scene.table("light")->text("illuminant"), "D50");
    EXPECT_EQ(scene.table("light")->find("illuminant")->where.text(), "s.toml:4:14");
    EXPECT_EQ(scene.table("light")->text("adapt"), "cat16");
    EXPECT_EQ(materials_of(scene), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(keys_of(scene, "a"), (std::vector<std::string>{"shape", "base", "tilt_deg"}));
    const Table* base = scene.table("material")->table("a")->table("base");
    EXPECT_EQ(base->find("grey"), nullptr) << "a value in braces is replaced as a whole";
    EXPECT_NE(base->find("rgb"), nullptr);

    folder.file("s.toml", "include = \"base.toml\"\n" + own);
    EXPECT_EQ(message_of("s.toml"), "s.toml:3:1 [light]: illuminant is already given at base.toml:3:1; give it once");
    // What is overridden is the included file, whichever other file says so.
    folder.file("own.toml", own);
    folder.file("s.toml", "include = [ \"own.toml\", { file = \"base.toml\", override = true } ]\n");
    EXPECT_EQ(read_scene_file("s.toml").table("light")->text("illuminant"), "D50");
    folder.file("s.toml", "include = [ \"base.toml\", { file = \"own.toml\", override = true } ]\n");
    EXPECT_EQ(read_scene_file("s.toml").table("light")->text("illuminant"), "A");
}

TEST(SceneFile, MistakesInIncludeSayWhatIsAllowed) {
    const test::TemporaryFolder folder;
    const test::CurrentFolder here(folder.path());
    for (const auto& [include, message] : std::vector<std::pair<std::string, std::string>>{
             {"3",
              "s.toml:1:11: include = 3 is a whole number; give the name of a file, or { file = \"NAME\", override "
              "= true }"},
             {"{ file = \"a.toml\", override = 1 }", "s.toml:1:41: override = 1 is a whole number; give true or false"},
             {"{ override = true }", "s.toml:1:11: file is missing; it is required"},
             {"{ file = \"a.toml\", overide = true }",
              "s.toml:1:30: unknown key \"overide\"; did you mean override?"}}) {
        folder.file("s.toml", "include = " + include + "\n");
        EXPECT_EQ(message_of("s.toml"), message);
    }
}

TEST(CurveCsv, HeadingsCommentsBlanksSeparatorsAndByteOrderMarksAreAccepted) {
    const test::TemporaryFolder folder;
    for (const std::string text :
         {"400,1\n500,2\n", "# lamp\nwavelength_nm,power\n400,1\n500,2\n", "\xEF\xBB\xBFnm;power\r\n400;1\r\n500;2\r\n",
          " 400 \t 1 \n\n 500 \t +2 \n", "500,2\n400,1\n",
          "Lamp 3; 2024\nOperator: A, B\nWellenlaenge;Wert\n400;1,0\n500;2,0\n"}) {
        const SampledCurve curve = read_curve_csv(folder.file("lamp.csv", text));
        EXPECT_EQ(curve, (SampledCurve{{400, 500}, {1, 2}})) << text;
    }
}

TEST(CurveCsv, WhatIsNoCurveIsRefusedWithItsLine) {
    const test::TemporaryFolder folder;
    for (const std::string text : {"", "400,1\n", "400,1\nfive,2\n", "400,1,3\n500,2,3\n", "400,1\n500,inf\n",
                                   "400,1\n500,\n", "400,1\n500,2\n450,2\n", "4OO,1\n500,2\n600,3\n"}) {
        EXPECT_THROW(read_curve_csv(folder.file("lamp.csv", text)), Error) << text;
    }
}

TEST(CurveCsv, SeveralColumnsNeedAChoice) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("lamps.csv", "wl;LED 1;LED 2\n400;1;-0,01\n500;2;4\n");
    EXPECT_EQ(read_curve_csv(path, {.column = "LED 2", .clips_negative = true}), (SampledCurve{{400, 500}, {0, 4}}));
    EXPECT_EQ(read_curve_csv(path, {.column = "LED 2"}), (SampledCurve{{400, 500}, {-0.01, 4}}));
    try {
        read_curve_csv(path);
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), path +
                                    ":1:10: the table has several columns of values; choose one with column = \"LED "
                                    "1\" in the scene");
    }
}

}  // namespace
}  // namespace nacre
