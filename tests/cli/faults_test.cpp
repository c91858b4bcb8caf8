// When the system refuses: exit code 3, one line, and no partial file.
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): POSIX
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "io/image/font.h"
#include "support/program.h"

namespace nacre::test {
namespace {

constexpr const char* scene =
    "[material.morpho]\n"
    "picks = [ { angle_deg = 0,  peak_nm = 460, width_nm = 70, height = 1.0 },\n"
    "          { angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n";

void expect_one_line(const ProgramResult& result, int code) {
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST(Faults, FullDiskLeavesTheOldFileAndNoOther) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    // A disk of two pages of its own: one holds the old file, and the other not the whole of the new one.
    const auto small_disk = [&] {
        if (::unshare(::geteuid() == 0 ? CLONE_NEWNS : CLONE_NEWUSER | CLONE_NEWNS) != 0) ::_exit(99);
        ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
        const std::string out = (folder.path() / "small").string();
        ::mkdir(out.c_str(), 0777);
        if (::mount("none", out.c_str(), "tmpfs", 0, "size=8k") != 0) ::_exit(99);
        // What is left on it can only be seen from in here: the program's place is taken by a shell that looks.
        ::setenv("NACRE", NACRE_PROGRAM, 1);
        ::execl("/bin/sh", "sh", "-c",
                "printf old > small/morpho.exr; head -c 3000 /dev/zero > small/filler; \"$NACRE\" bake s.toml --only "
                "morpho --no-preview -o small; "
                "echo exit $? left $(ls -A small) $(cat small/morpho.exr)",
                nullptr);
    };
    const ProgramResult result = run_nacre({}, {folder.path(), {}, small_disk, {}});
    if (result.exit_code == 99) GTEST_SKIP() << "this machine lets nobody mount; the next test covers the writer";
    EXPECT_EQ(result.out, "exit 3 left filler morpho.exr old\n") << result.err;
    EXPECT_NE(result.err.find("No space left on device"), std::string::npos) << result.err;
}

TEST(Faults, WriterThatFailsHalfWayLeavesTheOldFileAndNoOther) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    folder.file("out/morpho.exr", "the old one");
    const auto small_files = [] {
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    };
    const ProgramResult result =
        run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, {folder.path(), {}, small_files, {}});
    expect_one_line(result, 3);
    EXPECT_EQ(result.err, "nacre: out/morpho.exr: cannot be written: File too large\n");
    EXPECT_EQ(file_bytes(folder.path() / "out/morpho.exr"), "the old one");
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out"))
        files += entry.exists() ? 1 : 0;
    EXPECT_EQ(files, 1u);
}

TEST(Faults, ReadOnlyFolderIsRefused) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    std::filesystem::create_directory(folder.path() / "out");
    const auto as_nobody = [&] {
        ::chmod((folder.path() / "out").c_str(), 0555);
        ::chmod(folder.path().c_str(), 0755);
        if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(99);
    };
    const ProgramResult result =
        run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, {folder.path(), {}, as_nobody, {}});
    if (result.exit_code == 99 || result.exit_code == 127)
        GTEST_SKIP() << "the program cannot be run as somebody else here";
    expect_one_line(result, 3);
    EXPECT_EQ(result.err, "nacre: out/morpho.exr: cannot be written: Permission denied\n");
}

TEST(Faults, FolderThatCannotBeMadeIsRefused) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    folder.file("file", "");
    expect_one_line(run_nacre({"bake", "s.toml", "-o", "file"}, {folder.path(), {}, {}, {}}), 3);
    expect_one_line(run_nacre({"bake", "s.toml", "-o", "file/out"}, {folder.path(), {}, {}, {}}), 3);
}

TEST(Faults, FolderInTheTargetsPlaceIsRefused) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    folder.file("out/morpho.exr/inside", "");
    const ProgramResult result =
        run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, {folder.path(), {}, {}, {}});
    expect_one_line(result, 3);
    EXPECT_EQ(result.err, "nacre: out/morpho.exr: cannot be put into place: Is a directory\n");
}

TEST(Faults, FullStandardOutputIsAnError) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    expect_one_line(run_nacre({"snippet", "glsl"}, {{}, {}, {}, "/dev/full"}), 3);
}

TEST(Faults, TerminationLeavesWholeFilesOnly) {
    const TemporaryFolder folder;
    std::string many;
    for (int i = 0; i < 1500; ++i) {
        many += "[material.m" + std::to_string(i) +
                "]\npicks = [ { angle_deg = 0, peak_nm = 460, width_nm = 70, height = 1.0 }, "
                "{ angle_deg = 40, peak_nm = 395, width_nm = 60, height = 0.7 } ]\n";
    }
    folder.file("s.toml", many);
    const auto stop_soon = [&] {
        // A grandchild that waits for the first file and then asks us, its parent's parent by now the program, to end.
        const pid_t program = ::getpid();
        if (::fork() == 0) {
            const auto out = folder.path() / "out";
            // Five minutes: all LUTs are decided first, which takes long with sanitizers on a busy machine.
            for (int i = 0; i < 60000 && (!std::filesystem::exists(out) || std::filesystem::is_empty(out)); ++i)
                ::usleep(5000);
            ::kill(program, SIGTERM);
            ::_exit(0);
        }
    };
    const ProgramResult result =
        run_nacre({"bake", "s.toml", "-o", "out", "--no-preview"}, {folder.path(), {}, stop_soon, {}});
    EXPECT_EQ(result.exit_code, 143) << result.err;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out")) {
        EXPECT_NE(entry.path().filename().string().front(), '.') << "a temporary file stayed behind";
        EXPECT_GT(entry.file_size(), 500u);
    }
}

