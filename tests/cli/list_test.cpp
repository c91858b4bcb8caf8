// nacre list: the names that scenes may use.
#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "io/scene/shipped_materials.h"
#include "reference/csv.h"
#include "support/folders.h"
#include "support/program.h"

namespace nacre::test {
namespace {

TEST(List, NamesEveryMaterialWithHalfALine) {
    const ProgramResult result = run_nacre({"list", "materials"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    for (const std::string& name : shipped_material_names())
        EXPECT_NE(("\n" + result.out).find("\n" + name + " "), std::string::npos) << name;
    EXPECT_NE(result.out.find("water      water, 20 C\n"), std::string::npos) << result.out;
}

TEST(List, NamesWhatTheCoreKnows) {
    EXPECT_NE(run_nacre({"list", "mechanisms"}).out.find("grating"), std::string::npos);
    EXPECT_NE(run_nacre({"list", "illuminants"}).out.find("D65 "), std::string::npos);
    EXPECT_NE(run_nacre({"list", "axes"}).out.find("sqrt_cos_theta"), std::string::npos);
}

TEST(List, TakesSpacesAndDisplaysFromTheConfigInForce) {
    const ProgramResult ours = run_nacre({"list", "spaces"});
    EXPECT_NE(ours.out.find("lin_rec709 "), std::string::npos) << ours.out;
    EXPECT_EQ(run_nacre({"list", "displays"}).out,
              "sRGB        views: Standard, Raw\nRec.1886    views: Standard, Raw\n"
              "Display P3  views: Standard, Raw\n");
    const std::string theirs = std::string(NACRE_SOURCE_DIR) + "/tests/io/ocio/wrong_white.ocio";
    const ProgramResult of_file = run_nacre({"list", "spaces", "--ocio", theirs});
    EXPECT_EQ(of_file.exit_code, 0) << of_file.err;
    EXPECT_EQ(of_file.out.find("lin_p3d65"), std::string::npos) << of_file.out;
    EXPECT_EQ(run_nacre({"list", "spaces"}, {{}, {{"OCIO", theirs}}, {}, {}}).out, of_file.out);
}

TEST(List, AsJsonIsAListOfNamesAndDescriptions) {
    const auto json = nlohmann::json::parse(run_nacre({"list", "gamuts", "--json"}).out);
    EXPECT_EQ(json["list"], "gamuts");
    EXPECT_EQ(json["names"][0]["name"], "keep");
    EXPECT_FALSE(json["names"][0]["description"].get<std::string>().empty());
}

TEST(List, WithoutANamePrintsAllListsAndWhereTheirNamesGo) {
    const ProgramResult result = run_nacre({"list"});
    EXPECT_EQ(result.exit_code, 0);
    for (const char* list : {"materials", "spaces", "displays", "illuminants", "mechanisms", "axes"})
        EXPECT_NE(("\n" + result.out).find("\n" + std::string(list) + " "), std::string::npos) << list;
}

TEST(List, OfMetalsHasTheirColoursForARenderer) {
    const ProgramResult result = run_nacre({"list", "metals"});
    EXPECT_EQ(result.out.find("metal  space       F0  "), 0u) << result.out;
    EXPECT_NE(result.out.find("\nau     lin_ap1 "), std::string::npos) << result.out;
    const auto json = nlohmann::json::parse(run_nacre({"list", "metals", "--json"}).out);
    EXPECT_EQ(json["list"], "metals");
    EXPECT_EQ(json["names"].size(), 15u);
    EXPECT_EQ(json["names"][0]["name"], "ag");
    EXPECT_EQ(json["names"][0]["description"], "silver");
    EXPECT_EQ(json["names"][0]["f0"].size(), 3u);
    EXPECT_GT(json["names"][0]["schlick_de00"], json["names"][0]["f82_de00"]);
}

TEST(List, AnUnknownListIsAnErrorThatNamesTheKnown) {
    const ProgramResult result = run_nacre({"list", "colours"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("nacre: LIST \"colours\" is unknown; known: mechanisms, "), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("; see nacre list --help\n"), std::string::npos) << result.err;
}

// ---- the CIE's tables

using Row = std::vector<double>;

std::vector<Row> numbers_of_csv(const std::string& csv) {
    std::vector<Row> rows;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);  // the heading
    while (std::getline(lines, line)) {
        Row& row = rows.emplace_back();
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
    }
    return rows;
}

TEST(ListTable, OfAnObserverIsThatOfTheCie) {
    for (const std::string observer : {"cie1931_2deg", "cie1964_10deg"}) {
        const ProgramResult result = run_nacre({"list", "observers", observer});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.out.substr(0, result.out.find('\n')), "wavelength_nm,x_bar,y_bar,z_bar");
        const reference::Csv table = reference::read_csv("cmf_" + observer + "_1nm.csv");
        const std::vector<Row> rows = numbers_of_csv(result.out);
        ASSERT_EQ(rows.size(), table.rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            for (std::size_t j = 0; j < 4; ++j) EXPECT_EQ(rows[i].at(j), table.number(i, table.names[j])) << i;
        }
    }
}

TEST(ListTable, OfAnIlluminantIsThatOfTheCie) {
    const reference::Csv table = reference::read_csv("illuminants_5nm.csv");
    for (const std::string name : {"D65", "D50", "A", "FL11"}) {
        const ProgramResult result = run_nacre({"list", "illuminants", name});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.out.substr(0, result.out.find('\n')), "wavelength_nm,power");
        std::size_t compared = 0;
        const std::vector<Row> rows = numbers_of_csv(result.out);
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
            for (const Row& row : rows) {
                if (row.at(0) != table.number(i, "wavelength_nm")) continue;
                EXPECT_EQ(row.at(1), table.number(i, name)) << name << " " << row.at(0);
                ++compared;
            }
        }
        EXPECT_EQ(compared, rows.size()) << name;
        EXPECT_GT(compared, 80u) << name;
    }
}

TEST(ListTable, OfAnIlluminantIsALightThatSceneFilesRead) {
    const TemporaryFolder folder;
    const ProgramOptions here{folder.path(), {}, {}, {}};
    const std::string film =
        "[material.f]\nmechanism = \"film\"\nindex = 1.33\nthickness_nm = 400\n[light]\nrange_nm = [380, 780]\n";
    for (const std::string name : {"D65", "FL2"}) {
        folder.file("name.toml", film + "illuminant = \"" + name + "\"\n");
        folder.file("file.toml", film + "illuminant = \"lamp.csv\"\n");
        folder.file("lamp.csv", run_nacre({"list", "illuminants", name}).out);
        const std::string by_name = run_nacre({"spectrum", "name.toml", "--xyz"}, here).out;
        EXPECT_NE(by_name, "");
        EXPECT_EQ(run_nacre({"spectrum", "file.toml", "--xyz"}, here).out, by_name) << name;
    }
}

TEST(ListTable, AsJsonHasItsColumns) {
    const auto json = nlohmann::json::parse(run_nacre({"list", "observers", "cie1931_2deg", "--json"}).out);
    EXPECT_EQ(json["name"], "cie1931_2deg");
    EXPECT_EQ(json["columns"][2], "y_bar");
    EXPECT_EQ(json["rows"][555 - 360][2], 1.0);
}

TEST(ListTable, IsThereForTheNamesOfTwoLists) {
    EXPECT_EQ(run_nacre({"list", "illuminants", "d65"}).err,
              "nacre: unknown illuminant \"d65\"; known: D65, D50, D55, D75, A, E, FL2, FL7, FL11\n");
    EXPECT_EQ(run_nacre({"list", "observers", "D65"}).err,
              "nacre: unknown observer \"D65\"; known: cie1931_2deg, cie1964_10deg\n");
    EXPECT_EQ(run_nacre({"list", "axes", "cos_theta"}).err,
              "nacre: the names of \"axes\" have no tables of numbers; illuminants and observers have\n");
    EXPECT_EQ(run_nacre({"list", "observers", "cie1931_2deg", "D65"}).err,
              "nacre: unexpected argument \"D65\"; see nacre list --help\n");
}

}  // namespace
}  // namespace nacre::test
