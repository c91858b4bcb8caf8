#pragma once

#include <memory>
#include <optional>
#include <string>

#include "nacre/lut/colour_space.h"
#include "nacre/lut/colour_spaces.h"

namespace nacre {

/// The colour spaces and displays of an OpenColorIO config (see ColourConfig).
/// @throws Error if the file cannot be read or is no config that this OpenColorIO understands
std::shared_ptr<const ColourSpaces> open_ocio_spaces(const ColourConfigChoice& choice);

/// The space whose ColourSpace::transform_text() is `text`, see ColourTransform::from_ctf().
std::shared_ptr<const ColourSpace> ocio_space_of_text(const std::string& text, const std::string& name,
                                                      const std::string& where,
                                                      const std::optional<std::string>& interop_id);

}  // namespace nacre
