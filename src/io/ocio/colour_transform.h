#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <string>

#include "nacre/base/image.h"
#include "nacre/colour/colour_types.h"
#include "nacre/lut/colour_space.h"

namespace nacre {

/// A colour space or a display's view of an OpenColorIO config.
///
/// Made by ColourConfig. Immutable, cheap to copy. When the whole conversion is one matrix it is applied in double,
/// otherwise by OpenColorIO in float. The environment may set $OCIO_OPTIMIZATION_FLAGS, which OpenColorIO obeys;
/// without it only lossless optimisations are made.
class ColourTransform final : public ColourSpace {
public:
    using ColourSpace::to_rgb;
    Image<Rgb> to_rgb(const Image<Xyz>& image) const override;
    bool has_inverse() const override;
    /// As exactly as OpenColorIO provides it.
    Image<Xyz> to_xyz(const Image<Rgb>& image) const override;

    const std::string& name() const override;
    const std::string& display() const override;
    const std::string& view() const override;

    /// Found by the numbers, never by the name: a few saturated colours, white and grey agree with our own config
    /// within 1e-4, which is less than half rounds at 0.5 (2.4e-4). Of a view it is the id of the display's encoding.
    const std::string& interop_id() const override;

    const std::optional<glm::dmat3>& linear_matrix() const override;

    /// CTF: XML, no paths. A matrix is about 500 bytes; a view with tables may be megabytes.
    const std::string& transform_text() const override;

    /// The inverse of transform_text(): the same pixels, bit for bit.
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
