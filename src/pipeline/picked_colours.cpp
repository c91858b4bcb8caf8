#include "pipeline/picked_colours.h"

#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include "io/disk/hash.h"
#include "io/ocio/config_version.h"
#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "nacre/lut/colour_settings.h"
#include "nacre/lut/srgb_colour_space.h"
#include "pipeline/mechanism_finder.h"

namespace nacre {

extern const std::string_view builtin_ocio_config;

namespace {

// One scene's config, and the spaces that picks were given in.
class PickedColours {
public:
    PickedColours(std::string scene_path, std::string config, OpenColourSpaces open)
        : scene_path_(std::move(scene_path)), config_(std::move(config)), open_(std::move(open)) {}

    Xyz xyz(const Rgb& colour, const std::string& space, const Where& where, const ColourSettings& settings) {
        if (!spaces_) spaces_ = open_(config_choice(settings, scene_path_, config_));
        const std::string name = space.empty() ? "color_picking" : space;
        auto known = known_.find(name);
        if (known == known_.end()) known = known_.emplace(name, find(name, space, where)).first;
        return known->second->to_xyz(Image<Rgb>(1, 1, colour)).at(0, 0);
    }

private:
    std::shared_ptr<const ColourSpace> find(const std::string& name, const std::string& space,
                                            const Where& where) const {
        const std::string at = where.text() + ": colour";
        try {
            auto found = spaces_->space(name, at);
            if (is_srgb_of_own_config(*found)) return std::make_shared<const SrgbColourSpace>();
            if (found->has_inverse()) return found;
        } catch (const Error& error) {
            if (!space.empty()) throw;
            throw Error(std::string(error.what()) + " (the config's role for picked colours); give space = \"...\"");
        }
        throw Error(at + ": " + name + " has no inverse to XYZ in this config; give another space");
    }

    // Its meaning is known, so that it can be read without the single precision of OpenColorIO.
    bool is_srgb_of_own_config(const ColourSpace& space) const {
        return space.name() == SrgbColourSpace::known_name && spaces_->content_hash() == hash_text(builtin_ocio_config);
    }

    std::string scene_path_;
    std::string config_;
    OpenColourSpaces open_;
    std::shared_ptr<const ColourSpaces> spaces_;
    std::map<std::string, std::shared_ptr<const ColourSpace>> known_;
};

}  // namespace

ColourConfigChoice config_choice(const ColourSettings& colour, const std::string& scene_path,
                                 const std::string& config) {
    ColourConfigChoice choice{config, colour.interchange, "--ocio", colour.aces_interchange};
    if (!config.empty()) return choice;
    choice.where = scene_path;
    if (colour.config.empty()) return choice;
    // A file that a scene names lies beside the scene. Newer versions of OpenColorIO contain configs of such names.
    choice.path =
        is_inside_ocio(colour.config) ? colour.config : (folder_of(colour.config_where) / colour.config).string();
    choice.where = colour.config_where.text() + " [colour]";
    return choice;
}

SceneFiles scene_files_with_colours(const std::string& scene_path, const std::string& config,
                                    const OpenColourSpaces& open_colours, const std::function<void()>& after_step) {
    SceneFiles files = scene_files();
    const auto colours = std::make_shared<PickedColours>(scene_path, config, open_colours);
    files.read_colour = [colours](const Rgb& colour, const std::string& space, const Where& where,
                                  const ColourSettings& settings) {
        return colours->xyz(colour, space, where, settings);
    };
    files.find_mechanisms = [after_step](const MechanismSearch& search, const Light& light) {
        return find_with_materials(search, light, after_step);
    };
    return files;
}

}  // namespace nacre
