#pragma once

#include <string>
#include <string_view>

namespace nacre {

/// A version of OpenColorIO, or of a config's profile: OpenColorIO 2.N reads profiles up to 2.N.
struct OcioVersion {
    int major = 0;
    int minor = 0;
    bool operator<(const OcioVersion& other) const {
        return major != other.major ? major < other.major : minor < other.minor;
    }
};

/// Whether the name is that of a config that OpenColorIO contains itself, "ocio://NAME", and not of a file.
bool is_inside_ocio(std::string_view path);

/// Refuses by name what the OpenColorIO of this program is too old for: a newer profile, an archive (.ocioz), a config
/// that OpenColorIO contains itself. Its own messages would speak of broken YAML or of a missing file.
///
/// @param path    as the user names it
/// @param text    what the file holds; empty for a name that begins with "ocio://"
/// @param linked  of the OpenColorIO that would read it
/// @param where   for messages
/// @throws Error that says which version of OpenColorIO reads it
void check_config_version(const std::string& path, std::string_view text, OcioVersion linked, const std::string& where);

}  // namespace nacre
