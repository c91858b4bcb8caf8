#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <string>

#include "nacre/lut/colour_space.h"
#include "nacre/lut/colour_spaces.h"

namespace nacre {

/// A linear RGB space of a standard, computed by the core alone: no config, no file, no OpenColorIO.
///
/// XYZ is adapted from D65 to the space's white (Bradford), then the matrix of its primaries follows. Both are one
/// matrix, whose coefficients are rounded to the 15 significant digits that transform_text() carries: so a file that is
/// derived again from its header has the same numbers.
class RgbColourSpace final : public ColourSpace {
public:
    explicit RgbColourSpace(const KnownRgbSpace& space);

    using ColourSpace::to_rgb;
    Image<Rgb> to_rgb(const Image<Xyz>& image) const override;
    bool has_inverse() const override { return true; }
    Image<Xyz> to_xyz(const Image<Rgb>& image) const override;
    const std::string& name() const override { return name_; }
    const std::string& display() const override { return none_; }
    const std::string& view() const override { return none_; }
    const std::string& interop_id() const override { return interop_id_; }
    const std::optional<glm::dmat3>& linear_matrix() const override { return matrix_; }
    const std::string& transform_text() const override { return text_; }

private:
    std::string name_;
    std::string interop_id_;
    std::string none_;
    std::optional<glm::dmat3> matrix_;
    glm::dmat3 inverse_;
    std::string text_;
};

/// What a display of sRGB is sent (IEC 61966-2-1): Rec.709 primaries, the sRGB curve, components cut to [0, 1].
///
/// For pictures only: it has no inverse, and no text to be carried in a header.
std::shared_ptr<const ColourSpace> srgb_display();

/// The spaces of known_rgb_spaces() by name, alias or interop id, and the display "sRGB" with its view "Standard".
///
/// The choice is not read: there is no config to open.
std::shared_ptr<const ColourSpaces> own_colour_spaces(const ColourConfigChoice& choice = {});

}  // namespace nacre
