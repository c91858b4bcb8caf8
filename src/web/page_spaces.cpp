#include "web/page_spaces.h"

#include <string>
#include <string_view>
#include <vector>

#include "io/disk/hash.h"
#include "nacre/base/error.h"
#include "nacre/lut/rgb_colour_space.h"
#include "nacre/lut/srgb_colour_space.h"

namespace nacre {

extern const std::string_view builtin_ocio_config;

namespace {

class PageSpaces final : public ColourSpaces {
public:
    const std::string& description() const override { return description_; }
    const std::string& short_name() const override { return short_name_; }
    bool is_from_environment() const override { return false; }
    const std::string& content_hash() const override { return hash_; }
    std::vector<std::string> names() const override { return linear_->names(); }
    std::string space_called(const std::string& name) const override {
        return is_srgb(name) ? std::string(SrgbColourSpace::known_name) : linear_->space_called(name);
    }
    std::string about(const std::string& name) const override { return linear_->about(name); }
    std::vector<std::string> displays() const override { return linear_->displays(); }
    std::vector<std::string> views(const std::string& display) const override { return linear_->views(display); }
    std::shared_ptr<const ColourSpace> space(const std::string& name, const std::string& where) const override {
        if (is_srgb(name)) return std::make_shared<const SrgbColourSpace>();
        return linear_->space(name, where);
    }
    std::shared_ptr<const ColourSpace> display_view(const std::string& display, const std::string& view,
                                                    const std::string& where) const override {
        return linear_->display_view(display, view, where);
    }

private:
    // By name, by the alias of the ACES configs, or by a role.
    static bool is_srgb(const std::string& name) {
        return name == SrgbColourSpace::known_name || name == "sRGB - Texture" || name == "srgb_tx" ||
               name == "color_picking";
    }

    std::shared_ptr<const ColourSpaces> linear_ = own_colour_spaces();
    std::string description_ = "nacre (built in)";
    std::string short_name_ = "nacre";
    std::string hash_ = hash_text(builtin_ocio_config);
};

}  // namespace

std::shared_ptr<const ColourSpaces> page_spaces(const ColourConfigChoice& choice) {
    if (choice.path.empty()) return std::make_shared<const PageSpaces>();
    throw Error(choice.where +
                ": the page has the spaces of nacre's own config and no OpenColorIO; remove config here, " +
                "and give it to the program: nacre bake --ocio " + choice.path);
}

}  // namespace nacre
