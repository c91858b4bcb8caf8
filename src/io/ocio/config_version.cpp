#include "io/ocio/config_version.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

#include "nacre/base/error.h"
#include "nacre/base/names.h"

namespace nacre {
namespace {

constexpr std::string_view inside_ocio_prefix = "ocio://";
// Release notes of OpenColorIO: archives and its own configs came with 2.2, the names *-config-latest with 2.3.
constexpr OcioVersion first_with_archives{2, 2};
constexpr OcioVersion first_with_latest{2, 3};

std::string version_text(OcioVersion version) {
    return std::to_string(version.major) + "." + std::to_string(version.minor);
}

// "2.4", "2" (2.0) or "\"2.4\"" at the beginning of a text.
std::optional<OcioVersion> version_at(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\"'"), text.size()));
    OcioVersion version;
    const char* const end = text.data() + text.size();
    const auto major = std::from_chars(text.data(), end, version.major);
    if (major.ec != std::errc()) return std::nullopt;
    if (major.ptr != end && *major.ptr == '.') {
        if (std::from_chars(major.ptr + 1, end, version.minor).ec != std::errc()) return std::nullopt;
    }
    return version;
}

// The key stands at the beginning of a line; anywhere else it is OpenColorIO that reads it.
std::optional<OcioVersion> profile_of(std::string_view text) {
    constexpr std::string_view key = "ocio_profile_version:";
    for (auto at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
        if (at == 0 || text[at - 1] == '\n') return version_at(text.substr(at + key.size()));
    }
    return std::nullopt;
}

// Its own configs carry the version in their names: "cg-config-v2.1.0_aces-v1.3_ocio-v2.3".
OcioVersion first_with_own_config(std::string_view path) {
    constexpr std::string_view part = "_ocio-v";
    if (path.ends_with("-latest")) return first_with_latest;
    const auto at = path.rfind(part);
    const auto named = at == std::string_view::npos ? std::nullopt : version_at(path.substr(at + part.size()));
    return std::max(named.value_or(first_with_archives), first_with_archives);
}

// A zip file begins with these letters, whatever it is called.
bool is_archive(std::string_view path, std::string_view text) {
    return path.ends_with(".ocioz") || text.starts_with("PK\x03\x04");
}

}  // namespace

bool is_inside_ocio(std::string_view path) {
    return path.starts_with(inside_ocio_prefix);
}

void check_config_version(const std::string& path, std::string_view text, OcioVersion linked,
                          const std::string& where) {
    const auto refuse = [&](const std::string& what, const std::string& such_as) {
        throw Error(where + ": OCIO config " + in_quotes(path) + " is " + what + "; give a config that OpenColorIO " +
                    version_text(linked) + ", which this nacre is linked with, can read, " + such_as);
    };
    if (is_inside_ocio(path)) {
        const OcioVersion needed = first_with_own_config(path);
        if (linked < needed)
            refuse("one that OpenColorIO contains from version " + version_text(needed) + " on",
                   "such as a config.ocio");
        return;
    }
    if (is_archive(path, text)) {
        if (linked < first_with_archives) {
            refuse("an archive (.ocioz), which OpenColorIO reads from version " + version_text(first_with_archives) +
                       " on",
                   "such as the unpacked config.ocio of the archive");
        }
        return;
    }
    const std::optional<OcioVersion> profile = profile_of(text);
    if (profile && linked < *profile) {
        const std::string version = version_text(*profile);
        refuse("of profile version " + version + ", which OpenColorIO reads from version " + version + " on",
               "of profile version " + version_text(linked) + " or older");
    }
}

}  // namespace nacre
