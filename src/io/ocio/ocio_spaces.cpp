#include "io/ocio/ocio_spaces.h"

#include <utility>
#include <vector>

#include "io/ocio/colour_config.h"
#include "io/ocio/colour_transform.h"

namespace nacre {
namespace {

class OcioSpaces final : public ColourSpaces {
public:
    explicit OcioSpaces(ColourConfig config) : config_(std::move(config)) {}

    const std::string& description() const override { return config_.description(); }
    const std::string& short_name() const override { return config_.name(); }
    bool is_from_environment() const override { return config_.is_from_environment(); }
    const std::string& content_hash() const override { return config_.content_hash(); }
    std::vector<std::string> names() const override { return config_.colour_spaces(); }
    std::string space_called(const std::string& name) const override { return config_.space_called(name); }
    std::string about(const std::string& name) const override { return config_.about(name); }
    std::vector<std::string> displays() const override { return config_.displays(); }
    std::vector<std::string> views(const std::string& display) const override { return config_.views(display); }

    std::shared_ptr<const ColourSpace> space(const std::string& name, const std::string& where) const override {
        return std::make_shared<const ColourTransform>(config_.to_colour_space(name, where));
    }
    std::shared_ptr<const ColourSpace> display_view(const std::string& display, const std::string& view,
                                                    const std::string& where) const override {
        return std::make_shared<const ColourTransform>(config_.to_display(display, view, where));
    }

private:
    ColourConfig config_;
};

}  // namespace

std::shared_ptr<const ColourSpaces> open_ocio_spaces(const ColourConfigChoice& choice) {
    return std::make_shared<const OcioSpaces>(ColourConfig::open(choice));
}

std::shared_ptr<const ColourSpace> ocio_space_of_text(const std::string& text, const std::string& name,
                                                      const std::string& where,
                                                      const std::optional<std::string>& interop_id) {
    return std::make_shared<const ColourTransform>(ColourTransform::from_ctf(text, name, where, interop_id));
}

}  // namespace nacre
