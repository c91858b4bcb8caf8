#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/bake_report.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/execution.h"
#include "cli/previews.h"
#include "cli/scenes.h"
#include "io/disk/output_folder.h"
#include "io/image/font.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/mistakes.h"
#include "nacre/scene/output_names.h"
#include "pipeline/bake_task.h"
#include "pipeline/decide.h"
#include "pipeline/json.h"

namespace nacre {
namespace {

struct BakeOptions {
    std::vector<std::string> scenes;
    std::string folder = ".";
    std::vector<std::string> only;
    std::vector<std::string> edits;
    std::string ocio;
    ColourOverride colours;
    std::string shard;
    double accuracy = 0.0;
    std::string effects;
    int threads = 0;
    bool best_effort = false;
    bool force = false;
    bool strict = false;
    bool dry_run = false;
    PreviewFlags previews;
};

// "I/N", 1 <= I <= N: every N-th task, beginning with the I-th. A preview belongs to its LUT.
void keep_shard(std::vector<BakeTask>& tasks, const std::string& shard) {
    if (shard.empty()) return;
    unsigned index = 0;
    unsigned count = 0;
    char rest = 0;
    if (std::sscanf(shard.c_str(), "%6u/%6u%c", &index, &count, &rest) != 2 || index < 1 || index > count) {
        throw Error("--shard " + in_quotes(shard) +
                    " is not a shard I/N with I from 1 to N; give, for example, --shard 1/4 for the first of four");
    }
    std::vector<BakeTask> kept;
    std::size_t next = 0;
    bool is_kept = false;
    for (const BakeTask& task : tasks) {
        if (task.kind != TaskKind::preview) is_kept = next++ % count == index - 1;
        if (is_kept) kept.push_back(task);
    }
    tasks = std::move(kept);
}

// Decides the tasks' LUTs, and lets the tasks point to what was decided.
std::vector<DecidedLut> decide_luts(std::vector<BakeTask>& tasks, const Execution& execution) {
    std::vector<DecidedLut> luts;
    for (const BakeTask& task : tasks) {
        if (!task.is_lut()) continue;
        DecidedLut& next = luts.emplace_back();
        next.scene = task.scene;
        next.asked = task.lut;
    }
    decide_all(luts, execution);
    auto next = luts.begin();
    for (BakeTask& task : tasks) {
        if (task.is_lut()) task.decided = &*next++;
    }
    return luts;
}

int report_dry_run(const std::vector<BakeTask>& tasks, Console& console) {
    Json json = Json::array();
    for (const BakeTask& task : tasks) {
        const std::vector<std::string> files =
            task.is_lut() ? output_files(*task.lut) : std::vector<std::string>{task.picture()};
        console.summary("would write " + comma_separated(files) +
                        (task.is_lut() ? "  " + size_text(task.decided->lut.lut.job) : ""));
        json.push_back(Json{{"files", files}});
    }
    if (console.json()) console.result_json(Json{{"would_write", json}});
    return exit_done;
}

// What all tasks together came to.
struct Tally {
    Json luts = Json::array();
    Json previews = Json::array();
    Json swatches = Json::array();
    Json failures = Json::array();
    std::vector<std::string> outside_gamut;
    bool misses_bound = false;
    bool is_refused = false;  // by the system

    void fail(const std::string& failure, Console& console) {
        console.error(failure);
        failures.push_back(failure);
    }

    void add(const BakeTask& task, const BakeOutcome& outcome, Console& console) {
        misses_bound = misses_bound || outcome.misses_bound;
        is_refused = is_refused || (outcome.is_refused && !outcome.is_left_out);
        if (!outcome.failure.empty()) return fail(outcome.failure, console);
        if (!outcome.is_left_out) console.summary(bake_line(task, outcome));
        if (!outcome.warning.empty()) console.warning(outcome.warning);
        if (outcome.is_left_out) return;
        const std::string outside = task.is_lut() ? gamut_warning(task, outcome.baked) : std::string();
        if (!outside.empty()) outside_gamut.push_back(outside);
        if (console.json()) list_of(task.kind).push_back(bake_json(task, outcome));
    }

    Json& list_of(TaskKind kind) {
        if (kind == TaskKind::lut) return luts;
        return kind == TaskKind::preview ? previews : swatches;
    }

    std::string gamut_message() const {
        std::string message;
        for (std::size_t i = 0; i < std::min(outside_gamut.size(), most_shown_mistakes); ++i)
            message += outside_gamut[i] + "\n";
        if (outside_gamut.size() > most_shown_mistakes)
            message += "... and " + std::to_string(outside_gamut.size() - most_shown_mistakes) + " more\n";
        return message +
               "gamut = \"compress\" or \"clip\" in [colour] or [lut.NAME] removes negative components; a wider space "
               "keeps the colours";
    }

