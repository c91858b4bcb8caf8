// nacre list: the names that scenes may use.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/scene/shipped_materials.h"
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

TEST(List, AnUnknownListIsAnErrorThatNamesTheKnown) {
    const ProgramResult result = run_nacre({"list", "colours"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("nacre: LIST \"colours\" is unknown; known: mechanisms, "), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("; see nacre list --help\n"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace nacre::test
