#pragma once

#include <string>

#include "io/image/lut_file.h"
#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/formats.h"

namespace nacre {

/// The bytes that encode_lut() writes, made without OpenImageIO: a file without compression is its header and its rows.
///
/// Format: "OpenEXR File Layout", Academy Software Foundation, for single-part files of scanlines.
/// Throws Error if a component is not finite or too large for the format.
std::string plain_exr(const Image<Rgb>& image, PixelFormat format, const LutHeader& header);

}  // namespace nacre