    int report(Console& console) const {
        if (!outside_gamut.empty()) console.warning(gamut_message());
        if (console.json()) {
            console.result_json(
                Json{{"luts", luts}, {"previews", previews}, {"swatches", swatches}, {"failures", failures}});
        }
        if (misses_bound) return exit_not_verified;
        if (is_refused) return exit_io;
        return failures.size() == 0 ? exit_done : exit_some_failed;
    }
};

// The font of the pictures. Without one they are no tasks any more, and LUTs are baked as ever.
std::filesystem::path font_of(std::vector<BakeTask>& tasks, Tally& tally, Console& console) {
    const auto is_picture = [](const BakeTask& task) { return !task.is_lut(); };
    if (std::none_of(tasks.begin(), tasks.end(), is_picture)) return {};
    try {
        return find_font();
    } catch (const IoError& error) {
        const auto is_asked = [&](const BakeTask& task) { return is_picture(task) && !task.is_automatic(); };
        tally.is_refused = std::any_of(tasks.begin(), tasks.end(), is_asked);
        tally.is_refused ? tally.fail(error.what(), console) : console.warning(error.what());
        std::erase_if(tasks, is_picture);
        return {};
    }
}

int bake(std::vector<BakeTask>& tasks, const BakeOptions& options, const Execution& execution, Console& console) {
    Tally tally;
    const std::filesystem::path font = font_of(tasks, tally, console);
    OutputFolder folder(options.folder);
    bake_all(tasks, {folder, font, options.force, options.best_effort}, execution,
             [&](const BakeTask& task, const BakeOutcome& outcome) { tally.add(task, outcome, console); });
    return tally.report(console);
}

int run_bake(const BakeOptions& options, bool with_luts, Console& console) {
    SceneRequest request = scene_request(options.ocio, console);
    request.only = options.only;
    request.edits = scene_edits(options.edits);
    request.strict = options.strict;
    request.colours = options.colours;
    std::vector<LoadedScene> scenes = open_scenes(options.scenes, request, console);
    if (with_luts) override_accuracy(scenes, accuracy_override(options.accuracy, options.effects));
    const PreviewRule unless_told = with_luts ? PreviewRule::if_few : PreviewRule::if_bare;
    choose_previews(scenes, options.previews, unless_told, !options.only.empty());
    open_displays_of_previews(scenes, console);
    std::vector<BakeTask> tasks = bake_tasks(scenes, with_luts);
    keep_shard(tasks, options.shard);
    if (tasks.empty() && !with_luts) {
        throw Error(std::string("there is nothing to draw: no [swatch.NAME], and ") +
                    (options.previews.none ? "--no-preview leaves out the previews of LUTs" : "no LUT"));
    }
    const Execution execution = execution_on(options.threads, console);
    std::vector<DecidedLut> luts = decide_luts(tasks, execution);
    const std::size_t out_of_reach = report_out_of_reach(luts, options.best_effort, console);
    if (out_of_reach > 0 && !options.best_effort) {
        console.error("nothing was written; --best-effort writes the most accurate LUTs that nacre found");
        return exit_not_verified;
    }
    return options.dry_run ? report_dry_run(tasks, console) : bake(tasks, options, execution, console);
}

std::vector<Option> shared_options(BakeOptions& options) {
    std::vector<Option> shared{
        scenes_option(options.scenes),
        {.names = "-o,--output",
         .target = &options.folder,
         .help = "folder for the files; nacre creates it if it is missing",
         .value_name = "DIR",
         .shows_default = true},
        only_option(options.only),
        set_option(options.edits),
        ocio_option(options.ocio),
        threads_option(options.threads),
        strict_option(options.strict),
        {.names = "--force", .target = &options.force, .help = "also write files that are up to date"},
        {.names = "--dry-run",
         .target = &options.dry_run,
         .help = "print which files would be written, and write nothing"}};
    for (Option& option : colour_options(options.colours)) shared.push_back(std::move(option));
    for (Option& option : preview_options(options.previews)) shared.push_back(std::move(option));
    return shared;
}

}  // namespace

Command bake_command() {
    const auto options = std::make_shared<BakeOptions>();
    Command command{"bake", "bake scenes into LUTs, manifests and swatches", shared_options(*options), {}};
    command.options.push_back(accuracy_option(options->accuracy));
    command.options.push_back(effects_option(options->effects));
    command.options.push_back(
        {.names = "--best-effort",
         .target = &options->best_effort,
         .help = "also write LUTs whose error bound is out of reach, as accurate as nacre can make them"});
    command.options.push_back({.names = "--shard",
                               .target = &options->shard,
                               .help = "bake only every N-th LUT and swatch, starting with the I-th; for render farms",
                               .value_name = "I/N"});
    command.footer =
        "\nA preview is a picture of a LUT: a strip and an object. Without --preview and --no-preview, every LUT gets\n"
        "one if there are at most 32 in all.\n\n"
        "The exit code is 4 if an error bound that you gave is out of reach; then nothing is written. The default\n"
        "bound, 0.1, is a goal: a LUT that misses it is written with a warning.\n\nExample:\n"
        "  nacre bake configs/scenes/morpho.toml configs/scenes/beetle.toml -o out --accuracy 0.5\n";
    command.run = [options](Console& console) { return run_bake(*options, true, console); };
    return command;
}

Command swatch_command() {
    const auto options = std::make_shared<BakeOptions>();
    Command command{"swatch", "draw only the pictures of scenes", shared_options(*options), {}};
    command.footer =
        "\nOf a scene that has no swatches, and of each LUT that --only names, nacre draws the preview: a strip and "
        "an\n"
        "object in one picture. With --preview it draws that of every LUT.\n\nExample:\n  nacre swatch "
        "configs/scenes/morpho.toml -o out --only morpho_plane\n";
    command.run = [options](Console& console) { return run_bake(*options, false, console); };
    return command;
}

}  // namespace nacre
