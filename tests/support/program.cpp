#include "support/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <utility>

namespace nacre::test {
namespace {

ProgramResult run(std::vector<std::string> words, const ProgramOptions& options) {
    const TemporaryFolder capture;
    const auto out_path = options.out_file.empty() ? capture.path() / "out" : options.out_file;
    const auto err_path = capture.path() / "err";
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    const pid_t child = ::fork();
    if (child == 0) {
        const int out = ::open(out_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const int err = ::open(err_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(out, STDOUT_FILENO);
        ::dup2(err, STDERR_FILENO);
        if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) ::_exit(126);
        ::unsetenv("OCIO");
        for (const auto& [name, value] : options.environment) ::setenv(name.c_str(), value.c_str(), 1);
        if (options.in_child) options.in_child();
        ::execv(argv.front(), argv.data());
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ProgramResult result;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (options.out_file.empty()) result.out = file_bytes(out_path);
    result.err = file_bytes(err_path);
    return result;
}

}  // namespace

ProgramResult run_nacre(const std::vector<std::string>& arguments, const ProgramOptions& options) {
    std::vector<std::string> words{NACRE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run(std::move(words), options);
}

ProgramResult run_shell(const std::string& command, ProgramOptions options) {
    const char* path = std::getenv("PATH");
    const std::string folder = std::filesystem::path(NACRE_PROGRAM).parent_path().string();
    options.environment.emplace_back("PATH", folder + ":" + (path == nullptr ? "/usr/bin:/bin" : path));
    return run({"/bin/sh", "-c", command}, options);
}

}  // namespace nacre::test
