#include "io/ocio/colour_config.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "io/ocio/colour_interchange.h"
#include "io/ocio/config_file.h"
#include "io/ocio/known_spaces.h"
#include "io/ocio/ocio_detail.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"

namespace nacre {

struct ColourConfig::Impl {
    OpenedConfig opened;
    std::string name;
    std::string hash;
    bool is_from_environment = false;
};

namespace {

std::vector<std::string> all_displays(const OCIO::ConstConfigRcPtr& config) {
    std::vector<std::string> names;
    for (int i = 0; i < config->getNumDisplaysAll(); ++i) names.emplace_back(config->getDisplayAll(i));
    return names;
}

std::vector<std::string> active_views(const OCIO::ConstConfigRcPtr& config, const std::string& display) {
    std::vector<std::string> names;
    const int count = config->getNumViews(display.c_str());
    for (int i = 0; i < count; ++i) names.emplace_back(config->getView(display.c_str(), i));
    return names;
}

// The colour space that a view ends in; nothing for an unknown view.
OCIO::ConstColorSpaceRcPtr space_of_view(const OCIO::ConstConfigRcPtr& config, const std::string& display,
                                         const std::string& view) {
    std::string name = config->getDisplayViewColorSpaceName(display.c_str(), view.c_str());
    // A shared view may leave the space open: it is then the one with the name of the display.
    if (name == OCIO::OCIO_VIEW_USE_DISPLAY_NAME) name = display;
    return name.empty() ? nullptr : config->getColorSpace(name.c_str());
}

std::string resolve_display(const OpenedConfig& opened, const std::string& display, const std::string& where) {
    const std::vector<std::string> known = all_displays(opened.config);
    if (known.empty()) {
        throw Error(where + ": config " + in_quotes(opened.description) +
                    " has no displays; pictures need a config with a display and a view");
    }
    if (display.empty()) return opened.config->getDefaultDisplay();
    if (std::find(known.begin(), known.end(), display) == known.end()) {
        throw Error(where + ": unknown display " + in_quotes(display) + " in config " + in_quotes(opened.description) +
                    "; known: " + comma_separated(known));
    }
    return display;
}

std::string resolve_view(const OpenedConfig& opened, const std::string& display, const std::string& view,
                         const std::string& where) {
    const OCIO::ConstConfigRcPtr& config = opened.config;
    std::string wanted = view.empty() ? config->getDefaultView(display.c_str()) : view;
    const auto space = space_of_view(config, display, wanted);
    if (space && !space->isData()) return wanted;
    std::vector<std::string> usable;
    for (const std::string& name : active_views(config, display)) {
        const auto other = space_of_view(config, display, name);
        if (other && !other->isData()) usable.push_back(name);
    }
    throw Error(where + ": " +
                (space ? "view " + in_quotes(wanted) + " shows data without conversion on"
                       : "unknown view " + in_quotes(wanted) + " of") +
                " display " + in_quotes(display) + " in config " + in_quotes(opened.description) +
                (usable.empty() ? "; it has no view that converts colours" : "; known: " + comma_separated(usable)));
}

// Role scene_linear is where most configs do their work: a wrong interchange space shows there if the config has no
// well-known name.
void check_scene_linear(const OpenedConfig& opened, const Interchange& interchange, const std::string& where) {
    const auto space = opened.config->getColorSpace(OCIO::ROLE_SCENE_LINEAR);
    if (!space || space->isData() || space->getReferenceSpaceType() != OCIO::REFERENCE_SPACE_SCENE) return;
    const Conversion conversion = make_conversion(opened.config, path_to_space(interchange, space->getName()));
    check_neutral(opened, interchange, conversion, space->getName(), where);
}

// Encoding of what a view makes: by the path to its colour space, past the view transform. "" if there is no such path.
std::string interop_id_of_view(const OpenedConfig& opened, const OCIO::ConstColorSpaceRcPtr& space,
                               const std::string& where) {
    try {
        const OCIO::ReferenceSpaceType side = space->getReferenceSpaceType();
        const auto path = path_to_space(find_interchange(opened, side, where), space->getName());
        return interop_id_of(make_conversion(opened.config, path), side);
    } catch (const Error&) {
        return {};
    }
}

[[noreturn]] void throw_refused(const OpenedConfig& opened, const std::string& target, const std::string& message,
                                const std::string& where) {
    throw Error(where + ": config " + in_quotes(opened.description) + " cannot convert to " + in_quotes(target) + ": " +
                one_line(message) + "; choose another target or correct the config");
}

}  // namespace

ColourConfig::ColourConfig(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

ColourConfig ColourConfig::open(const ColourConfigChoice& choice) {
    silence_ocio();
    const char* const variable = std::getenv("OCIO");
    const bool from_environment = choice.path.empty() && variable != nullptr && *variable != '\0';
    ConfigFile file = from_environment       ? open_config_file(variable, "$OCIO")
                      : !choice.path.empty() ? open_config_file(choice.path, choice.where)
                                             : open_builtin_config();
    Impl impl{{std::move(file.config), std::move(file.description), choice.interchange, choice.aces_interchange},
              std::move(file.name),
              std::move(file.hash),
              from_environment};
    return ColourConfig(std::make_shared<const Impl>(std::move(impl)));
}

const std::string& ColourConfig::description() const {
    return impl_->opened.description;
}
const std::string& ColourConfig::name() const {
    return impl_->name;
}
const std::string& ColourConfig::content_hash() const {
    return impl_->hash;
}
bool ColourConfig::is_from_environment() const {
    return impl_->is_from_environment;
}

std::string ColourConfig::space_called(const std::string& name) const {
    const auto space = impl_->opened.config->getColorSpace(name.c_str());
    return space ? space->getName() : std::string();
}

std::vector<std::string> ColourConfig::colour_spaces() const {
    return space_names(impl_->opened.config, OCIO::COLORSPACE_ACTIVE);
}

std::string ColourConfig::about(const std::string& name) const {
    const auto space = impl_->opened.config->getColorSpace(name.c_str());
    if (!space) return {};
    const std::string text = one_line(space->getDescription());
    return text.substr(0, text.find(". "));
}

std::vector<std::string> ColourConfig::displays() const {
    std::vector<std::string> names;
    for (int i = 0; i < impl_->opened.config->getNumDisplays(); ++i)
        names.emplace_back(impl_->opened.config->getDisplay(i));
    return names;
}

std::vector<std::string> ColourConfig::views(const std::string& display) const {
    return active_views(impl_->opened.config, resolve_display(impl_->opened, display, "views"));
}

ColourTransform ColourConfig::to_colour_space(const std::string& name, const std::string& where) const {
    const OpenedConfig& opened = impl_->opened;
    const auto space = opened.config->getColorSpace(name.c_str());
    if (!space) throw_unknown_space(opened, name, where);
    if (space->isData()) {
        throw Error(where + ": " + in_quotes(space->getName()) + " is a data space of config " +
                    in_quotes(opened.description) + "; a colour space is needed");
    }
    try {
        const OCIO::ReferenceSpaceType side = space->getReferenceSpaceType();
        const Interchange interchange = find_interchange(opened, side, where);
        auto impl = std::make_shared<ColourTransform::Impl>();
        impl->target = space->getName();
        impl->conversion = make_conversion_with_ctf(opened.config, path_to_space(interchange, impl->target), where);
        impl->interop_id = interop_id_of(impl->conversion, side);
        // XYZ itself is the one space in which white is rightly not neutral.
        if (!changes_nothing(impl->conversion)) {
            if (side == OCIO::REFERENCE_SPACE_SCENE) check_scene_linear(opened, interchange, where);
            check_neutral(opened, interchange, impl->conversion, impl->target, where);
        }
        return ColourTransform(std::move(impl));
    } catch (const OCIO::Exception& e) {
        throw_refused(opened, name, e.what(), where);
    }
}

ColourTransform ColourConfig::to_display(const std::string& display, const std::string& view,
                                         const std::string& where) const {
    const OpenedConfig& opened = impl_->opened;
    auto impl = std::make_shared<ColourTransform::Impl>();
    impl->display = resolve_display(opened, display, where);
    impl->view = resolve_view(opened, impl->display, view, where);
    impl->target = impl->display + " / " + impl->view;
    try {
        // A view defines its own white (some simulate a warm one), so only the interchange space is checked.
        const Interchange interchange = find_interchange(opened, OCIO::REFERENCE_SPACE_SCENE, where);
        check_scene_linear(opened, interchange, where);
        auto last = OCIO::DisplayViewTransform::Create();
        last->setSrc(interchange.space.c_str());
        last->setDisplay(impl->display.c_str());
        last->setView(impl->view.c_str());
        impl->conversion = make_conversion_with_ctf(opened.config, path_through(interchange, last), where);
        impl->interop_id = interop_id_of_view(opened, space_of_view(opened.config, impl->display, impl->view), where);
        return ColourTransform(std::move(impl));
    } catch (const OCIO::Exception& e) {
        throw_refused(opened, impl->target, e.what(), where);
    }
}

}  // namespace nacre
