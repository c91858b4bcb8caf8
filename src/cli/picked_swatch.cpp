#include "cli/picked_swatch.h"

#include <filesystem>

#include "cli/scenes.h"
#include "io/disk/output_folder.h"
#include "io/image/font.h"
#include "nacre/base/error.h"
#include "pipeline/loaded_scene.h"
#include "pipeline/swatch_file.h"

namespace nacre {

void check_swatch_name(const PickOptions& options) {
    if (!options.swatch.empty() && std::filesystem::path(options.swatch).extension() != ".png")
        throw Error("--swatch " + options.swatch + ": the picture is a PNG; end its name in .png");
}

void write_picked_swatch(const PickOptions& options, const std::string& scene, Console& console) {
    SceneRequest request = scene_request(options.ocio, console);
    request.want_swatches = false;
    request.on_warning = {};  // they were told when the scene was made
    const LoadedScene loaded = load_scene_text(scene, "picks", request);
    const auto display = loaded.colours->display_view("", "", "--swatch");
    const PlannedSwatch& swatch = loaded.plan.swatches.front();
    const std::string bytes = swatch_bytes(swatch, loaded.space_of(swatch.colour), *display, find_font());
    const std::filesystem::path file(options.swatch);
    OutputFolder folder(file.has_parent_path() ? file.parent_path().string() : ".");
    folder.write(file.filename().string(), bytes);
    folder.commit();
    console.note(options.swatch + ": written");
}

}  // namespace nacre