// A machine without fonts: in the child nothing lies in the folders of the system in which they are looked for.
void hide_system_fonts() {
    if (::unshare(::geteuid() == 0 ? CLONE_NEWNS : CLONE_NEWUSER | CLONE_NEWNS) != 0) ::_exit(99);
    ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
    for (const auto& folder : usual_font_folders()) {
        if (folder.string().starts_with(std::getenv("HOME"))) continue;
        if (std::filesystem::exists(folder) && ::mount("none", folder.c_str(), "tmpfs", 0, "size=4k") != 0) ::_exit(99);
    }
}

TEST(Faults, AMissingFontStopsPicturesOnly) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string("[colour]\ngamut = \"clip\"\n") + scene +
                              "[lut.morpho]\nsize = 16\noutputs = [\"exr\", \"png\"]\n[swatch.ball]\ndraw = "
                              "\"sphere\"\n[swatch.strip]\ndraw = \"strip\"\n");
    const std::string message =
        "pictures need a font, and nacre found none; install the Debian package fonts-dejavu-core (DejaVuSans.ttf), or "
        "Liberation Sans or Noto Sans\n";
    const auto run = [&](const std::vector<std::string>& arguments) {
        std::filesystem::remove_all(folder.path() / "out");
        return run_nacre(arguments, {folder.path(), {{"HOME", folder.path().string()}}, hide_system_fonts, {}});
    };
    const auto exists = [&](const char* file) { return std::filesystem::exists(folder.path() / "out" / file); };
    const ProgramResult previews = run({"bake", "s.toml", "-o", "out", "--only", "morpho"});
    if (previews.exit_code == 99) GTEST_SKIP() << "this machine lets nobody mount";
    EXPECT_EQ(previews.exit_code, 0);
    EXPECT_EQ(previews.err, "nacre: warning: " + message);
    EXPECT_TRUE(exists("morpho.exr"));
    EXPECT_TRUE(exists("morpho.png")) << "it has no letters";
    EXPECT_FALSE(exists("morpho.preview.png"));
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"bake", "s.toml", "-o", "out"},
          {"bake", "s.toml", "-o", "out", "--only", "morpho", "--preview"}}) {
        const ProgramResult result = run(arguments);
        expect_one_line(result, 3);
        EXPECT_EQ(result.err, "nacre: " + message);
        EXPECT_TRUE(exists("morpho.exr"));
        EXPECT_FALSE(exists("ball.png"));
    }
    const ProgramResult drawn = run({"swatch", "s.toml", "-o", "out"});
    expect_one_line(drawn, 3);
    EXPECT_EQ(drawn.err, "nacre: " + message);
}

TEST(Faults, AFileThatIsNoFontStopsPicturesOnly) {
    const TemporaryFolder folder;
    folder.file("s.toml", std::string("[colour]\ngamut = \"clip\"\n") + scene + "[lut.morpho]\nsize = 16\n");
    const std::string font = folder.file(".fonts/DejaVuSans.ttf", "no font");
    const ProgramOptions options{folder.path(), {{"HOME", folder.path().string()}}, hide_system_fonts, {}};
    const ProgramResult result = run_nacre({"bake", "s.toml", "-o", "out"}, options);
    if (result.exit_code == 99) GTEST_SKIP() << "this machine lets nobody mount";
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "nacre: warning: s.toml:6:6 morpho.preview.png: " + font +
                              ": is not a font that OpenImageIO can draw with; install the Debian package "
                              "fonts-dejavu-core (DejaVuSans.ttf)\n");
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/morpho.exr"));
    EXPECT_EQ(run_nacre({"swatch", "s.toml", "-o", "out"}, options).exit_code, 3);
}

TEST(Faults, TwoProcessesThatBakeOneLutBothSucceed) {
    const TemporaryFolder folder;
    folder.file("s.toml", scene);
    ProgramResult first;
    std::thread other([&] {
        first = run_nacre({"bake", "s.toml", "-o", "out", "--no-preview", "--force"}, {folder.path(), {}, {}, {}});
    });
    const ProgramResult second =
        run_nacre({"bake", "s.toml", "-o", "out", "--no-preview", "--force"}, {folder.path(), {}, {}, {}});
    other.join();
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(second.exit_code, 0) << second.err;
    EXPECT_EQ(run_nacre({"verify", (folder.path() / "out/morpho.exr").string()}).exit_code, 0);
}

}  // namespace
}  // namespace nacre::test
