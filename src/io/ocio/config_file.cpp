#include "io/ocio/config_file.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <locale>
#include <memory>
#include <sstream>
#include <string_view>
#include <system_error>

#include "io/disk/hash.h"
#include "io/ocio/config_version.h"
#include "io/ocio/known_spaces.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"

namespace nacre {
namespace {

std::string read_config(const std::string& path, const std::string& where) {
    constexpr std::size_t longest = std::size_t{16} << 20U;
    const std::string what = where + ": OCIO config " + in_quotes(path);
    std::error_code failure;
    if (std::filesystem::is_directory(path, failure)) throw Error(what + " is a folder; name the config.ocio in it");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) throw Error(what + " cannot be read (" + std::strerror(errno) + "); name a readable config.ocio");
    std::string text(longest + 1, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file.get()));
    if (std::ferror(file.get()) != 0) throw Error(what + " cannot be read; name a readable config.ocio");
    if (text.empty()) throw Error(what + " is empty; an OCIO config begins with ocio_profile_version");
    if (text.size() > longest) throw Error(what + " is longer than 16 MiB; that is the limit");
    return text;
}

// OpenColorIO begins with the path, which our message has.
std::string_view after(std::string_view message, std::string_view preamble) {
    const auto at = message.find(preamble);
    return at == std::string_view::npos ? message : message.substr(at + preamble.size());
}

// One that OpenColorIO contains has no file: the same name may mean another config in its next version.
std::string serialised(const OCIO::Config& config) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    config.serialize(text);
    return text.str();
}

// Of the library that is loaded, which may be newer than its headers were.
OcioVersion linked_version() {
    const auto version = static_cast<unsigned>(OCIO::GetVersionHex());
    return {static_cast<int>(version >> 24U), static_cast<int>((version >> 16U) & 0xffU)};
}

}  // namespace

ConfigFile open_builtin_config() {
    return {builtin_config(), "nacre (built in)", "nacre", hash_text(builtin_ocio_config)};
}

ConfigFile open_config_file(const std::string& path, const std::string& where) {
    const bool is_inside = is_inside_ocio(path);
    const std::string text = is_inside ? std::string() : read_config(path, where);
    check_config_version(path, text, linked_version(), where);
    try {
        const OCIO::ConstConfigRcPtr config = OCIO::Config::CreateFromFile(path.c_str());
        const std::string file = is_inside ? path : std::filesystem::path(path).filename().string();
        const std::string name = one_line(config->getName());
        return {config, name.empty() ? file : file + " (" + name + ")", name.empty() ? file : name,
                hash_text(is_inside ? serialised(*config) : text)};
    } catch (const OCIO::Exception& e) {
        throw Error(where + ": OCIO config " + in_quotes(path) +
                    " is refused: " + one_line(after(e.what(), "' failed.")) + "; give a config that OpenColorIO " +
                    OCIO::GetVersion() + " can read");
    }
}

}  // namespace nacre
