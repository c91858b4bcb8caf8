#include "pipeline/picked_colours.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "io/ceres_solver.h"
#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "nacre/lut/colour_settings.h"
#include "pipeline/mechanism_finder.h"

namespace nacre {
namespace {

// One scene's config, and the ways into XYZ that were asked for.
class PickedColours {
public:
    PickedColours(std::string scene_path, std::string ocio)
        : scene_path_(std::move(scene_path)), ocio_(std::move(ocio)) {}

    Xyz xyz(const Rgb& colour, const std::string& space, const Where& where, const ColourSettings& settings) {
        if (!config_) config_.emplace(ColourConfig::open(config_choice(settings, scene_path_, ocio_)));
        const std::string name = space.empty() ? "color_picking" : space;
        auto known = transforms_.find(name);
        if (known == transforms_.end()) known = transforms_.emplace(name, transform_of(name, space, where)).first;
        Image<Rgb> one(1, 1);
        *one.begin() = colour;
        const Xyz xyz = *known->second.back(one).begin();
        return xyz;
    }

private:
    ColourTransform transform_of(const std::string& name, const std::string& space, const Where& where) const {
        const std::string at = where.text() + ": colour";
        try {
            ColourTransform transform = config_->to_colour_space(name, at);
            if (transform.has_way_back()) return transform;
        } catch (const Error& error) {
            if (!space.empty()) throw;
            throw Error(std::string(error.what()) + " (the config's role for picked colours); give space = \"...\"");
        }
        throw Error(at + ": " + name + " has no way back to XYZ in this config; give another space");
    }

    std::string scene_path_;
    std::string ocio_;
    std::optional<ColourConfig> config_;
    std::map<std::string, ColourTransform> transforms_;
};

}  // namespace

ColourConfigChoice config_choice(const ColourSettings& colour, const std::string& scene_path, const std::string& ocio) {
    if (!ocio.empty()) return {ocio, colour.interchange, "--ocio"};
    if (colour.config.empty()) return {"", colour.interchange, scene_path};
    // A file that a scene names lies beside the scene.
    const auto file = std::filesystem::path(colour.config_where.file).parent_path() / colour.config;
    return {file.string(), colour.interchange, colour.config_where.text() + " [colour]"};
}

SceneFiles scene_files_with_colours(const std::string& scene_path, const std::string& ocio,
                                    const std::function<void()>& after_step) {
    SceneFiles files = scene_files();
    const auto colours = std::make_shared<PickedColours>(scene_path, ocio);
    files.read_colour = [colours](const Rgb& colour, const std::string& space, const Where& where,
                                  const ColourSettings& settings) {
        return colours->xyz(colour, space, where, settings);
    };
    files.least_squares = least_squares_solver();
    files.find_mechanisms = [after_step](const MechanismSearch& search, const Light& light) {
        return find_with_materials(search, light, after_step);
    };
    return files;
}

}  // namespace nacre
