#include "io/scene/scene_file.h"

#include <gtest/gtest.h>

#include "io/scene/curve_csv.h"
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

TEST(CurveCsv, HeadingsCommentsBlanksSeparatorsAndByteOrderMarksAreAccepted) {
    const test::TemporaryFolder folder;
    for (const std::string text : {"400,1\n500,2\n", "# lamp\nwavelength_nm,power\n400,1\n500,2\n",
                                   "\xEF\xBB\xBF"
                                   "nm;power\r\n400;1\r\n500;2\r\n",
                                   " 400 \t 1 \n\n 500 \t +2 \n"}) {
        const SampledCurve curve = read_curve_csv(folder.file("lamp.csv", text));
        EXPECT_EQ(curve, (SampledCurve{{400, 500}, {1, 2}})) << text;
    }
}

TEST(CurveCsv, WhatIsNoCurveIsRefusedWithItsLine) {
    const test::TemporaryFolder folder;
    for (const std::string text : {"", "400,1\n", "400,1\nfive,2\n", "400,1,3\n500,2,3\n", "400,1\n500,inf\n",
                                   "400,1\n500,\n", "500,1\n400,2\n"}) {
        EXPECT_THROW(read_curve_csv(folder.file("lamp.csv", text)), Error) << text;
    }
}

}  // namespace
}  // namespace nacre
