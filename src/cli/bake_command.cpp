#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/bake_task.h"
#include "cli/commands.h"
#include "cli/report.h"
#include "cli/stop_signal.h"
#include "io/image/font.h"
#include "nacre/base/error.h"
#include "nacre/base/names.h"
#include "nacre/lut/job.h"
#include "nacre/lut/planned_lut.h"
#include "nacre/scene/output_names.h"

namespace nacre {
namespace {

// Files that are made durable together: one flush of the disk for so many, and never more of them half-way.
constexpr std::size_t files_per_commit = 512;

struct BakeOptions {
    std::vector<std::string> scenes;
    std::string folder = ".";
    std::vector<std::string> only;
    std::string ocio;
    std::string shard;
    double accuracy = 0.0;
    std::string effects;
    int threads = 0;
    bool best_effort = false;
    bool force = false;
    bool strict = false;
    bool dry_run = false;
};

std::vector<BakeTask> list_tasks(const std::vector<LoadedScene>& scenes, bool with_luts) {
    std::vector<BakeTask> tasks;
    for (const LoadedScene& scene : scenes) {
        if (with_luts) {
            for (const PlannedLut& lut : scene.plan.luts) tasks.push_back({&scene, &lut, nullptr, 0, nullptr});
        }
        for (std::size_t i = 0; i < scene.plan.swatches.size(); ++i)
            tasks.push_back({&scene, nullptr, &scene.plan.swatches[i], i, nullptr});
    }
    return tasks;
}

// "I/N", 1 <= I <= N: every N-th task, beginning with the I-th.
void keep_shard(std::vector<BakeTask>& tasks, const std::string& shard) {
    if (shard.empty()) return;
    unsigned index = 0;
    unsigned count = 0;
    char rest = 0;
    if (std::sscanf(shard.c_str(), "%6u/%6u%c", &index, &count, &rest) != 2 || index < 1 || index > count) {
        throw Error("--shard " + shard + ": is no shard; give I/N with 1 <= I <= N");
    }
    std::vector<BakeTask> kept;
    for (std::size_t i = index - 1; i < tasks.size(); i += count) kept.push_back(tasks[i]);
    tasks = std::move(kept);
}

// The tasks' LUTs, as many and in the same order.
std::vector<SettledTask> settle_luts(std::vector<BakeTask>& tasks, int threads, Console& console) {
    std::vector<SettledTask> settled;
    for (const BakeTask& task : tasks) {
        if (task.lut == nullptr) continue;
        SettledTask& next = settled.emplace_back();
        next.scene = task.scene;
        next.asked = task.lut;
    }
    settle_all(settled, threads, console);
    auto next = settled.cbegin();
    for (BakeTask& task : tasks) {
        if (task.lut != nullptr) task.settled = &*next++;
    }
    return settled;
}

int report_dry_run(const std::vector<BakeTask>& tasks, Console& console) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const BakeTask& task : tasks) {
        const auto files = task.lut != nullptr ? output_files(*task.lut) : output_files(*task.swatch);
        console.summary("would write " + comma_separated(files) +
                        (task.lut != nullptr ? "  " + size_text(task.settled->lut.lut.job) : ""));
        json.push_back({{"files", files}});
    }
    if (console.json()) console.result_json({{"would_write", json}});
    return exit_done;
}

// What all tasks together came to.
struct Tally {
    nlohmann::ordered_json luts = nlohmann::ordered_json::array();
    nlohmann::ordered_json swatches = nlohmann::ordered_json::array();
    nlohmann::ordered_json failures = nlohmann::ordered_json::array();
    std::size_t outside_gamut = 0;
    bool misses_bound = false;

    void add(const BakeTask& task, const BakeOutcome& outcome, Console& console) {
        misses_bound = misses_bound || outcome.misses_bound;
        if (!outcome.failure.empty()) {
            console.error(outcome.failure);
            failures.push_back(outcome.failure);
            return;
        }
        console.summary(outcome.line);
        if (!outcome.warning.empty()) console.warning(outcome.warning);
        outside_gamut += outcome.outside_gamut > 0 && task.scene->plan.colour.gamut == Gamut::keep ? 1 : 0;
        if (console.json()) (task.lut != nullptr ? luts : swatches).push_back(outcome.json);
    }

