#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "nacre/lut/colour_space.h"
#include "nacre/lut/rgb_colour_space.h"

namespace nacre {

/// The space in which colours are picked on a screen, computed by the core alone and in double precision, where
/// OpenColorIO has single: srgb_rec709 of nacre's own config.
///
/// For reading colours. It has no text to be carried in a header.
class SrgbColourSpace final : public ColourSpace {
public:
    static constexpr std::string_view known_name = "srgb_rec709";

    SrgbColourSpace();

    using ColourSpace::to_rgb;
    Image<Rgb> to_rgb(const Image<Xyz>& image) const override;
    bool has_inverse() const override { return true; }
    Image<Xyz> to_xyz(const Image<Rgb>& image) const override;
    const std::string& name() const override { return name_; }
    const std::string& display() const override { return none_; }
    const std::string& view() const override { return none_; }
    const std::string& interop_id() const override { return interop_id_; }
    const std::optional<glm::dmat3>& linear_matrix() const override { return matrix_; }
    const std::string& transform_text() const override { return none_; }

private:
    RgbColourSpace linear_;
    std::string name_{known_name};
    std::string interop_id_ = "srgb_rec709_scene";
    std::string none_;
    std::optional<glm::dmat3> matrix_;  // none: it is not linear
};

}  // namespace nacre
