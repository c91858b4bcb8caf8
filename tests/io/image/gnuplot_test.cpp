#include "io/image/gnuplot.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "nacre/base/error.h"

namespace nacre {
namespace {

const std::string small_plot = "set terminal png size 80,60\nset output 'a.png'\nplot 'a.dat' notitle\n";

std::string failure_of(const NamedFiles& inputs) {
    try {
        run_gnuplot(inputs, "a.gp", {"a.png"});
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

// An environment variable for the length of a scope.
class Setting {
public:
    Setting(const char* name, const std::string& value)
        : name_(name), old_(std::getenv(name) ? std::getenv(name) : "") {
        ::setenv(name, value.c_str(), 1);
    }
    ~Setting() {
        if (old_.empty()) {
            ::unsetenv(name_);
        } else {
            ::setenv(name_, old_.c_str(), 1);
        }
    }

private:
    const char* name_;
    std::string old_;
};

TEST(Gnuplot, DrawsTheSamePictureTwiceAndLeavesNothingBehind) {
    const std::filesystem::path scratch = std::filesystem::temp_directory_path() / "nacre_gnuplot_test";
    std::filesystem::create_directories(scratch);
    {
        const Setting temporary("TMPDIR", scratch.string());
        const NamedFiles inputs{{"a.gp", small_plot}, {"a.dat", "1 1\n2 4\n"}};
        const GnuplotResult first = run_gnuplot(inputs, "a.gp", {"a.png"});
        EXPECT_TRUE(first.files.at("a.png").starts_with("\x89PNG"));
        EXPECT_EQ(first.files, run_gnuplot(inputs, "a.gp", {"a.png"}).files);
    }
    EXPECT_TRUE(std::filesystem::is_empty(scratch));
    std::filesystem::remove_all(scratch);
}

TEST(Gnuplot, MistakeInAScriptIsOneLineWithGnuplotsWords) {
    const std::string message = failure_of({{"a.gp", "set nonsense\n"}});
    EXPECT_TRUE(message.starts_with("gnuplot: a.gp failed: set nonsense; \"a.gp\" line 1: ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(Gnuplot, ScriptThatDrawsNothingIsAnError) {
    EXPECT_EQ(failure_of({{"a.gp", "x = 1\n"}}), "gnuplot: a.gp did not write a.png");
}

TEST(Gnuplot, MissingProgramNamesThePackage) {
    const Setting path("PATH", "/nonexistent");
    EXPECT_EQ(failure_of({{"a.gp", small_plot}}),
              "gnuplot: cannot be started: No such file or directory; install the Debian package gnuplot-nox");
}

}  // namespace
}  // namespace nacre
