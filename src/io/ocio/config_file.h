#pragma once

#include <string>

#include "io/ocio/ocio_detail.h"

namespace nacre {

/// A config, as it was read.
struct ConfigFile {
    OCIO::ConstConfigRcPtr config;
    std::string description;  ///< "FILE (NAME)", no folder
    std::string name;         ///< what the config calls itself, else the name of its file
    std::string hash;         ///< XXH3 of its text
};

/// nacre's own config.
ConfigFile open_builtin_config();

/// @param path   a config file, an archive of one (.ocioz), or "ocio://NAME" for one that OpenColorIO contains
/// @param where  who asked, for messages
/// @throws Error if it cannot be read, or is none that this OpenColorIO understands
ConfigFile open_config_file(const std::string& path, const std::string& where);

}  // namespace nacre
