// `nacre figures`: the paper's figures as data, scripts and plots.
#include <gtest/gtest.h>

#include "support/program.h"

namespace nacre::test {
namespace {

TEST(Figures, DataScriptAndPlotOfEveryFigureAreWritten) {
    const TemporaryFolder folder;
    const ProgramResult result = run_nacre({"figures", "-o", folder.path().string()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::vector<std::string> names = folder.names();
    for (const std::string plot :
         {"figure5", "figure7", "figure8", "figure9", "figure14", "stacks_morpho", "stacks_beetle", "study", "bands"}) {
        EXPECT_TRUE(std::filesystem::exists(folder.path() / (plot + ".png"))) << plot;
        EXPECT_TRUE(std::filesystem::exists(folder.path() / (plot + ".gp"))) << plot;
    }
    for (const std::string picture : {"figure11_morpho", "figure11_beetle", "figure12_morpho", "figure12_beetle"}) {
        EXPECT_TRUE(std::filesystem::exists(folder.path() / (picture + ".png"))) << picture;
        EXPECT_TRUE(std::filesystem::exists(folder.path() / (picture + ".csv"))) << picture;
    }
    for (const std::string specimen : {"stacks_morpho", "stacks_beetle"}) {
        for (const std::string data : {"", "_spectra", "_table", "_summary"})
            EXPECT_TRUE(std::filesystem::exists(folder.path() / (specimen + data + ".csv"))) << specimen << data;
    }
    const std::string readme = file_bytes(folder.path() / "README.md");
    EXPECT_NE(readme.find("| 16 layers, 1.6/1.7 | 60° | 460.00 |"), std::string::npos);
    EXPECT_NE(readme.find("**Verdict.**"), std::string::npos);
    // The table of the automatic user, as the documentation has it.
    const std::string page = file_bytes(std::filesystem::path(NACRE_SOURCE_DIR) / "configs/mechanisms.md");
    const std::size_t table = readme.find("| targets made by |");
    ASSERT_NE(table, std::string::npos);
    EXPECT_NE(page.find(readme.substr(table, readme.find("\n\n", table) - table)), std::string::npos);
    for (const std::string& name : names) {
        const std::string bytes = file_bytes(folder.path() / name);
        EXPECT_GT(bytes.size(), 20u) << name;
        const std::string beginning = name.ends_with(".csv") ? "# " : name.ends_with(".png") ? "\x89PNG" : "";
        EXPECT_EQ(bytes.rfind(beginning, 0), 0u) << name;
    }
}

TEST(Figures, WithoutGnuplotTheErrorNamesThePackageAndNothingIsWritten) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run_nacre({"figures", "-o", "out"}, {folder.path(), {{"PATH", "/nonexistent"}}, {}, {}});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_NE(result.err.find("gnuplot-nox"), std::string::npos) << result.err;
    std::size_t files = 0;
    if (std::filesystem::exists(folder.path() / "out")) {
        for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out"))
            files += entry.exists() ? 1 : 0;
    }
    EXPECT_EQ(files, 0u);
}

}  // namespace
}  // namespace nacre::test
