#pragma once

#include <string_view>

namespace nacre {

/// The version of nacre: "0.1.0".
std::string_view nacre_version();

}  // namespace nacre
