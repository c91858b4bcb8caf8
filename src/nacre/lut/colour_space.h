#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <string>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/colour/rgb_space.h"

namespace nacre {

/// CIE XYZ (D65, Y = 1 for the perfect reflector) to the RGB of a colour space or of a display's view.
///
/// Two providers implement it: OpenColorIO (io/ocio) and the core's own RGB spaces (lut/rgb_colour_space.h). Immutable,
/// and safe to use from many threads.
class ColourSpace {
public:
    virtual ~ColourSpace() = default;

    /// Converts every pixel.
    /// @throws Error naming the first pixel that is not finite, before or after the conversion
    virtual Image<Rgb> to_rgb(const Image<Xyz>& image) const = 0;
    /// The same for one colour.
    Rgb to_rgb(Xyz colour) const;

    /// Whether the space's RGB can be converted back to XYZ. Some configs' tables cannot be inverted.
    virtual bool has_inverse() const = 0;
    /// The inverse of to_rgb().
    /// @pre has_inverse()
    /// @throws Error naming the first pixel that is not finite
    virtual Image<Xyz> to_xyz(const Image<Rgb>& image) const = 0;

    /// Name of the colour space as its provider spells it (aliases and roles resolved), or "DISPLAY / VIEW".
    virtual const std::string& name() const = 0;
    /// Empty for a colour space.
    virtual const std::string& display() const = 0;
    virtual const std::string& view() const = 0;

    /// Color Interop Forum's id of the encoding, e.g. "lin_rec709_scene"; "" when it is none that we know.
    virtual const std::string& interop_id() const = 0;

    /// XYZ -> RGB when the conversion is nothing but a matrix (15 significant digits, what transform_text() carries),
    /// else nothing. glm: columns, so RGB = matrix * XYZ.
    virtual const std::optional<glm::dmat3>& linear_matrix() const = 0;

    /// The whole conversion as text (OpenColorIO's CTF), to be carried in a file's header.
    virtual const std::string& transform_text() const = 0;

    /// Primaries and white: of the standard that the interop id names, else those that the matrix leads to; nothing for
    /// an unknown space that is not linear.
    std::optional<RgbPrimaries> primaries() const;

protected:
    ColourSpace() = default;
    ColourSpace(const ColourSpace&) = default;
    ColourSpace(ColourSpace&&) = default;
    ColourSpace& operator=(const ColourSpace&) = default;
    ColourSpace& operator=(ColourSpace&&) = default;
};

}  // namespace nacre
