#include "nacre/lut/rgb_colour_space.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/base/text.h"
#include "nacre/colour/adaptation.h"

namespace nacre {
namespace {

// What OpenColorIO writes of a double, and reads back as the same number on both sides.
constexpr int matrix_digits = 15;

constexpr std::string_view display_name = "sRGB";
constexpr std::string_view view_name = "Standard";

glm::dmat3 rounded(glm::dmat3 matrix) {
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row)
            matrix[column][row] = std::stod(significant_text(matrix[column][row], matrix_digits));
    }
    return matrix;
}

glm::dmat3 matrix_of(const RgbPrimaries& primaries) {
    const glm::dmat3 to_white =
        adaptation_matrix(Adaptation::bradford, d65_white, xyz_from_chromaticity(primaries.white));
    return rounded(xyz_to_rgb_matrix(primaries) * to_white);
}

// A ProcessList of one matrix, rows as they are applied.
std::string ctf_text(const std::string& id, const glm::dmat3& matrix) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ProcessList version=\"1.3\" id=\"nacre-" + id +
                       "\">\n    <Matrix inBitDepth=\"32f\" outBitDepth=\"32f\">\n        <Array dim=\"3 3 3\">\n";
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            text += (column > 0 ? " " : "") + significant_text(matrix[column][row], matrix_digits);
        text += "\n";
    }
    return text + "        </Array>\n    </Matrix>\n</ProcessList>\n";
}

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[noreturn]] void throw_not_finite(const std::string& name, std::size_t pixel, int width) {
    const auto columns = static_cast<std::size_t>(width);
    throw Error("pixel (" + std::to_string(pixel % columns) + ", " + std::to_string(pixel / columns) + ") in \"" +
                name + "\" is not finite");
}

class SrgbDisplay final : public ColourSpace {
public:
    SrgbDisplay() : linear_(known_rgb_spaces().front()) {}

    using ColourSpace::to_rgb;
    Image<Rgb> to_rgb(const Image<Xyz>& image) const override {
        Image<Rgb> shown = linear_.to_rgb(image);
        for (Rgb& pixel : shown) pixel = {encoded(pixel.r), encoded(pixel.g), encoded(pixel.b)};
        return shown;
    }
    bool has_inverse() const override { return false; }
    Image<Xyz> to_xyz(const Image<Rgb>& image) const override { return Image<Xyz>(image.width(), image.height()); }
    const std::string& name() const override { return name_; }
    const std::string& display() const override { return display_; }
    const std::string& view() const override { return view_; }
    const std::string& interop_id() const override { return interop_id_; }
    const std::optional<glm::dmat3>& linear_matrix() const override { return matrix_; }
    const std::string& transform_text() const override { return text_; }

private:
    static double encoded(double component) {
        const double light = std::clamp(component, 0.0, 1.0);
        return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
    }

    RgbColourSpace linear_;
    std::string name_ = std::string(display_name) + " / " + std::string(view_name);
    std::string display_{display_name};
    std::string view_{view_name};
    std::string interop_id_ = "srgb_rec709_display";
    std::optional<glm::dmat3> matrix_;
    std::string text_;
};

class OwnColourSpaces final : public ColourSpaces {
public:
    const std::string& description() const override { return description_; }
    const std::string& short_name() const override { return short_name_; }
    bool is_from_environment() const override { return false; }
    const std::string& content_hash() const override { return hash_; }

    std::vector<std::string> names() const override {
        std::vector<std::string> names;
        for (const KnownRgbSpace& space : known_rgb_spaces()) names.emplace_back(space.name);
        return names;
    }
    std::string space_called(const std::string& name) const override {
        const KnownRgbSpace* const known = find(name);
        return known != nullptr ? std::string(known->name) : std::string();
    }
    std::string about(const std::string& name) const override {
        for (const KnownRgbSpace& space : known_rgb_spaces()) {
            if (space.name != name) continue;
            return "linear" + (space.alias.empty() ? std::string() : ", also called " + std::string(space.alias));
        }
        return {};
    }
    std::vector<std::string> displays() const override { return {std::string(display_name)}; }
    std::vector<std::string> views(const std::string& display) const override {
        check_display(display, "views");
        return {std::string(view_name)};
    }

    std::shared_ptr<const ColourSpace> space(const std::string& name, const std::string& where) const override {
        if (const KnownRgbSpace* const known = find(name)) return std::make_shared<const RgbColourSpace>(*known);
        throw Error(where + ": unknown colour space " + in_quotes(name) + "; known: " + comma_separated(names()));
    }

    std::shared_ptr<const ColourSpace> display_view(const std::string& display, const std::string& view,
                                                    const std::string& where) const override {
        if (!display.empty()) check_display(display, where);
        if (!view.empty() && view != view_name)
            throw Error(where + ": unknown view " + in_quotes(view) + "; known: " + std::string(view_name));
        return srgb_display();
    }

private:
    // Null for an unknown name.
    static const KnownRgbSpace* find(const std::string& name) {
        for (const KnownRgbSpace& known : known_rgb_spaces()) {
            if (known.name == name || known.alias == name || known.interop_id == name) return &known;
        }
        return nullptr;
    }

    static void check_display(const std::string& display, const std::string& where) {
        if (display != display_name)
            throw Error(where + ": unknown display " + in_quotes(display) + "; known: " + std::string(display_name));
    }

    std::string description_ = "nacre (compiled in)";
    std::string short_name_ = "nacre";
    std::string hash_ = "none";
};

}  // namespace

RgbColourSpace::RgbColourSpace(const KnownRgbSpace& space)
    : name_(space.name),
      interop_id_(space.interop_id),
      matrix_(matrix_of(space.primaries)),
      inverse_(glm::inverse(*matrix_)),
      text_(ctf_text(interop_id_, *matrix_)) {}

Image<Rgb> RgbColourSpace::to_rgb(const Image<Xyz>& image) const {
    Image<Rgb> result(image.width(), image.height());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Xyz& colour = image.data()[i];
        const glm::dvec3 rgb = *matrix_ * glm::dvec3(colour.x, colour.y, colour.z);
        if (!is_finite(rgb)) throw_not_finite(name_, i, image.width());
        result.data()[i] = {rgb.r, rgb.g, rgb.b};
    }
    return result;
}

Image<Xyz> RgbColourSpace::to_xyz(const Image<Rgb>& image) const {
    Image<Xyz> result(image.width(), image.height());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb& colour = image.data()[i];
        const glm::dvec3 xyz = inverse_ * glm::dvec3(colour.r, colour.g, colour.b);
        if (!is_finite(xyz)) throw_not_finite(name_, i, image.width());
        result.data()[i] = {xyz.x, xyz.y, xyz.z};
    }
    return result;
}

std::shared_ptr<const ColourSpace> srgb_display() {
    return std::make_shared<const SrgbDisplay>();
}

std::shared_ptr<const ColourSpaces> own_colour_spaces(const ColourConfigChoice& /*choice*/) {
    return std::make_shared<const OwnColourSpaces>();
}

}  // namespace nacre
