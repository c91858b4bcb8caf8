#include "consumers/shader_tools.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace nacre::testing {
namespace {

namespace fs = std::filesystem;

/// A new folder that nobody else can write to, removed with all it holds.
class TempDir {
public:
    TempDir() {
        std::string pattern = (fs::temp_directory_path() / "nacre-shader-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error(pattern + ": " + std::strerror(errno));
        path_ = pattern;
    }
    ~TempDir() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TempDir(const TempDir&) = delete;
    TempDir& operator=(const TempDir&) = delete;

    std::string file(std::string_view name) const { return (path_ / name).string(); }

private:
    fs::path path_;
};

std::string read_text(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write_text(const std::string& path, std::string_view text) {
    std::ofstream stream(path, std::ios::binary);
    if (!(stream << text << std::flush)) throw std::runtime_error("cannot write " + path);
}

/// Runs a program without a shell in between; returns what it printed on both streams.
std::string run_program(const TempDir& dir, std::vector<std::string> arguments, const std::string& debian_package) {
    const std::string log = dir.file("log.txt");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t child = 0;
    const int refused = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (refused != 0) {
        throw std::runtime_error(arguments[0] + ": " + std::strerror(refused) + "; install the Debian package " +
                                 debian_package);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) throw std::runtime_error(arguments[0] + ": " + std::strerror(errno));
    }
    std::string output = read_text(log);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        throw std::runtime_error(arguments[0] + " refuses this shader:\n" + output);
    }
    return output;
}

void run_glslang(const TempDir& dir, std::vector<std::string> options, std::string_view source) {
    const std::string input = dir.file("shader.frag");
    write_text(input, source);
    options.insert(options.begin(), {"glslangValidator", "-S", "frag"});
    options.push_back(input);
    try {
        run_program(dir, std::move(options), "glslang-tools");
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(std::string(error.what()) + "\n" + std::string(source));
    }
}

void hlsl_to_spirv(const TempDir& dir, std::string_view source, const std::string& output) {
    run_glslang(dir, {"-D", "-V", "-e", "main", "-o", output}, source);
}

}  // namespace

std::string_view name_of(ShaderVariant variant) {
    switch (variant) {
        case ShaderVariant::glsl_es_300:
            return "GlslEs300";
        case ShaderVariant::glsl_450:
            return "Glsl450";
        case ShaderVariant::hlsl:
            return "Hlsl";
    }
    return "";
}

void check_with_glslang(ShaderVariant variant, std::string_view source) {
    const TempDir dir;
    const std::string spirv = dir.file("shader.spv");
    if (variant == ShaderVariant::hlsl) return hlsl_to_spirv(dir, source, spirv);
    run_glslang(dir, {}, source);
    if (variant == ShaderVariant::glsl_450) run_glslang(dir, {"-V", "-o", spirv}, source);
}

std::string hlsl_to_glsl_450(std::string_view source) {
    const TempDir dir;
    const std::string spirv = dir.file("shader.spv");
    const std::string glsl = dir.file("shader.glsl");
    hlsl_to_spirv(dir, source, spirv);
    run_program(
        dir,
        {"spirv-cross", spirv, "--version", "450", "--no-es", "--combined-samplers-inherit-bindings", "--output", glsl},
        "spirv-cross");
    return read_text(glsl);
}

}  // namespace nacre::testing
