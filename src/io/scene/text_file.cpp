#include "io/scene/text_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "nacre/base/error.h"

namespace nacre {

std::string read_text_file(const std::string& path, std::size_t most_bytes) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw IoError(path + ": is a folder; give a file");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) throw IoError(path + ": cannot be opened: " + std::strerror(errno));
    std::string text;
    std::array<char, 65536> buffer{};
    for (;;) {
        const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get());
        text.append(buffer.data(), count);
        if (text.size() > most_bytes) {
            throw IoError(path + ": is larger than " + std::to_string(most_bytes >> 20) +
                          " MB, the most that nacre reads");
        }
        if (count < buffer.size()) break;
    }
    if (std::ferror(file.get()) != 0) throw IoError(path + ": cannot be read: " + std::strerror(errno));
    return text;
}

}  // namespace nacre
