#include "cli/previews.h"

#include <cstddef>
#include <string>

#include "nacre/base/error.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/output_names.h"

namespace nacre {
namespace {

std::size_t count_luts(const std::vector<LoadedScene>& scenes) {
    std::size_t count = 0;
    for (const LoadedScene& scene : scenes) count += scene.plan.luts.size();
    return count;
}

void set_previews(LoadedScene& scene, Preview preview) {
    for (PlannedLut& lut : scene.plan.luts) lut.preview = preview;
}

}  // namespace

std::vector<Option> preview_options(PreviewFlags& flags) {
    return {{.names = "--preview",
             .target = &flags.all,
             .help = "draw a preview of every LUT, NAME.preview.png: a strip and an object in one picture"},
            {.names = "--no-preview", .target = &flags.none, .help = "draw no previews", .excludes = {"--preview"}}};
}

void choose_previews(std::vector<LoadedScene>& scenes, const PreviewFlags& flags, PreviewRule rule, bool has_only) {
    if (flags.none) return;
    const bool are_few = count_luts(scenes) <= most_automatic_previews;
    const auto choose = [&](const LoadedScene& scene) {
        if (flags.all) return Preview::asked;
        if (rule == PreviewRule::if_few) return are_few ? Preview::automatic : Preview::none;
        return has_only || !scene.plan.has_swatches ? Preview::asked : Preview::none;
    };
    OutputNames names;
    for (LoadedScene& scene : scenes) {
        set_previews(scene, choose(scene));
        names.claim(scene.plan);
    }
}

void open_displays_of_previews(std::vector<LoadedScene>& scenes, Console& console) {
    for (LoadedScene& scene : scenes) {
        if (scene.plan.luts.empty() || scene.plan.luts.front().preview == Preview::none) continue;
        const PlannedLut& first = scene.plan.luts.front();
        try {
            open_default_display(scene, first.where.text() + " " + preview_file(first));
        } catch (const Error& error) {
            if (first.preview == Preview::asked) throw;
            console.warning(std::string(error.what()) + "; without it the LUTs get no previews");
            set_previews(scene, Preview::none);
        }
    }
}

}  // namespace nacre
