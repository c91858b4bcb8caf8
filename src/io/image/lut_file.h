#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/formats.h"
#include "nacre/scene/catalogue.h"

namespace nacre {

/// The header of a LUT file, in the order in which manifests show it.
struct LutHeader {
    std::string software;    ///< "nacre 0.1.0"
    std::string interop_id;  ///< colorInteropID of the Color Interop Forum; empty if the space has none
    std::optional<std::array<float, 8>> chromaticities;  ///< red x, y, green, blue, white; only of linear spaces
    /// Attributes "nacre:<name>": text each, numbers written so that they read back exactly.
    std::vector<std::pair<std::string, std::string>> nacre;

    /// Value of nacre:<name>; empty if it is not there.
    std::string value(const std::string& name) const;
};

/// Throws Error, naming the texel, if a component is not finite or too large for the format.
void check_storable(const Image<Rgb>& image, PixelFormat format);

/// The bytes of an EXR file: one part, scanlines, R G B, no compression; no date, host or path in it, so the same image
/// and header are the same bytes. Half is rounded to nearest, ties to even.
///
/// Throws Error if a component is not finite or too large for the format, IoError if the encoder fails.
std::string encode_lut(const Image<Rgb>& image, PixelFormat format, const LutHeader& header);

/// Lets OpenImageIO initialise itself. Otherwise this millisecond would count for the first LUT of a process.
void prepare_encoder();

/// A LUT as it is stored.
struct StoredLut {
    Image<Rgb> image;
    PixelFormat format = PixelFormat::half_float;
    LutHeader header;
    std::string breach;  ///< how the file breaks the LUT contract (channels, parts, tiles, compression); empty if not
};

/// Reads what encode_lut() wrote. Throws IoError if the file cannot be read as an EXR, Error if it is not a LUT of
/// nacre.
StoredLut read_lut(const std::string& path);

/// The value that a component is stored as.
double stored_value(double value, PixelFormat format);

}  // namespace nacre
