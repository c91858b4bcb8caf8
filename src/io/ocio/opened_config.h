#pragma once

#include <string>
#include <vector>

#include "io/ocio/ocio_detail.h"

namespace nacre {

/// A config with the settings of the user.
struct OpenedConfig {
    OCIO::ConstConfigRcPtr config;
    std::string description;       ///< for messages and headers, no folder
    std::string interchange;       ///< a space of the config that is CIE XYZ D65, or empty
    std::string aces_interchange;  ///< one that is ACES2065-1, or empty
};

/// Names of the colour spaces, scene-referred first, data left out.
std::vector<std::string> space_names(const OCIO::ConstConfigRcPtr& config, OCIO::ColorSpaceVisibility visibility);

/// The error for a colour space that the config lacks; offers the nearest names, or all when none is near. For a name
/// that begins with "lin" it offers linear spaces only, or the role scene_linear when none is near.
[[noreturn]] void throw_unknown_space(const OpenedConfig& opened, const std::string& name, const std::string& where);

}  // namespace nacre
