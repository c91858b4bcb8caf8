#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nacre::test {

/// A folder of a test's own, removed with all it holds.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Writes a file in it and returns its path.
    std::string file(const std::string& name, const std::string& text) const;
    /// Names of everything in it, sorted; hidden files too.
    std::vector<std::string> names() const;

private:
    std::filesystem::path path_;
};

std::string file_bytes(const std::filesystem::path& path);

/// Makes a folder the current one, as it is for a user who stands in it.
class CurrentFolder {
public:
    explicit CurrentFolder(const std::filesystem::path& path) : before_(std::filesystem::current_path()) {
        std::filesystem::current_path(path);
    }
    ~CurrentFolder() { std::filesystem::current_path(before_); }
    CurrentFolder(const CurrentFolder&) = delete;
    CurrentFolder& operator=(const CurrentFolder&) = delete;

private:
    std::filesystem::path before_;
};

}  // namespace nacre::test