    int report(Console& console) const {
        if (outside_gamut > 0) {
            console.warning(std::to_string(outside_gamut) + (outside_gamut == 1 ? " LUT has" : " LUTs have") +
                            " negative components, because the colour lies outside the target's gamut; [colour] gamut "
                            "= \"clip\" or "
                            "\"compress\" removes them, a wider space keeps the colour");
        }
        if (console.json()) console.result_json({{"luts", luts}, {"swatches", swatches}, {"failures", failures}});
        if (misses_bound) return exit_not_verified;
        return failures.empty() ? exit_done : exit_some_failed;
    }
};

int bake_tasks(const std::vector<BakeTask>& tasks, const BakeOptions& options, Console& console) {
    const bool any_picture =
        std::any_of(tasks.begin(), tasks.end(), [](const BakeTask& task) { return task.draws_picture(); });
    const auto font = any_picture ? find_font() : std::filesystem::path();
    OutputFolder folder(options.folder);
    prepare_encoder();
    const BakeTarget target{folder, font, options.force, options.best_effort};
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    Tally tally;
    std::atomic<std::size_t> done = 0;
    for (std::size_t begin = 0; begin < tasks.size(); begin += files_per_commit) {
        const std::size_t end = std::min(begin + files_per_commit, tasks.size());
        std::vector<BakeOutcome> outcomes(end - begin);
        arena.execute([&] {
            tbb::parallel_for(begin, end, [&](std::size_t i) {
                throw_if_stopped();
                outcomes[i - begin] = run_bake_task(tasks[i], target);
                console.progress(++done, tasks.size());
            });
        });
        throw_if_stopped();
        folder.commit();
        for (std::size_t i = begin; i < end; ++i) tally.add(tasks[i], outcomes[i - begin], console);
    }
    return tally.report(console);
}

int run_bake(const BakeOptions& options, bool with_luts, Console& console) {
    std::vector<LoadedScene> scenes =
        load_scenes(options.scenes, options.ocio, true, options.only, options.strict, console);
    if (with_luts) override_accuracy(scenes, options.accuracy, options.effects);
    std::vector<BakeTask> tasks = list_tasks(scenes, with_luts);
    keep_shard(tasks, options.shard);
    if (tasks.empty() && !with_luts && options.only.empty() && options.shard.empty())
        throw Error("the scenes have no [swatch.NAME]; add one");
    const std::vector<SettledTask> settled = settle_luts(tasks, options.threads, console);
    const std::size_t out_of_reach = report_out_of_reach(settled, options.best_effort, console);
    if (out_of_reach > 0 && !options.best_effort) {
        console.error("nothing was written; --best-effort writes the best there is");
        return exit_not_verified;
    }
    return options.dry_run ? report_dry_run(tasks, console) : bake_tasks(tasks, options, console);
}

void declare_common(CLI::App& app, BakeOptions& options) {
    app.add_option("SCENE", options.scenes, "scene files (TOML)")->required()->type_name("");
    app.add_option("-o,--output", options.folder, "folder for the files; made if it is missing")
        ->type_name("DIR")
        ->capture_default_str();
    app.add_option("--only", options.only, "only the LUT or swatch of this name; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    app.add_option("--ocio", options.ocio, "OpenColorIO config; wins over the scene's, which wins over $OCIO")
        ->type_name("FILE");
    app.add_option("--threads", options.threads, "threads at once; 0: one per core")
        ->type_name("N")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    add_strict_option(app, options.strict);
    app.add_flag("--force", options.force, "write files that are up to date as well");
    app.add_flag("--dry-run", options.dry_run, "say which files would be written, and stop");
}

}  // namespace

Command add_bake_command(CLI::App& app) {
    const auto options = std::make_shared<BakeOptions>();
    declare_common(app, *options);
    add_accuracy_option(app, options->accuracy);
    add_effects_option(app, options->effects);
    app.add_flag("--best-effort", options->best_effort,
                 "write LUTs whose bound is out of reach too, as good as they get");
    app.add_option("--shard", options->shard, "only every N-th LUT and swatch, from the I-th on; for farms")
        ->type_name("I/N");
    app.footer(
        "\nExit code 4 if a bound that you gave is out of reach; then nothing is written. The default, 0.1, is a "
        "goal.\n\nExample:\n"
        "  nacre bake configs/scenes/morpho.toml configs/scenes/beetle.toml -o out --accuracy 0.5\n");
    return [options](Console& console) { return run_bake(*options, true, console); };
}

Command add_swatch_command(CLI::App& app) {
    const auto options = std::make_shared<BakeOptions>();
    declare_common(app, *options);
    app.footer("\nExample:\n  nacre swatch configs/scenes/morpho.toml -o out --only morpho_plane\n");
    return [options](Console& console) { return run_bake(*options, false, console); };
}

}  // namespace nacre
