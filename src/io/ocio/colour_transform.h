#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <string>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"

namespace nacre {

/// CIE XYZ (D65, Y = 1 for the perfect reflector) to the RGB of a colour space or of a display's view.
///
/// Made by ColourConfig. Immutable, cheap to copy, safe to apply from many threads. When the whole conversion is one
/// matrix it is applied in double, otherwise by OpenColorIO in float. The environment may set $OCIO_OPTIMIZATION_FLAGS,
/// which OpenColorIO obeys; without it only lossless optimisations are made.
class ColourTransform {
public:
    /// Converts every pixel.
    /// @throws Error naming the first pixel that is not finite, before or after the conversion
    Image<Rgb> apply(const Image<Xyz>& image) const;
    /// The same for one colour.
    Rgb apply(Xyz colour) const;

    /// Whether the conversion has an inverse. The tables of some configs have none.
    bool has_way_back() const;
    /// RGB of the target to XYZ, the inverse of apply() as exactly as OpenColorIO provides it.
    /// @pre has_way_back()
    /// @throws Error naming the first pixel that is not finite
    Image<Xyz> back(const Image<Rgb>& image) const;

    /// Name of the colour space as the config spells it (aliases and roles resolved), or "DISPLAY / VIEW".
    const std::string& target() const;
    /// Empty for a colour space.
    const std::string& display() const;
    const std::string& view() const;

    /// Color Interop Forum's id of the encoding, e.g. "lin_rec709_scene"; "" for an encoding that nacre does not know.
    ///
    /// Found by the numbers, never by the name: a few saturated colours, white and grey agree with our own config
    /// within 1e-4, which is less than half rounds at 0.5 (2.4e-4). Of a view it is the id of the display's encoding.
    const std::string& interop_id() const;

    /// XYZ -> RGB when the conversion is nothing but a matrix (15 significant digits, what the CTF carries), else
    /// nothing. glm: columns, so RGB = matrix * XYZ.
    const std::optional<glm::dmat3>& linear_matrix() const;

    /// The whole conversion as OpenColorIO's CTF (XML, no paths), to be carried in a file's header.
    ///
    /// A matrix is about 500 bytes; a view with tables may be megabytes.
    const std::string& to_ctf() const;

    /// The inverse of to_ctf(): the same pixels, bit for bit.
    ///
    /// OpenColorIO 2.1 reads files only, so a private temporary file is written and removed at once.
    /// @param where  for messages
    /// @throws Error for text that is no CTF, is too long (64 MiB), or refers to other files; IoError
    /// @param interop_id  which of the ids that the numbers allow is meant: a texture and a display may be encoded
    /// alike
    static ColourTransform from_ctf(const std::string& text, const std::string& target_name, const std::string& where,
                                    const std::optional<std::string>& interop_id = {});

    struct Impl;
    explicit ColourTransform(std::shared_ptr<const Impl> impl);

private:
    std::shared_ptr<const Impl> impl_;
};

}  // namespace nacre
