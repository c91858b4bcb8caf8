#include "cli/picked_swatch.h"

#include <filesystem>

#include "cli/loaded_scene.h"
#include "cli/stop_signal.h"
#include "cli/swatch_file.h"
#include "io/disk/output_folder.h"
#include "io/image/font.h"
#include "io/scene/scene_file.h"
#include "nacre/base/error.h"
#include "pipeline/picked_colours.h"

namespace nacre {

void check_swatch_name(const PickOptions& options) {
    if (!options.swatch.empty() && std::filesystem::path(options.swatch).extension() != ".png")
        throw Error("--swatch " + options.swatch + ": is a PNG; end its name in .png");
}

void write_picked_swatch(const PickOptions& options, const std::string& scene, Console& console) {
    const std::filesystem::path file(options.swatch);
    constexpr const char* scene_name = "picks";
    const Plan plan = plan_scene(parse_scene(scene, scene_name),
                                 scene_files_with_colours(scene_name, options.ocio, throw_if_stopped));
    const ColourConfig config = ColourConfig::open(config_choice(plan.colour, scene_name, options.ocio));
    const std::string bytes = swatch_bytes(plan.swatches.front(), target_transform(config, plan.colour, scene_name),
                                           config.to_display("", "", "--swatch"), find_font());
    OutputFolder folder(file.has_parent_path() ? file.parent_path().string() : ".");
    folder.write(file.filename().string(), bytes);
    folder.commit();
    console.note(options.swatch + ": written");
}

}  // namespace nacre
