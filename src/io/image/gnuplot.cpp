#include "io/image/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <sstream>
#include <string_view>
#include <system_error>

#include "io/scene/text_file.h"
#include "nacre/base/error.h"

extern char** environ;

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_picture = 64u << 20;
constexpr std::size_t longest_message = 500;
constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";
constexpr const char* messages_file = "gnuplot.messages";

// What the system says when a program is not there, as a shell would.
constexpr int not_found_code = 127;

class TemporaryFolder {
public:
    TemporaryFolder() {
        std::error_code error;
        fs::path base = fs::temp_directory_path(error);
        if (error) base = "/tmp";
        std::string name = (base / "nacre-figures-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) {
            throw IoError(name + ": cannot be created: " + std::strerror(errno));
        }
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

// Owns what posix_spawn needs to be initialised and destroyed.
class SpawnActions {
public:
    SpawnActions() { ::posix_spawn_file_actions_init(&actions_); }
    ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    posix_spawn_file_actions_t* get() { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

void write_input(const fs::path& file, const std::string& bytes) {
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) throw IoError(file.string() + ": cannot be written: " + std::strerror(errno));
}

// Our environment without the variables that change gnuplot's output from user to user.
std::vector<std::string> neutral_environment() {
    constexpr std::array<std::string_view, 6> left_out{"GNUPLOT", "GNUTERM", "FIT_", "LANG", "LC_", "GDFONTPATH"};
    std::vector<std::string> variables;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text = *variable;
        if (std::none_of(left_out.begin(), left_out.end(),
                         [&](std::string_view name) { return text.starts_with(name); })) {
            variables.emplace_back(text);
        }
    }
    variables.emplace_back("LC_ALL=C.UTF-8");
    return variables;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

[[noreturn]] void fail_to_start(int error) {
    throw IoError(std::string("gnuplot: cannot be started: ") + std::strerror(error) +
                  (error == ENOENT ? "; install the Debian package gnuplot-nox" : ""));
}

// Runs to the end; gives the status that waitpid() reports. posix_spawn rather than fork: other libraries have threads.
int run_in(const fs::path& folder, const std::string& script) {
    SpawnActions actions;
    ::posix_spawn_file_actions_addchdir_np(actions.get(), folder.c_str());
    ::posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(actions.get(), STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(actions.get(), STDERR_FILENO, messages_file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    std::vector<std::string> words{"gnuplot", "--default-settings", script};
    std::vector<std::string> variables = neutral_environment();
    pid_t child = 0;
    const int error = ::posix_spawnp(&child, "gnuplot", actions.get(), nullptr, pointers_to(words).data(),
                                     pointers_to(variables).data());
    if (error != 0) fail_to_start(error);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) throw IoError(std::string("gnuplot: cannot be waited for: ") + std::strerror(errno));
    }
    return status;
}

// gnuplot describes a mistake in several lines; our message has one.
std::string one_line(const std::string& messages) {
    std::istringstream lines(messages);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find_first_not_of(" \t\r^");
        if (first == std::string::npos) continue;
        result += (result.empty() ? "" : "; ") + line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
    }
    if (result.size() > longest_message) result = result.substr(0, longest_message) + " ...";
    return result;
}

std::string read_picture(const fs::path& folder, const std::string& name, const std::string& script,
                         const std::string& messages) {
    std::string bytes;
    if (fs::exists(folder / name)) bytes = read_text_file((folder / name).string(), largest_picture);
    if (bytes.starts_with(png_signature)) return bytes;
    throw IoError("gnuplot: " + script + " did not write " + name + (messages.empty() ? "" : ": " + messages));
}

}  // namespace

GnuplotResult run_gnuplot(const NamedFiles& inputs, const std::string& script,
                          const std::vector<std::string>& outputs) {
    const TemporaryFolder folder;
    for (const auto& [name, bytes] : inputs) write_input(folder.path() / name, bytes);
    const int status = run_in(folder.path(), script);
    const std::string messages =
        fs::exists(folder.path() / messages_file)
            ? one_line(read_text_file((folder.path() / messages_file).string(), largest_picture))
            : "";
    if (WIFSIGNALED(status)) {
        throw IoError("gnuplot: was ended by signal " + std::to_string(WTERMSIG(status)) + " while it drew " + script);
    }
    if (WEXITSTATUS(status) == not_found_code && messages.empty()) fail_to_start(ENOENT);
    if (WEXITSTATUS(status) != 0) {
        throw IoError("gnuplot: " + script +
                      " failed: " + (messages.empty() ? "exit code " + std::to_string(WEXITSTATUS(status)) : messages));
    }
    GnuplotResult result{{}, messages};
    for (const std::string& name : outputs) result.files[name] = read_picture(folder.path(), name, script, messages);
    return result;
}

}  // namespace nacre
